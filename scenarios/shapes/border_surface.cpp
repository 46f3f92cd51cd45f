#include "scenarios/shapes/border_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "scenarios/shapes/voxel_blocks.h"

namespace cusp::scenarios {

namespace {

constexpr std::array<int, 3> kWeights = {1, 2, 1};  // over 4, along each axis: variance 1/2 voxel^2
constexpr double kSigmaVoxels = 0.70710678118654752;
constexpr int kWhole = 64;  // of the weights of 27 voxels
/// Normal quantiles of (32 + k)/64: how many deviations a plane of that smoothed value lies off.
constexpr std::array<double, 32> kQuantiles = {
    0.0,      0.039176, 0.078412, 0.117770, 0.157311, 0.197099, 0.237202, 0.277690, 0.318639, 0.360130, 0.402250,
    0.445097, 0.488776, 0.533410, 0.579132, 0.626099, 0.674490, 0.724514, 0.776422, 0.830511, 0.887147, 0.946782,
    1.009990, 1.077516, 1.150349, 1.229859, 1.318011, 1.417797, 1.534121, 1.675940, 1.862732, 2.153875};
/// A narrower disc leaves gaps above 0.1 voxel, a wider one stands off a round border (measured: border_test).
constexpr double kDiscVoxels = 0.75;
constexpr double kBallVoxels = 0.5;

/// Voxels off the place where the smoothed value is one half: positive inside.
double depth_voxels(int smoothed) noexcept {
  const int k = std::clamp(smoothed - kWhole / 2, -31, 31);
  const double q = kQuantiles[static_cast<std::size_t>(std::abs(k))];
  return kSigmaVoxels * (k < 0 ? -q : q);
}

/// Smoothed values of the voxels about a voxel, from those two voxels about it.
class Smoothed {
 public:
  template <class Has>
  explicit Smoothed(Has&& has) {
    for (int z = -2; z <= 2; ++z)
      for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) at(x, y, z) = has(IVec3(x, y, z)) ? 1 : 0;
  }
  int value(IVec3 v) const noexcept {
    int sum = 0;
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          const int weight = kWeights[static_cast<std::size_t>(x + 1)] * kWeights[static_cast<std::size_t>(y + 1)] * kWeights[static_cast<std::size_t>(z + 1)];
          sum += weight * at(v.x + x, v.y + y, v.z + z);
        }
    return sum;
  }

 private:
  static std::size_t index(int x, int y, int z) noexcept { return static_cast<std::size_t>((z + 2) * 25 + (y + 2) * 5 + x + 2); }
  int& at(int x, int y, int z) noexcept { return in_[index(x, y, z)]; }
  int at(int x, int y, int z) const noexcept { return in_[index(x, y, z)]; }

  std::array<int, 125> in_{};
};

}  // namespace

BorderSurface::BorderSurface(std::shared_ptr<const Specimen> specimen, const TissueSet& tissues)
    : specimen_(std::move(specimen)), tissues_(tissues), voxels_(VoxelIndex(*specimen_, tissues).surface_voxels()) {
  const double reach = kDiscVoxels * specimen_->grid().voxel_mm;
  patches_.reserve(voxels_.size());
  for (const IVec3 v : voxels_) patches_.push_back(patch_of(v));
  tree_ = BoxTree(leaves_of_blocks(voxels_, [&](std::size_t i) { return std::pair{patches_[i].at_mm - reach, patches_[i].at_mm + reach}; }));
}

BorderSurface::Patch BorderSurface::patch_of(IVec3 v) const noexcept {
  const Grid& grid = specimen_->grid();
  const Smoothed smoothed([&](IVec3 off) { return has(v + off); });
  Vec3 out(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    IVec3 step(0);
    step[axis] = 1;
    out[axis] = smoothed.value(-step) - smoothed.value(step);
  }
  const double length = std::sqrt(glm::dot(out, out));
  if (!(length > 0.0)) return {grid.centre_mm(v), Vec3(0.0)};
  out /= length;
  return {grid.centre_mm(v) + depth_voxels(smoothed.value(IVec3(0))) * grid.voxel_mm * out, out};
}

double BorderSurface::squared_to(const Patch& patch, Vec3 p) const noexcept {
  const double voxel = specimen_->grid().voxel_mm;
  const Vec3 off = p - patch.at_mm;
  const double square = glm::dot(off, off);
  if (patch.out == Vec3(0.0)) {
    const double beyond = std::max(std::sqrt(square) - kBallVoxels * voxel, 0.0);
    return beyond * beyond;
  }
  const double up = glm::dot(off, patch.out);
  const double beside = std::max(std::sqrt(std::max(square - up * up, 0.0)) - kDiscVoxels * voxel, 0.0);
  const double off_disc = up < 0.0 ? std::max(-up - voxel, 0.0) : up;
  return off_disc * off_disc + beside * beside;
}

double BorderSurface::distance_mm(Vec3 p, double at_most_mm) const noexcept {
  if (patches_.empty()) return at_most_mm;
  // A patch reaches no further than a disc's radius or a voxel below it, so most need no root.
  const double reach = std::hypot(kDiscVoxels, 1.0) * specimen_->grid().voxel_mm + 1e-9;
  double of = -1.0, within2 = 0.0;
  return std::sqrt(tree_.nearest_squared(p, at_most_mm * at_most_mm, [&](std::size_t i, double best) {
    if (of != best) {
      of = best;
      within2 = (std::sqrt(best) + reach) * (std::sqrt(best) + reach);
    }
    const Vec3 off = p - patches_[i].at_mm;
    return glm::dot(off, off) > within2 ? best : squared_to(patches_[i], p);
  }));
}

}  // namespace cusp::scenarios
