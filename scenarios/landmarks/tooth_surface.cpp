#include "scenarios/landmarks/tooth_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cusp::scenarios {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
/// Below this ratio of variances a body has no axis: a ball has 1, a lower molar with its roots 3, its crown alone 0.6.
constexpr double kLeastElongation = 1.5;
constexpr int kPowerRounds = 200;

bool is_about_a_tooth(Tissue t) noexcept { return t == Tissue::gingiva || t == Tissue::bone || t == Tissue::ligament; }

/// Eigenvector of the greatest eigenvalue, by powers of the matrix.
Vec3 greatest_axis(const glm::dmat3& m) noexcept {
  Vec3 v(0.3, 0.2, 1.0);
  for (int i = 0; i < kPowerRounds; ++i) v = glm::normalize(m * v);
  return v.z < 0.0 ? -v : v;
}

}  // namespace

ToothSurface::ToothSurface(const VoxelVolume& volume) : volume_(volume) {
  own_tissues_ = std::ranges::none_of(volume.tissue, [](Tissue t) { return t == Tissue::enamel || t == Tissue::dentine; });
  const IVec3 size = grid().size;
  heights_.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), kNone);
  top_mm_ = -std::numeric_limits<double>::max();
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      int z = size.z - 1;
      while (z >= 0 && !is_tooth({x, y, z})) --z;
      if (z < 0) continue;
      double above = 0.5;
      if (z + 1 < size.z) {
        const double inside = distance_voxels({x, y, z}), outside = distance_voxels({x, y, z + 1});
        if (outside > inside && outside > 0.0) above = std::clamp(-inside / (outside - inside), 0.0, 1.0);
      }
      const double mm = grid().centre_mm({x, y, z}).z + above * grid().voxel_mm;
      heights_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)] = mm;
      top_mm_ = std::max(top_mm_, mm);
    }
  weigh();
}

bool ToothSurface::is_tooth(IVec3 v) const noexcept {
  if (!grid().contains(v)) return false;
  const std::size_t at = grid().index(v);
  if (volume_.s[at] < kHalf) return false;
  const Tissue t = volume_.tissue[at];
  if (t == Tissue::empty || is_about_a_tooth(t)) return false;
  return own_tissues_ || index_of(t) < kTissueKeys.size();
}

double ToothSurface::distance_voxels(IVec3 v) const noexcept { return distance_from_solid(volume_.s[grid().index(v)]); }

void ToothSurface::weigh() {
  Vec3 sum(0.0);
  glm::dmat3 squares(0.0);
  const IVec3 size = grid().size;
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        if (!is_tooth({x, y, z})) continue;
        const Vec3 p = grid().centre_mm({x, y, z});
        ++voxels_;
        sum += p;
        squares += glm::outerProduct(p, p);
      }
  if (voxels_ == 0) return;
  const double n = static_cast<double>(voxels_);
  centroid_mm_ = sum / n;
  const glm::dmat3 spread = squares / n - glm::outerProduct(centroid_mm_, centroid_mm_);
  const Vec3 axis = greatest_axis(spread);
  const double along = glm::dot(axis, spread * axis);
  // What is left of the trace is across; of the two ways across the greater is at least half of it.
  const Vec3 aside = greatest_axis(spread - along * glm::outerProduct(axis, axis));
  if (along > kLeastElongation * glm::dot(aside, spread * aside)) long_axis_ = axis;
}

std::optional<double> ToothSurface::height_mm(Vec2 at) const noexcept {
  const Vec2 p = (at - Vec2(grid().origin_mm.x, grid().origin_mm.y)) / grid().voxel_mm;
  const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
  if (x < 0 || y < 0 || x + 1 >= grid().size.x || y + 1 >= grid().size.y) return std::nullopt;
  const auto of = [&](int i, int j) {
    return heights_[static_cast<std::size_t>(y + j) * static_cast<std::size_t>(grid().size.x) + static_cast<std::size_t>(x + i)];
  };
  const double fx = p.x - x, fy = p.y - y;
  const double z = (1 - fy) * ((1 - fx) * of(0, 0) + fx * of(1, 0)) + fy * ((1 - fx) * of(0, 1) + fx * of(1, 1));
  return std::isfinite(z) ? std::optional(z) : std::nullopt;
}

std::vector<Vec2> ToothSurface::columns_above(double z_mm) const {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    if (!(heights_[i] > z_mm)) continue;
    const auto x = static_cast<int>(i % static_cast<std::size_t>(grid().size.x)), y = static_cast<int>(i / static_cast<std::size_t>(grid().size.x));
    const Vec3 p = grid().centre_mm({x, y, 0});
    out.emplace_back(p.x, p.y);
  }
  return out;
}

std::vector<Vec3> ToothSurface::surface_above(double z_mm) const {
  std::vector<Vec3> out;
  const IVec3 size = grid().size;
  const int from = std::max(1, static_cast<int>(std::ceil((z_mm - grid().origin_mm.z) / grid().voxel_mm)));
  for (int z = from; z + 1 < size.z; ++z)
    for (int y = 1; y + 1 < size.y; ++y)
      for (int x = 1; x + 1 < size.x; ++x) {
        const IVec3 v(x, y, z);
        if (!is_tooth(v)) continue;
        const double d = distance_voxels(v);
        if (d < -1.0) continue;
        Vec3 slope(0.0);
        for (int axis = 0; axis < 3; ++axis) {
          IVec3 step(0);
          step[axis] = 1;
          slope[axis] = distance_voxels(v + step) - distance_voxels(v - step);
        }
        const double length = glm::length(slope);
        if (length > 0.0) out.push_back(grid().centre_mm(v) - grid().voxel_mm * d * slope / length);
      }
  return out;
}

}  // namespace cusp::scenarios
