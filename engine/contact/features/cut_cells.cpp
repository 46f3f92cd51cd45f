// What a cell of a cut brick holds: the specimen's own points that are left, the cut's, and edges.
#include <algorithm>

#include "engine/contact/features/cut_surface.h"
#include "engine/volume/sharp_edge.h"

namespace cusp::engine {

namespace {
/// Two cuts make the larger of two distances, without rounding: what differs more is no ridge of two.
constexpr double kMostOff = 0.3;
/// Voxels: another surface this far from a point does not end its plane, which is believed 0.8 beside it.
constexpr double kBeside = 1.6;
const double kDeep = distance_from_solid(solid_from_distance(-kBeside));
/// The specimen so far out that none of it is in a cell whose corners all are: half a voxel.
const double kAir = distance_from_solid(solid_from_distance(0.5));
/// Voxels: where all corners of a cell are this far in the void, or in the tissue, its field is further than kShallow or
/// kBeside everywhere: second differences of samples within the band move it by no more than 3/8 of 2 and of 0.8 voxel, and
/// a tenth of a voxel outside the cell by 0.3 and 0.12 more.
constexpr double kTaken = 1.6, kUntouched = 2.2;
/// Voxels: a scratch up to this deep holds a cutting bur though no cell of the cut has it.
constexpr double kShallow = 0.15;
/// Voxels that the piece of a mouth's edge goes on beyond its cell, so that it meets the next.
constexpr double kBesideCell = 0.05;
/// Voxels: a head touches no deeper sample than it looks for points beside it.
constexpr double kDeepestInside = 0.8;

/// Another surface ends the plane of a point: of more than two, the nearest two.
void add_beside(CutFeature& point, double d_mm, Vec3f normal) noexcept {
  const auto d = static_cast<float>(d_mm);
  if (point.others == 0 || (point.others == 2 && point.other_d_mm <= point.third_d_mm && d > point.other_d_mm)) {
    point.other_d_mm = d;
    point.other_normal = normal;
    point.others = point.others == 0 ? 1 : 2;
  } else if (point.others == 1 || d > point.third_d_mm) {
    point.third_d_mm = d;
    point.third_normal = normal;
    point.others = 2;
  }
}

/// True if the signs differ of eight samples of a cell; side: from one row to the next.
bool signs_differ(const double* first, int side) noexcept {
  const bool inside = *first > 0.0;
  for (int i = 1; i < 8; ++i)
    if ((first[(i & 1) + (i >> 1 & 1) * side + (i >> 2) * side * side] > 0.0) != inside) return true;
  return false;
}

/// The tissue at a place of a cell (voxels), else of one of its corners.
Tissue tissue_under(const Volume& volume, IVec3 cell, Vec3 place) noexcept {
  Tissue tissue = volume.tissue(cell_of_voxels(Vec3(cell) + place + 0.5));
  for (int i = 0; i < 8 && tissue == Tissue::empty; ++i)
    tissue = volume.tissue(cell + IVec3(i & 1, i >> 1 & 1, i >> 2));
  return tissue;
}
}  // namespace

bool CutSurface::make_base(const Volume& volume, const BasePoints& points, int i, Part part) noexcept {
  if (made_count_ == made_.size()) return true;
  const bool resolved = part == Part::resolved;
  ++cells_made_;
  const int o = points.normal[i].cell();
  const IVec3 local(o & 7, o >> 3 & 7, o >> 6);
  const Vec3f place(points.x[i], points.y[i], points.z[i]);
  const double* low = &samples_[local.x + kSide * (local.y + kSide * local.z)];
  const double* corners = low + 1 + kSide + kSide * kSide;
  double least = corners[0], most = corners[0];
  for (int k = 1; k < 8; ++k) {
    const double d = corners[(k & 1) + (k >> 1 & 1) * kSide + (k >> 2) * kSide * kSide];
    least = d < least ? d : least;
    most = d > most ? d : most;
  }
  if (!resolved && least > kTaken) return false;
  Made& made = made_[made_count_];
  made = Made{};
  made.at = place;
  base_feature(volume.specimen().surface(), points, i, volume.grid().voxel_mm, made.feature);
  if (!resolved && most < -kUntouched) {
    ++made_count_;
    return false;
  }
  CellField cut;
  cut.load(low, kSide, kSide * kSide);
  Vec3 g;
  const double d = cut.eval(Vec3(place) - Vec3(local), g);
  const double length = std::sqrt(glm::dot(g, g));
  if (d > 0.0) {
    // The cut has taken it. A scratch so shallow that it takes no voxel's centre shows in no cell of the cut, and most of
    // the face about the point still stands: a bur that cuts on is held by the face as deep as the scratch has it there.
    if (!resolved && d < kShallow && length > 0.25 && !made.feature.edge) {
      made.at = Vec3f(Vec3(place) - Vec3(made.feature.normal) * (d / length));
      ++made_count_;
    }
    // Such a scratch is looked at again when it becomes unresolved.
    return resolved && (cut.crease_near() || d < kShallow);
  }
  if (d > -kBeside && length > 0.25 && !made.feature.edge)
    add_beside(made.feature, d * volume.grid().voxel_mm / length, Vec3f(g / length));
  ++made_count_;
  return resolved && cut.crease_near();
}

/// A cell in its brick.
struct CutSurface::Cell {
  IVec3 local{0}, at{0};  // in the brick, in the volume
  int offset = 0;
  double voxel_mm = 0.0;
};

/// What the specimen's own surface is to a cell.
struct CutSurface::BaseAbout {
  bool deep = true;  // so far from all corners that it ends no plane: nothing of it to keep
  bool air = false;  // there is nothing that a cut could have left
};

CutSurface::BaseAbout CutSurface::base_about(const Volume& volume, const Cell& cell, const double* corners) noexcept {
  const IVec3 at(cell.at.x >> 3, cell.at.y >> 3, cell.at.z >> 3), local = cell.local;
  const Specimen& specimen = volume.specimen();
  const int brick = specimen.brick_index(at);
  if (local.x < 7 && local.y < 7 && local.z < 7 && specimen.s_of(brick) == nullptr && specimen.s_in(brick, 0) == kSolid) return {};
  if (!base_ready_) decode_base(specimen, at);
  BaseAbout out{true, true};
  for (int i = 0; i < 8 && (out.deep || out.air); ++i) {
    const double d = corners[(i & 1) + (i >> 1 & 1) * kSide + (i >> 2) * kSide * kSide];
    out.deep = out.deep && d <= kDeep;
    out.air = out.air && d >= kAir;
  }
  return out;
}

/// Adds what a cell holds at a place of it.
CutFeature& CutSurface::add_feature(const Volume& volume, const Cell& cell, Vec3 place, Vec3 normal, Vec3 under) noexcept {
  Made& made = made_[made_count_++];
  made = Made{};
  made.at = Vec3f(Vec3(cell.local) + place);
  made.feature.normal = Vec3f(normal);
  made.feature.cell = static_cast<std::uint16_t>(cell.offset);
  made.feature.tissue = tissue_under(volume, cell.at, under);
  return made.feature;
}

void CutSurface::add_edge(const Volume& volume, const Cell& cell, const SharpEdge& edge) noexcept {
  CutFeature& out = add_feature(volume, cell, edge.at, edge.tangent, edge.at);
  out.other_normal = Vec3f(edge.bend / cell.voxel_mm);
  out.third_normal = Vec3f(edge.twist / (cell.voxel_mm * cell.voxel_mm));
  out.edge = true;
  out.third_d_mm = static_cast<float>(kHalfEdge * cell.voxel_mm);
  out.other_d_mm = -out.third_d_mm;
}

/// Where the cut meets the specimen's own surface. Beyond the cell the fields are continued, so the piece ends there.
void CutSurface::add_mouth(const Volume& volume, const Cell& cell, const SharpEdge& edge) noexcept {
  add_edge(volume, cell, edge);
  CutFeature& out = made_[made_count_ - 1].feature;
  double from = out.other_d_mm, to = out.third_d_mm;
  for (int a = 0; a < 3; ++a) {
    const double along = edge.tangent[a] / cell.voxel_mm;
    if (std::fabs(along) < 1e-3) continue;
    const double low = (-kBesideCell - edge.at[a]) / along, high = (1.0 + kBesideCell - edge.at[a]) / along;
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  out.other_d_mm = static_cast<float>(std::min(from, 0.0));
  out.third_d_mm = static_cast<float>(std::max(to, 0.0));
}

/// A field rounds an inner edge, but its samples in the tissue are distances to what was swept, and exact.
void CutSurface::add_insides(const Volume& volume, const Cell& cell, const CellField& cut, const CellField* base, Vec3 normal) noexcept {
  for (int i = 0; i < 8; ++i) {
    const double d = base == nullptr ? cut.at_corner(i) : std::max(cut.at_corner(i), base->at_corner(i));
    if (!(d < 0.0 && d > -kDeepestInside)) continue;
    const Vec3 at(i & 1, i >> 1 & 1, i >> 2);
    CutFeature& inside = add_feature(volume, cell, at, normal, at);
    inside.inside = true;
    inside.other_d_mm = static_cast<float>(-d * cell.voxel_mm);
  }
}

/// Loads the field of the cell o away. False if nothing crosses it.
bool CutSurface::load_beside(const Volume& volume, const Cell& cell, IVec3 o, CellField& to) noexcept {
  if (!wide_ready_) decode_wide(volume, {cell.at.x >> 3, cell.at.y >> 3, cell.at.z >> 3});
  const IVec3 there = cell.local + o + 2;  // the lowest sample that its field is made of
  const double* samples = &wide_[there.x + kWide * (there.y + kWide * there.z)];
  if (!signs_differ(samples + 1 + kWide + kWide * kWide, kWide)) return false;
  to.load(samples, kWide, kWide * kWide);
  return true;
}

/// Adds the cut's own place in a cell where the specimen is solid: a ridge between two cuts, a face beside one, or a point.
/// base: nullptr deep in the specimen.
void CutSurface::add_cut(const Volume& volume, const Cell& cell, const Creased& crease, const CellField& cut, const CellField* base) noexcept {
  Vec3 gradient(0.0);
  if (crease.kind == Creased::Kind::edge) {
    if (base == nullptr || base->eval(crease.edge.at, gradient) <= 0.0) add_edge(volume, cell, crease.edge);
    return;
  }
  if (crease.kind == Creased::Kind::face) {
    if (base != nullptr && !(base->eval(crease.point, gradient) <= 0.0)) return;
    CutFeature& face = add_feature(volume, cell, crease.point, crease.normal, crease.point - 0.5 * crease.normal);
    add_beside(face, crease.other_d * cell.voxel_mm, Vec3f(crease.other_normal));
    return;
  }
  // The cut's distance is positive in the void: its gradient points into the void, as a normal should.
  Vec3 f, n;
  if (crease.kind != Creased::Kind::no || !cell_point(cut, f, n)) return;
  const double other = base == nullptr ? -kBandVoxels : base->eval(f, gradient);
  if (!(other <= 0.0)) return;
  const bool inner_edge = cut.rounds_inner_edge();
  if (inner_edge) add_insides(volume, cell, cut, base, n);
  CutFeature& point = add_feature(volume, cell, f, n, f - 0.5 * n);
  point.inner_edge = inner_edge;
  const double length = std::sqrt(glm::dot(gradient, gradient));
  if (other > -kBeside && length > 0.25) add_beside(point, other * cell.voxel_mm / length, Vec3f(gradient / length));
}

bool CutSurface::make_cell(const Volume& volume, IVec3 corner, int offset, Part part) noexcept {
  if (made_count_ + 11 > made_.size()) return true;  // room for an edge, a point, the mouth and the corners
  const bool resolved = part == Part::resolved;
  const IVec3 local(offset & 7, offset >> 3 & 7, offset >> 6);
  const Cell cell{local, corner + local, offset, volume.grid().voxel_mm};
  const double* low = &samples_[local.x + kSide * (local.y + kSide * local.z)];
  constexpr int kFirst = 1 + kSide + kSide * kSide;
  const bool crossed = signs_differ(low + kFirst, kSide);
  cells_made_ += crossed;
  if (!crossed) return false;
  const double* base_low = &base_[low - samples_];
  const BaseAbout about = base_about(volume, cell, base_low + kFirst);
  if (about.air) return false;
  CellField cut, base;
  cut.load(low, kSide, kSide * kSide);
  if (!about.deep) base.load(base_low, kSide, kSide * kSide);
  const Creased crease = resolved ? creased(cut, kMostOff, [&](IVec3 o, CellField& to) { return load_beside(volume, cell, o, to); }) : Creased{};
  cells_resolved_ += crease.examined;
  add_cut(volume, cell, crease, cut, about.deep ? nullptr : &base);
  // Whether the cut meets the specimen's own surface.
  if (about.deep || !base.crossed()) return crease.examined;
  SharpEdge edge;
  if (edge_of([&](Vec3 p, Vec3& g) { return base.eval(p, g); }, [&](Vec3 p, Vec3& g) { return cut.eval(p, g); }, Vec3(0.5),
              edge))
    add_mouth(volume, cell, edge);
  return resolved;
}

}  // namespace cusp::engine
