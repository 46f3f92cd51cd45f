/// The trilinear field of one cell, corrected by its second differences, so that a quadratic is exact. A distance is
/// then known a thousand times finer than a voxel. Wait-free; only + - * / and comparisons. A second difference whose
/// stencil touches a clamped sample is not used. Of two that differ by more than 0.2 voxel the smaller is taken
/// (essentially non-oscillatory). A crease then does not reach into its neighbour.
#pragma once

#include <cmath>

#include "engine/base/lanes.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

/// Which of the two fields of a volume.
enum class Field : std::uint8_t { base, cut };

/// Distance in voxels at a voxel's centre; positive outside the tissue (base) or inside the cut (cut).
inline double field_sample(const Volume& volume, Field field, IVec3 v) noexcept {
  return distance_from_solid(field == Field::base ? volume.specimen().s(v) : volume.cut(v));
}

class CellField {
 public:
  /// Cell (i,j,k) lies between the voxel centres (i,j,k) and (i+1,j+1,k+1). Reads the 32 samples round it.
  void load(const Volume& volume, Field field, IVec3 cell) noexcept {
    const Specimen& specimen = volume.specimen();
    if (field == Field::base) return load(specimen, cell);
    fill(cell, specimen, [&](int brick) {
      return brick < 0 ? Source{nullptr, kSolid} : Source{volume.cut_of(brick), kSolid};
    });
  }
  /// The base field of a specimen alone.
  void load(const Specimen& specimen, IVec3 cell) noexcept {
    fill(cell, specimen, [&](int brick) {
      return brick < 0 ? Source{nullptr, 0} : Source{specimen.s_of(brick), specimen.s_in(brick, 0)};
    });
  }
  /// From samples decoded beforehand: `low` is the one at cell - (1,1,1), rows stride_y apart, slices stride_z.
  void load(const double* low, int stride_y, int stride_z) noexcept {
    for (const Row& row : kRows) {
      const double* from = low + row.y * stride_y + row.z * stride_z;
      double* to = &d_[4 * (row.y + 4 * row.z)];
      for (int x = 0; x < 4; ++x) to[x] = from[x];
    }
    correct();
  }

  /// Second derivatives at f, per voxel: xx, yy, zz by the second differences, xy, xz, yz by the trilinear part.
  void hessian(Vec3 f, double (&diagonal)[3], double (&mixed)[3]) const noexcept {
    const auto over = [](const double* e, double fb, double fc) {
      const double low = e[0] + fb * (e[1] - e[0]), high = e[2] + fb * (e[3] - e[2]);
      return low + fc * (high - low);
    };
    diagonal[0] = over(second_[0], f.y, f.z);
    diagonal[1] = over(second_[1], f.x, f.z);
    diagonal[2] = over(second_[2], f.x, f.y);
    const auto twist = [&](int a, int b, int c, double along_c) {
      const double low = corner(a | b) - corner(a) - corner(b) + corner(0);
      const double high = corner(a | b | c) - corner(a | c) - corner(b | c) + corner(c);
      return low + along_c * (high - low);
    };
    mixed[0] = twist(1, 2, 4, f.z);
    mixed[1] = twist(1, 4, 2, f.y);
    mixed[2] = twist(2, 4, 1, f.x);
  }
  /// The samples round the cell bend outwards on one side and not on the other: an outer edge passes close by.
  bool crease_near() const noexcept { return crease_near_; }
  /// True if the field rounds an inner edge. It is no distance then: its gradient's length differs from 1 at a corner.
  /// The rounding fills the edge by up to half a voxel.
  bool rounds_inner_edge() const noexcept {
    if (!inner_edge_near_) return false;
    Vec3 gradient;
    for (int i = 0; i < 8; ++i) {
      eval(Vec3(i & 1, i >> 1 & 1, i >> 2), gradient);
      if (std::fabs(std::sqrt(glm::dot(gradient, gradient)) - 1.0) > kSteepness) return true;
    }
    return false;
  }
  /// Largest second difference, voxels.
  double most_bent() const noexcept {
    double most = 0.0;
    for (const auto& axis : second_)
      for (const double e : axis) most = std::fabs(e) > most ? std::fabs(e) : most;
    return most;
  }
  /// Distance at a sample, from the lower corner: -1 to 2 each, one of them outside 0 and 1 at most.
  double sample(int x, int y, int z) const noexcept { return d_[kFirstCorner + x + 4 * y + 16 * z]; }
  /// Distance at corner i: bits of i are x, y, z.
  double at_corner(int i) const noexcept { return corner(i); }
  /// True if the surface d = 0 passes between the corners.
  bool crossed() const noexcept {
    const bool first = corner(0) > 0.0;
    for (int i = 1; i < 8; ++i)
      if ((corner(i) > 0.0) != first) return true;
    return false;
  }
  /// True if every corner is inside the band, so that d is a distance and not a bound.
  bool in_band() const noexcept {
    for (int i = 0; i < 8; ++i)
      if (clamped(corner(i))) return false;
    return true;
  }

  /// Mean of the corners, and the gradient of the plane that fits them best.
  double mean_plane(Vec3& gradient) const noexcept {
    double sum = 0.0;
    Vec3 g(0.0);
    for (int i = 0; i < 8; ++i) {
      const double d = corner(i);
      sum += d;
      g.x += (i & 1) ? d : -d;
      g.y += (i & 2) ? d : -d;
      g.z += (i & 4) ? d : -d;
    }
    gradient = 0.25 * g;
    return 0.125 * sum;
  }

  /// Distance in voxels at f (fraction of the cell, a little outside [0,1] is allowed) and its gradient (voxel/voxel).
  double eval(Vec3 f, Vec3& gradient) const noexcept {
    const double* v = &d_[kFirstCorner];
    // Trilinear part: along x, then y, then z; differences of the same steps are its gradient.
    const double dx00 = v[1] - v[0], dx10 = v[5] - v[4], dx01 = v[17] - v[16], dx11 = v[21] - v[20];
    const double x00 = v[0] + f.x * dx00, x10 = v[4] + f.x * dx10;
    const double x01 = v[16] + f.x * dx01, x11 = v[20] + f.x * dx11;
    const double dy0 = x10 - x00, dy1 = x11 - x01;
    const double y0 = x00 + f.y * dy0, y1 = x01 + f.y * dy1;
    const double dz = y1 - y0;
    const double dx0 = dx00 + f.y * (dx10 - dx00), dx1 = dx01 + f.y * (dx11 - dx01);
    double d = y0 + f.z * dz;
    Vec3 g(dx0 + f.z * (dx1 - dx0), dy0 + f.z * (dy1 - dy0), dz);
    // Second differences along each axis, blended over its four edges.
    correction(second_[0], f.x, f.y, f.z, d, g.x, g.y, g.z);
    correction(second_[1], f.y, f.x, f.z, d, g.y, g.x, g.z);
    correction(second_[2], f.z, f.x, f.y, d, g.z, g.x, g.y);
    gradient = g;
    return d;
  }

 private:
  /// A brick's samples: 512 values, or one for all.
  struct Source {
    const std::uint16_t* values = nullptr;
    std::uint16_t uniform = 0;
  };
  struct Row {
    int y, z, first, end;
  };
  static constexpr Row kRows[12] = {{1, 0, 1, 3}, {2, 0, 1, 3}, {0, 1, 1, 3}, {1, 1, 0, 4}, {2, 1, 0, 4}, {3, 1, 1, 3},
                                    {0, 2, 1, 3}, {1, 2, 0, 4}, {2, 2, 0, 4}, {3, 2, 1, 3}, {1, 3, 1, 3}, {2, 3, 1, 3}};
  template <class BrickSource>
  void fill(IVec3 cell, const Specimen& specimen, BrickSource&& source_of) noexcept {
    const IVec3 low = cell - 1;
    const IVec3 first(low.x >> 3, low.y >> 3, low.z >> 3);
    const IVec3 over((low.x & 7) > 4, (low.y & 7) > 4, (low.z & 7) > 4);  // reaches into the next brick
    Source source[8];
    for (int i = 0; i < 8; ++i) {
      const IVec3 o(i & 1, i >> 1 & 1, i >> 2);
      if (o.x > over.x || o.y > over.y || o.z > over.z) continue;
      source[i] = source_of(specimen.brick_index(first + o));
    }
    // Rows along x; the corners and edges of the 4^3 block are read by no stencil.
    const int lx = low.x & 7;
    for (const Row& row : kRows) {
      const int vy = (low.y & 7) + row.y;
      const int vz = (low.z & 7) + row.z;
      const Source* from = &source[(vy >> 3) * 2 + (vz >> 3) * 4];
      const int offset = (vy & 7) << 3 | (vz & 7) << 6;
      double* to = &d_[4 * (row.y + 4 * row.z)];
      if (lx <= 4) {
        const std::uint16_t* values = from->values;
        for (int x = 0; x < 4; ++x) to[x] = distance_from_solid(values ? values[offset + lx + x] : from->uniform);
      } else {
        for (int x = row.first; x < row.end; ++x) {
          const Source& one = from[(lx + x) >> 3];
          to[x] = distance_from_solid(one.values ? one.values[offset | ((lx + x) & 7)] : one.uniform);
        }
      }
    }
    correct();
  }
  /// d -= t(1-t)/2 of the second difference along one axis; e: [q + 2 r] at the edges q along b, r along c.
  static void correction(const double* e, double t, double fb, double fc, double& d, double& along, double& along_b,
                         double& along_c) noexcept {
    const double b0 = e[1] - e[0], b1 = e[3] - e[2];
    const double c0 = e[0] + fb * b0, c1 = e[2] + fb * b1;
    const double mean = c0 + fc * (c1 - c0);
    const double w = -0.5 * t * (1.0 - t);
    d += w * mean;
    along += (t - 0.5) * mean;
    along_b += w * (b0 + fc * (b1 - b0));
    along_c += w * (c1 - c0);
  }
  static bool clamped(double d) noexcept { return d > kBandVoxels - 1e-4 || d < -kBandVoxels + 1e-4; }
  /// Of two edges along one axis, the second difference of each; samples from below the edge's first end to above its last.
  Pair blend(Pair low, Pair mid_a, Pair mid_b, Pair high, PairMask& outer, PairMask& inner) const noexcept {
    const PairMask a_ok = known(low), b_ok = known(high);
    const Pair a = low - 2.0 * mid_a + mid_b;
    const Pair b = mid_a - 2.0 * mid_b + high;
    const Pair gap = size_of(a - b), size_a = size_of(a), size_b = size_of(b);
    const PairMask a_flatter = size_a < size_b;
    const Pair flatter = a_flatter ? a : b, size = a_flatter ? size_a : size_b;
    const PairMask smooth = (gap <= kFlatGap) | ((gap <= kCreaseGap) & (size >= kFlat));
    const PairMask bent = a_ok & b_ok & ~smooth;
    outer |= bent & ((a > kOuterEdge) | (b > kOuterEdge));
    inner |= bent & ((a < -kOuterEdge) | (b < -kOuterEdge));
    const Pair one = a_ok ? a : b_ok ? b : Pair{};
    return a_ok & b_ok ? (smooth ? 0.5 * (a + b) : flatter) : one;
  }
  static PairMask known(Pair d) noexcept { return size_of(d) <= kBandVoxels - 1e-4; }
  static Pair size_of(Pair v) noexcept { return v < 0.0 ? -v : v; }
  void correct() noexcept {
    PairMask outer{}, inner{};
    // Places in d_: x, then 4 y, then 16 z. Two edges of an axis are `beside` apart, the other two `over` further on.
    constexpr int along[3] = {1, 4, 16}, beside[3] = {4, 1, 1}, over[3] = {16, 16, 4};
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 2; ++i) {
        const double* v = &d_[kFirstCorner + i * over[axis]];
        const auto at = [&](int step) { return Pair{v[step * along[axis]], v[step * along[axis] + beside[axis]]}; };
        const Pair second = blend(at(-1), at(0), at(1), at(2), outer, inner);
        second_[axis][2 * i] = second[0];
        second_[axis][2 * i + 1] = second[1];
      }
    crease_near_ = bits_of(outer) != 0;
    inner_edge_near_ = bits_of(inner) != 0;
  }
  double corner(int i) const noexcept { return d_[kFirstCorner + (i & 1) + (i >> 1 & 1) * 4 + (i >> 2) * 16]; }

  static constexpr int kFirstCorner = 1 + 4 + 16;

  /// Second differences (voxels) that differ by more have a crease on one side.
  static constexpr double kCreaseGap = 0.2;
  /// The same where one side is flat: a face beside an edge. A ball of three voxels has no such places.
  static constexpr double kFlatGap = 0.02, kFlat = 0.01;
  /// A second difference above this is an outer edge of 17 degrees or more; a flatter edge is rounded by less than 0.04
  /// voxel.
  static constexpr double kOuterEdge = 0.3;
  /// A gradient's length is 1 to this much at the corners of a cell of a hollow of 3.5 voxels: of its cubic.
  static constexpr double kSteepness = 0.05;

  double d_[64];
  double second_[3][4];
  bool crease_near_ = false, inner_edge_near_ = false;  // a sample's second difference shows an outer or inner edge
};

/// A place of the field: distance in mm and unit normal out of the tissue (or into the cut's void).
struct FieldPoint {
  double d_mm = 0.0;
  Vec3 normal{0.0, 0.0, 1.0};
  bool known = false;  // inside the band and with a gradient
  bool creased = false;  // an outer edge passes close by: rounded
  bool inner_edge = false;  // the cut's field rounds one there
};

/// The cell of a place in voxels: floor without a call into libm.
inline IVec3 cell_of_voxels(Vec3 x) noexcept {
  IVec3 cell(static_cast<int>(x.x), static_cast<int>(x.y), static_cast<int>(x.z));
  cell.x -= x.x < cell.x;
  cell.y -= x.y < cell.y;
  cell.z -= x.z < cell.z;
  return cell;
}

/// Cache of the cells of both fields that were read last: a polish loads the cell that it stays in once. The answers
/// are the field's. Thread: one.
class FieldCells {
 public:
  /// The corrected field at a place in mm.
  FieldPoint at(const Volume& volume, Field field, Vec3 at_mm) noexcept {
    const Grid& grid = volume.grid();
    const double per_mm = 1.0 / grid.voxel_mm;
    const Vec3 x = (at_mm - grid.origin_mm) * per_mm;
    const IVec3 cell = cell_of_voxels(x);
    Entry& e = entry_[(static_cast<unsigned>(cell.x) ^ static_cast<unsigned>(cell.y) << 1 ^
                       static_cast<unsigned>(cell.z) << 2 ^ (field == Field::cut ? 5u : 0u)) % kEntries];
    if (!e.valid || e.field != field || e.cell != cell) {
      e.values.load(volume, field, cell);
      e.in_band = e.values.in_band();
      e.inner_edge = field == Field::cut && e.values.rounds_inner_edge();
      e.valid = true;
      e.field = field;
      e.cell = cell;
    }
    FieldPoint out;
    Vec3 g;
    const double d = e.values.eval(x - Vec3(cell), g);
    out.d_mm = d * grid.voxel_mm;
    const double length = std::sqrt(g.x * g.x + g.y * g.y + g.z * g.z);
    out.creased = e.values.crease_near();
    out.inner_edge = e.inner_edge;
    if (e.in_band && length > 0.25) {
      out.normal = g / length;
      out.d_mm /= length;
      out.known = true;
    }
    return out;
  }
  /// To be called when the cut, or the whole volume, has changed.
  void forget_cut() noexcept {
    for (Entry& e : entry_) e.valid = e.valid && e.field != Field::cut;
  }

 private:
  static constexpr unsigned kEntries = 8;
  struct Entry {
    IVec3 cell{0};
    Field field = Field::base;
    bool valid = false, in_band = false, inner_edge = false;
    CellField values;
  };
  Entry entry_[kEntries];
};

/// The surface point of a crossed cell, in fractions of the cell, by Newton on the cell's own polynomial. The start is
/// the centre's foot on the corners' mean plane. The point stays within 0.6 voxel of the centre. False if d does not
/// come to 0 there.
inline bool cell_point(const CellField& field, Vec3& f, Vec3& normal, double* steepness = nullptr) noexcept {
  Vec3 g(0.0);
  const double middle = field.mean_plane(g);
  const double steep = g.x * g.x + g.y * g.y + g.z * g.z;
  f = Vec3(0.5);
  if (steep > 0.04) f -= g * (middle / steep);
  for (int a = 0; a < 3; ++a) f[a] = f[a] < -0.1 ? -0.1 : f[a] > 1.1 ? 1.1 : f[a];
  for (int pass = 0; pass < 6; ++pass) {
    const double d = field.eval(f, g);
    const double square = g.x * g.x + g.y * g.y + g.z * g.z;
    if (!(square > 0.04)) return false;
    const Vec3 to = f - g * (d / square);
    bool kept = true;
    for (int a = 0; a < 3; ++a) {
      f[a] = to[a] < -0.1 ? -0.1 : to[a] > 1.1 ? 1.1 : to[a];
      kept = kept && f[a] == to[a];
    }
    // Newton squares the error: from 3e-4 voxel the step just taken leaves less than 1e-8.
    if (std::fabs(d) < 3e-4 && kept) {
      const double length = std::sqrt(square);
      normal = g / length;
      if (steepness) *steepness = length;
      return true;
    }
  }
  const double d = field.eval(f, g);
  const double length = std::sqrt(g.x * g.x + g.y * g.y + g.z * g.z);
  if (!(length > 0.2) || std::fabs(d) > 0.02) return false;
  normal = g / length;
  if (steepness) *steepness = length;
  return true;
}

}  // namespace cusp::engine
