/// One cell of a banded volume, cut by base and cut field into boxes, tetrahedra and faces. cut_volume.h describes the
/// method; cut_volume.cpp alone includes this. Not for the haptic thread.
#pragma once

#include <array>
#include <cmath>

#include "engine/volume/cell_field.h"
#include "engine/volume/cut_volume.h"
#include "engine/volume/sharp_edge.h"

namespace cusp::engine::cell_cutter {

/// A corner of a tetrahedron with both fields in voxels, signed so that the kept side is negative.
struct Corner {
  Vec3 p;
  double base;  // negative in the specimen
  double cut;   // negative in the void that a bur left
};

inline Corner between(const Corner& a, const Corner& b, double Corner::* field) noexcept {
  const double t = a.*field / (a.*field - b.*field);
  return {a.p + t * (b.p - a.p), a.base + t * (b.base - a.base), a.cut + t * (b.cut - a.cut)};
}

/// Cuts a tetrahedron where `field` is 0. `solid` receives tetrahedra of the negative side, `section` the section's 3
/// or 4 corners in order round it.
template <class Solid, class Section>
void clip(const std::array<Corner, 4>& t, double Corner::* field, Solid&& solid, Section&& section) {
  std::array<int, 4> in{}, out{};
  int ins = 0, outs = 0;
  for (int i = 0; i < 4; ++i) {
    if (t[static_cast<std::size_t>(i)].*field < 0.0)
      in[static_cast<std::size_t>(ins++)] = i;
    else
      out[static_cast<std::size_t>(outs++)] = i;
  }
  const auto at = [&t](int i) -> const Corner& { return t[static_cast<std::size_t>(i)]; };
  const auto prism = [&solid](const Corner& a0, const Corner& a1, const Corner& a2, const Corner& b0, const Corner& b1,
                              const Corner& b2) {
    solid(std::array<Corner, 4>{a0, a1, a2, b2});
    solid(std::array<Corner, 4>{a0, a1, b1, b2});
    solid(std::array<Corner, 4>{a0, b0, b1, b2});
  };
  if (ins == 4) {
    solid(t);
  } else if (ins == 1) {
    const Corner& a = at(in[0]);
    const std::array<Corner, 4> s{between(a, at(out[0]), field), between(a, at(out[1]), field),
                                  between(a, at(out[2]), field), a};
    solid(s);
    section(std::array<Corner, 4>{s[0], s[1], s[2], s[2]}, 3);
  } else if (ins == 3) {
    const Corner& a = at(out[0]);
    const Corner b = between(at(in[0]), a, field);
    const Corner c = between(at(in[1]), a, field);
    const Corner d = between(at(in[2]), a, field);
    prism(at(in[0]), at(in[1]), at(in[2]), b, c, d);
    section(std::array<Corner, 4>{b, c, d, d}, 3);
  } else if (ins == 2) {
    const Corner& a = at(in[0]);
    const Corner& b = at(in[1]);
    const Corner ac = between(a, at(out[0]), field);
    const Corner ad = between(a, at(out[1]), field);
    const Corner bc = between(b, at(out[0]), field);
    const Corner bd = between(b, at(out[1]), field);
    prism(a, ac, ad, b, bc, bd);
    section(std::array<Corner, 4>{ac, ad, bd, bc}, 4);
  }
}

inline double tetrahedron_mm3(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept {
  return std::fabs(glm::dot(b - a, glm::cross(c - a, d - a))) / 6.0;
}

inline void emit_solid(const std::array<Corner, 4>& t, Tissue tissue, SolidSink& sink) {
  const double mm3 = tetrahedron_mm3(t[0].p, t[1].p, t[2].p, t[3].p);
  if (mm3 > 0.0) sink.tetrahedron({t[0].p, t[1].p, t[2].p, t[3].p}, mm3, tissue);
}
inline void emit_face(const std::array<Corner, 4>& c, int corners, Tissue tissue, SolidSink& sink) {
  for (std::size_t i = 2; i < static_cast<std::size_t>(corners); ++i) {
    const double mm2 = 0.5 * glm::length(glm::cross(c[i - 1].p - c[0].p, c[i].p - c[0].p));
    if (mm2 > 0.0) sink.face({c[0].p, c[i - 1].p, c[i].p}, mm2, tissue);
  }
}

/// No surface crosses a cell whose corners are all further from it than this, in voxels. Between corners the surface of
/// the least resolved radius (3 voxels) rises by at most 0.25 (diagonal sqrt 3, sagitta d²/8r = 0.125).
inline constexpr double kNearVoxels = 0.3;

/// Cells that bend more are searched for an edge. kMostOff: difference of their corners from two faces, summed. Both in
/// voxels.
inline constexpr double kBent = 0.2, kMostOff = 1.6;
/// Normals that differ by less are no edge: cosine of 45 degrees.
inline constexpr double kEdgeCosine = 0.7;

/// One field on the 27 half-voxel lattice places of a cell, and its means over the octants.
class Lattice {
 public:
  void fill(double value) noexcept {
    constant_ = true;
    value_ = value;
  }
  void sample(const CellField& field, double sign) noexcept {
    constant_ = edge_ = false;
    field_ = &field;
    sign_ = sign;
    Vec3 g;
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
          at_[static_cast<std::size_t>(i + 3 * (j + 3 * k))] = sign * field.eval(Vec3(i, j, k) * 0.5, g);
  }
  /// For a cell with a sharp edge: distances to the two faces that meet there instead of the field's. distance: of a
  /// place in fractions of the cell.
  template <class Distance>
  void sample_edge(const Distance& distance) noexcept {
    constant_ = false;
    edge_ = true;
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) at_[static_cast<std::size_t>(i + 3 * (j + 3 * k))] = distance(Vec3(i, j, k) * 0.5);
  }
  double at(IVec3 l) const noexcept {
    return constant_ ? value_ : at_[static_cast<std::size_t>(l.x + 3 * (l.y + 3 * l.z))];
  }
  /// Shift of an octant's corners that makes the mean of the six linear tetrahedra the field's own mean. A quadratic's
  /// mean is two thirds of the centre and a third of the corners' mean. 0 if no surface crosses.
  double shift(const std::array<double, 8>& corner, IVec3 octant) const noexcept {
    if (constant_ || edge_) return 0.0;
    double sum = 0.0, least = corner[0], most = corner[0];
    for (const double c : corner) {
      sum += c;
      least = c < least ? c : least;
      most = c > most ? c : most;
    }
    if (least > 0.25 || most < -0.25) return 0.0;
    Vec3 g;
    const double centre = sign_ * field_->eval(Vec3(octant) * 0.5 + 0.25, g);
    const double linear = (corner[0] + corner[7]) / 4.0 + (sum - corner[0] - corner[7]) / 12.0;
    return (2.0 * centre + sum / 8.0) / 3.0 - linear;
  }

 private:
  bool constant_ = true, edge_ = false;
  double value_ = 0, sign_ = 1;
  const CellField* field_ = nullptr;
  std::array<double, 27> at_{};
};

/// Paths from the first corner (its voxel) to the last (the cell's centre) of an octant, bit a = axis a.
inline constexpr std::array<std::array<std::size_t, 4>, 6> kTetrahedra = {
    {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};

class CellCutter {
 public:
  CellCutter(const Specimen& specimen, const Volume* volume, SolidSink& sink)
      : specimen_(specimen), volume_(volume), sink_(sink) {}

  void cell(IVec3 cell) {
    const int brick = brick_of(cell);
    const Range base = base_range(cell, brick), cut = cut_range(cell, brick);
    if (base.least > kNearVoxels || cut.least > kNearVoxels) return;
    const Grid& grid = specimen_.grid();
    low_ = grid.centre_mm(cell);
    half_mm_ = 0.5 * grid.voxel_mm;
    sink_.cell(low_, low_ + grid.voxel_mm);
    for (int i = 0; i < 8; ++i)
      tissue_[static_cast<std::size_t>(i)] = specimen_.tissue(cell + IVec3(i & 1, i >> 1 & 1, i >> 2));
    if (base.most < -kNearVoxels && cut.most < -kNearVoxels) {
      whole_cell();
      return;
    }
    fill_empty_tissues(cell);
    base_.fill(base.most);
    if (base.most >= -kNearVoxels) {
      base_field_.load(specimen_, cell);
      base_.sample(base_field_, 1.0);
    }
    cut_.fill(cut.most);
    if (cut.most >= -kNearVoxels) {
      cut_field_.load(*volume_, Field::cut, cell);
      cut_.sample(cut_field_, -1.0);
      if (cut_field_.crossed() && cut_field_.most_bent() > kBent) sample_cut_edge(cell);
    }
    for (int o = 0; o < 8; ++o) octant(o);
  }

 private:
  /// Least and largest corner of a field, signed as in Corner.
  struct Range {
    double least, most;
  };
  /// Of the distances of eight voxels; sign turns the cut's. A distance falls as s rises.
  static Range range_of(std::uint16_t least_s, std::uint16_t most_s, double sign) noexcept {
    const double low = sign * distance_from_solid(sign > 0.0 ? most_s : least_s);
    return {low, sign * distance_from_solid(sign > 0.0 ? least_s : most_s)};
  }
  template <class SolidAt>
  static Range range_at(IVec3 cell, SolidAt&& s_at, double sign) noexcept {
    std::uint16_t least = kSolid, most = 0;
    for (int i = 0; i < 8; ++i) {
      const std::uint16_t s = s_at(cell + IVec3(i & 1, i >> 1 & 1, i >> 2));
      least = s < least ? s : least;
      most = s > most ? s : most;
    }
    return range_of(least, most, sign);
  }
  /// Of a cell within one brick: `values` are the brick's, or nullptr where all are `uniform`.
  static Range range_in(IVec3 cell, const std::uint16_t* values, std::uint16_t uniform, double sign) noexcept {
    if (values == nullptr) return range_of(uniform, uniform, sign);
    return range_at(cell, [values](IVec3 v) { return values[brick_offset(v.x & 7, v.y & 7, v.z & 7)]; }, sign);
  }
  /// The brick that holds all eight voxels of a cell; -1 where there is none.
  int brick_of(IVec3 cell) const noexcept {
    const bool one = (cell.x & 7) < 7 && (cell.y & 7) < 7 && (cell.z & 7) < 7;
    return one ? specimen_.brick_index({cell.x >> 3, cell.y >> 3, cell.z >> 3}) : -1;
  }
  Range base_range(IVec3 cell, int brick) const noexcept {
    if (brick >= 0) return range_in(cell, specimen_.s_of(brick), specimen_.s_in(brick, 0), 1.0);
    return range_at(cell, [this](IVec3 v) { return specimen_.s(v); }, 1.0);
  }
  Range cut_range(IVec3 cell, int brick) const noexcept {
    if (volume_ == nullptr) return {-kBandVoxels, -kBandVoxels};
    if (brick >= 0) return range_in(cell, volume_->cut_of(brick), kSolid, -1.0);
    return range_at(cell, [this](IVec3 v) { return volume_->cut(v); }, -1.0);
  }
  /// A cell that no surface crosses: one box, or one for each octant if tissues differ.
  void whole_cell() {
    bool one_tissue = true;
    for (const Tissue t : tissue_) one_tissue = one_tissue && t == tissue_[0];
    if (one_tissue) {
      sink_.box(low_, low_ + specimen_.grid().voxel_mm, tissue_[0]);
    } else {
      for (int o = 0; o < 8; ++o) octant_box(o);
    }
  }
  /// The cut field's samples with the sign of the base field: positive outside the tissue.
  void load_turned(IVec3 cell, CellField& to) const {
    std::array<double, 64> d;
    for (int i = 0; i < 64; ++i)
      d[static_cast<std::size_t>(i)] = -distance_from_solid(volume_->cut(cell - 1 + IVec3(i & 3, i >> 2 & 3, i >> 4)));
    to.load(d.data(), 4, 16);
  }
  /// A head's rim or corner leaves a sharp edge. The field rounds it; the faces beside it do not.
  void sample_cut_edge(IVec3 cell) {
    CellField turned;
    load_turned(cell, turned);
    const auto load = [&](IVec3 offset, CellField& to) {
      load_turned(cell + offset, to);
      return true;
    };
    const Creased crease = creased(turned, kMostOff, load, CreaseSearch::every_cell);
    if (crease.kind == Creased::Kind::face) {
      if (glm::dot(crease.normal, crease.other_normal) > kEdgeCosine) return;
      cut_.sample_edge([&](Vec3 f) {
        const Vec3 off = f - crease.point;
        return std::fmax(glm::dot(crease.normal, off), crease.other_d + glm::dot(crease.other_normal, off));
      });
      return;
    }
    if (crease.kind != Creased::Kind::edge || crease.sides == 0) return;
    if (glm::dot(crease.side[0].normal, crease.side[0].other_normal) > kEdgeCosine) return;
    const Vec3 a = crease.side[0].normal, b = crease.side[0].other_normal;
    cut_.sample_edge([&](Vec3 f) {
      const double t = glm::dot(f - crease.edge.at, crease.edge.tangent);
      const Vec3 off = f - (crease.edge.at + crease.edge.tangent * t + crease.edge.bend * (t * t));
      return std::fmax(glm::dot(a, off), glm::dot(b, off));
    });
  }
  void octant_box(int o) {
    const Vec3 low = low_ + half_mm_ * Vec3(o & 1, o >> 1 & 1, o >> 2);
    sink_.box(low, low + half_mm_, tissue_[static_cast<std::size_t>(o)]);
  }
  /// A voxel outside the band has no tissue of its own. A corrected field can still reach into its octant.
  void fill_empty_tissues(IVec3 cell) {
    int best = -1;
    Tissue tissue = Tissue::empty;
    for (int i = 0; i < 8; ++i) {
      const int s = specimen_.s(cell + IVec3(i & 1, i >> 1 & 1, i >> 2));
      if (s > best && tissue_[static_cast<std::size_t>(i)] != Tissue::empty) {
        best = s;
        tissue = tissue_[static_cast<std::size_t>(i)];
      }
    }
    for (Tissue& t : tissue_)
      if (t == Tissue::empty) t = tissue;
  }
  void octant(int o) {
    const IVec3 which(o & 1, o >> 1 & 1, o >> 2);
    std::array<double, 8> base{}, cut{};
    std::array<Corner, 8> corner;
    bool all_in = true, base_out = true, cut_out = true;
    for (int i = 0; i < 8; ++i) {
      // Local bit 0 is the voxel's side, 1 the cell's centre.
      const IVec3 bits(i & 1, i >> 1 & 1, i >> 2);
      const IVec3 l = which * 2 + bits * (1 - 2 * which);
      const auto n = static_cast<std::size_t>(i);
      base[n] = base_.at(l);
      cut[n] = cut_.at(l);
      corner[n].p = low_ + half_mm_ * Vec3(l);
    }
    const double base_shift = base_.shift(base, which);
    const double cut_shift = cut_.shift(cut, which);
    for (std::size_t n = 0; n < 8; ++n) {
      corner[n].base = base[n] + base_shift;
      corner[n].cut = cut[n] + cut_shift;
      all_in = all_in && corner[n].base < 0.0 && corner[n].cut < 0.0;
      base_out = base_out && corner[n].base >= 0.0;
      cut_out = cut_out && corner[n].cut >= 0.0;
    }
    if (base_out || cut_out) return;
    if (all_in) {
      octant_box(o);
      return;
    }
    const Tissue tissue = tissue_[static_cast<std::size_t>(o)];
    for (const auto& path : kTetrahedra)
      tetrahedron({corner[path[0]], corner[path[1]], corner[path[2]], corner[path[3]]}, tissue);
  }
  /// Without a volume: the specimen's part and its surface. Else the part that was removed and the surface that the cut
  /// left.
  void tetrahedron(const std::array<Corner, 4>& t, Tissue tissue) {
    const auto solid = [&](const std::array<Corner, 4>& inside) { emit_solid(inside, tissue, sink_); };
    const auto section = [&](const std::array<Corner, 4>& c, int corners) { emit_face(c, corners, tissue, sink_); };
    if (volume_ == nullptr) {
      clip(t, &Corner::base, solid, section);
    } else {
      clip(
          t, &Corner::base, [&](const std::array<Corner, 4>& inside) { clip(inside, &Corner::cut, solid, section); },
          [](const std::array<Corner, 4>&, int) {});
    }
  }

  const Specimen& specimen_;
  const Volume* volume_;
  SolidSink& sink_;
  Vec3 low_{0.0};
  double half_mm_ = 0;
  std::array<Tissue, 8> tissue_{};
  CellField base_field_, cut_field_;
  Lattice base_, cut_;
};

}  // namespace cusp::engine::cell_cutter
