// What a cell of a cut brick holds: the specimen's own points that are left, the cut's, and edges.
#include <algorithm>

#include "engine/contact/cut_surface.h"
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

/// The tissue at a place of a cell (voxels), else of one of its corners.
Tissue tissue_under(const Volume& volume, IVec3 cell, Vec3 place) noexcept {
  Tissue tissue = volume.tissue(cell_of_voxels(Vec3(cell) + place + 0.5));
  for (int i = 0; i < 8 && tissue == Tissue::empty; ++i)
    tissue = volume.tissue(cell + IVec3(i & 1, i >> 1 & 1, i >> 2));
  return tissue;
}
}  // namespace

bool CutSurface::make_base(const Volume& volume, const BasePoints& points, int i, bool resolved) noexcept {
  if (made_count_ == made_.size()) return true;
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

bool CutSurface::make_cell(const Volume& volume, IVec3 corner, int offset, bool resolved) noexcept {
  if (made_count_ + 3 > made_.size()) return true;  // room for an edge, a point and the mouth
  const IVec3 local(offset & 7, offset >> 3 & 7, offset >> 6);
  const IVec3 cell = corner + local;
  const double* low = &samples_[local.x + kSide * (local.y + kSide * local.z)];
  const double* first = low + 1 + kSide + kSide * kSide;
  const bool inside = *first > 0.0;
  bool crossed = false;
  for (int i = 1; i < 8; ++i)
    crossed = crossed || (first[(i & 1) + (i >> 1 & 1) * kSide + (i >> 2) * kSide * kSide] > 0.0) != inside;
  cells_made_ += crossed;
  if (!crossed) return false;
  // Deep in the specimen its own surface is so far from all corners that it ends no plane: nothing of it to keep. Out in the
  // air there is nothing that a cut could have left.
  const Specimen& specimen = volume.specimen();
  bool deep = true, air = true;
  const int brick = specimen.brick_index({cell.x >> 3, cell.y >> 3, cell.z >> 3});
  const bool solid = local.x < 7 && local.y < 7 && local.z < 7 && specimen.s_of(brick) == nullptr && specimen.s_in(brick, 0) == kSolid;
  const double* base_low = &base_[low - samples_];
  if (!solid) {
    if (!base_ready_) decode_base(specimen, {corner.x >> 3, corner.y >> 3, corner.z >> 3});
    const double* corners = base_low + 1 + kSide + kSide * kSide;
    for (int i = 0; i < 8 && (deep || air); ++i) {
      const double d = corners[(i & 1) + (i >> 1 & 1) * kSide + (i >> 2) * kSide * kSide];
      deep = deep && d <= kDeep;
      air = air && d >= kAir;
    }
  }
  if (air && !solid) return false;
  CellField cut;
  cut.load(low, kSide, kSide * kSide);
  CellField base;
  if (!deep) base.load(base_low, kSide, kSide * kSide);
  const double voxel = volume.grid().voxel_mm;
  const bool mouth = !deep && base.crossed();  // the cut meets the specimen's own surface
  const auto add_edge = [&](const SharpEdge& edge) {
    Made& made = made_[made_count_++];
    made = Made{};
    made.at = Vec3f(Vec3(local) + edge.at);
    made.feature.normal = Vec3f(edge.tangent);
    made.feature.other_normal = Vec3f(edge.bend / voxel);
    made.feature.third_normal = Vec3f(edge.twist / (voxel * voxel));
    made.feature.edge = true;
    made.feature.third_d_mm = static_cast<float>(kHalfEdge * voxel);
    made.feature.other_d_mm = -made.feature.third_d_mm;
    made.feature.cell = static_cast<std::uint16_t>(offset);
    made.feature.tissue = tissue_under(volume, cell, edge.at);
  };
  // The cut's distance is positive in the void: its gradient points into the void, as a normal should.
  Vec3 f, n;
  SharpEdge edge;
  const Creased crease = creased(cut, resolved ? kMostOff : 0.0, [&](IVec3 o, CellField& to) {
    if (!wide_ready_) decode_wide(volume, {corner.x >> 3, corner.y >> 3, corner.z >> 3});
    const IVec3 there = local + o + 2;  // the lowest sample that its field is made of
    const double* samples = &wide_[there.x + kWide * (there.y + kWide * there.z)];
    const double* corners = samples + 1 + kWide + kWide * kWide;
    const bool empty = corners[0] > 0.0;
    bool apart = false;
    for (int i = 1; i < 8 && !apart; ++i)
      apart = (corners[(i & 1) + (i >> 1 & 1) * kWide + (i >> 2) * kWide * kWide] > 0.0) != empty;
    if (apart) to.load(samples, kWide, kWide * kWide);
    return apart;
  });
  cells_resolved_ += resolved && crease.examined;
  Vec3 gradient(0.0);
  if (crease.kind == Creased::Kind::edge) {
    // A ridge between two cuts, where the specimen is solid.
    if (deep || base.eval(crease.edge.at, gradient) <= 0.0) add_edge(crease.edge);
  } else if (crease.kind == Creased::Kind::face) {
    if (deep || base.eval(crease.point, gradient) <= 0.0) {
      Made& made = made_[made_count_++];
      made = Made{};
      made.at = Vec3f(Vec3(local) + crease.point);
      made.feature.normal = Vec3f(crease.normal);
      made.feature.cell = static_cast<std::uint16_t>(offset);
      made.feature.tissue = tissue_under(volume, cell, crease.point - 0.5 * crease.normal);
      add_beside(made.feature, crease.other_d * voxel, Vec3f(crease.other_normal));
    }
  } else if (crease.kind == Creased::Kind::no && cell_point(cut, f, n)) {
    Vec3 g(0.0);
    const double other = deep ? -kBandVoxels : base.eval(f, g);
    if (other <= 0.0) {
      Made& made = made_[made_count_++];
      made = Made{};
      made.at = Vec3f(Vec3(local) + f);
      made.feature.normal = Vec3f(n);
      made.feature.cell = static_cast<std::uint16_t>(offset);
      made.feature.tissue = tissue_under(volume, cell, f - 0.5 * n);
      const double length = std::sqrt(glm::dot(g, g));
      if (other > -kBeside && length > 0.25) add_beside(made.feature, other * voxel / length, Vec3f(g / length));
    }
  }
  if (!mouth) return resolved && crease.examined;
  if (edge_of([&](Vec3 p, Vec3& g) { return base.eval(p, g); }, [&](Vec3 p, Vec3& g) { return cut.eval(p, g); }, Vec3(0.5),
              edge))
    add_edge(edge);
  return resolved;
}

}  // namespace cusp::engine
