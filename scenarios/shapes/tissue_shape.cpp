#include "scenarios/shapes/tissue_shape.h"

#include <algorithm>
#include <cmath>

#include "scenarios/teeth/own_tissues.h"

namespace cusp::scenarios {

namespace {

/// Voxels outside a shape that share a face with one of its outermost.
std::vector<IVec3> about(const Specimen& specimen, const TissueSet& tissues, const VoxelIndex& within) {
  std::vector<IVec3> out;
  for (const IVec3 v : within.surface_voxels())
    for (int axis = 0; axis < 3; ++axis)
      for (int step = -1; step <= 1; step += 2) {
        IVec3 next = v;
        next[axis] += step;
        if (!tissues[index_of(specimen.tissue(next))] || !was_solid(specimen, next)) out.push_back(next);
      }
  return out;
}

}  // namespace

TissueSet tissues_of(const Region& leaf) noexcept {
  TissueSet out{};
  if (leaf.kind == RegionKind::tissue) {
    out[index_of(leaf.tissue)] = true;
    return out;
  }
  out[index_of(Tissue::carious_dentine)] = out[index_of(Tissue::carious_enamel)] = true;
  out[index_of(kFirmCariousDentine)] = leaf.down_to == Hardness::firm;
  return out;
}

TissueShape::TissueShape(std::shared_ptr<const Specimen> specimen, const TissueSet& tissues)
    : specimen_(std::move(specimen)), tissues_(tissues), within_(*specimen_, tissues_),
      without_(specimen_->grid(), about(*specimen_, tissues_, within_)) {
  const Grid& grid = specimen_->grid();
  bool first = true;
  for (const IVec3 v : within_.surface_voxels()) {
    const Vec3 centre = grid.centre_mm(v);
    low_ = first ? centre : glm::min(low_, centre);
    high_ = first ? centre : glm::max(high_, centre);
    first = false;
  }
  low_ -= 0.5 * grid.voxel_mm;
  high_ += 0.5 * grid.voxel_mm;
}

double TissueShape::beside(Vec3 p, IVec3 v, Side side) const noexcept {
  const Grid& grid = specimen_->grid();
  const Vec3 off = (p - grid.centre_mm(v)) / grid.voxel_mm;  // within half a voxel
  double nearest = kFarMm * kFarMm;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const Vec3 gap = glm::max(glm::abs(Vec3(x, y, z) - off) - 0.5, Vec3(0.0));
        const double square = glm::dot(gap, gap) * grid.voxel_mm * grid.voxel_mm;
        if (square < nearest && has(v + IVec3(x, y, z)) == (side == Side::within)) nearest = square;
      }
  return std::sqrt(nearest);
}

double TissueShape::distance_mm(Vec3 p) const noexcept {
  if (within_.empty()) return kFarMm;
  const Grid& grid = specimen_->grid();
  const IVec3 v = voxel_of(p);
  const bool inside = has(v);
  // No voxel but the 26 lies nearer than a voxel; further off their distance bounds the search.
  double mm = least_mm(p) > 2.0 * grid.voxel_mm ? kFarMm : beside(p, v, inside ? Side::without : Side::within);
  if (mm > grid.voxel_mm) mm = (inside ? without_ : within_).distance_mm(p, mm);
  return inside ? -mm : mm;
}

double TissueShape::least_mm(Vec3 p) const noexcept {
  if (within_.empty()) return kFarMm;
  const Vec3 off = glm::max(glm::max(low_ - p, p - high_), Vec3(0.0));
  return std::sqrt(glm::dot(off, off));
}

Vec3 TissueShape::out_of(Vec3 p) const noexcept {
  const double step = specimen_->grid().voxel_mm;
  Vec3 slope(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 low = p, high = p;
    low[axis] -= step;
    high[axis] += step;
    slope[axis] = distance_mm(high) - distance_mm(low);
  }
  const double length = std::sqrt(glm::dot(slope, slope));
  return length > 0.0 ? slope / length : Vec3(0.0, 0.0, 1.0);
}

}  // namespace cusp::scenarios
