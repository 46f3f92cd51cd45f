// Edges about the bur, some a tick.
#include <algorithm>

#include "engine/contact/surface_near.h"

namespace cusp::engine {

namespace {

/// mm from the bur within which that is done: some ticks before it is there.
constexpr double kSharpenWithin = 0.15;
/// mm beyond, that a look says something of for the next ticks.
constexpr double kDullFar = 0.1;

}  // namespace

void SurfaceContact::sharpen(const Volume& volume, const Bur& bur, Vec3 axis, Vec3 pose, bool on, bool wait) noexcept {
  if (on != cut_.sharpens()) {
    cut_.sharpen(volume, on);
    gathered_.valid = free_.valid = dull_far_.valid = false;
    sharp_ = on;
  }
  if (!on) return;
  if (cut_.dull_parts() == 0) {
    sharp_ = true;
    return;
  }
  const Vec3 gone = pose - dull_far_.at;
  if (dull_far_.valid && dull_far_.bur == &bur && dull_far_.axis == axis && glm::dot(gone, gone) <= kDullFar * kDullFar) return;

  const Tool tool{&bur, axis};
  const double side = voxel_mm_;
  // Parts of a brick near the head of a ball; of another head all.
  const auto near = [&](IVec3 at, double margin) {
    if (!tool.ball()) return CutSurface::kAllParts;
    CutSurface::Parts out = 0;
    const Vec3 corner = volume.grid().origin_mm + side * Vec3(at * kBrickEdge);
    const double reach = bur.radius_mm + margin;
    for (int part = 0; part < 2 * kBrickEdge; ++part) {
      const double y = part % 2 * 4.0, z = part / 2;
      const Vec3 low = corner + Vec3(-0.2, y - 0.2, z - 0.2) * side, high = corner + Vec3(8.2, y + 4.2, z + 1.2) * side;
      out = static_cast<CutSurface::Parts>(out | (box_distance2(pose, low, high) <= reach * reach ? 1u << part : 0u));
    }
    return out;
  };
  int budget = wait ? 0 : CutSurface::kSharpenATick;
  bool any = false, far = false;
  // The head first, then the shank.
  head_bricks(volume, tool, pose, kSharpenWithin + kDullFar, [&](int brick, IVec3 at) {
    if (!volume.has_cut(brick)) return;
    const CutSurface::Parts dull = cut_.dull(volume, brick);
    if (dull == 0 || (dull & near(at, kSharpenWithin + kDullFar)) == 0) return;
    far = true;
    const auto wanted = static_cast<CutSurface::Parts>(dull & near(at, kSharpenWithin));
    if (wanted == 0) return;
    any = true;
    if (budget > 0) budget = cut_.sharpen_parts(volume, brick, wanted, budget);
  });
  const auto shank = [&](double margin, auto&& visit) {
    bricks_within(volume, axis, pose, shank_within(tool, margin), [&](int brick, IVec3) {
      if (volume.has_cut(brick) && cut_.dull(volume, brick) != 0) visit(brick);
    });
  };
  if (budget > 0)
    shank(kSharpenWithin, [&](int brick) {
      any = true;
      if (budget > 0) budget = cut_.sharpen_parts(volume, brick, CutSurface::kAllParts, budget);
    });
  if (any) {
    gathered_.valid = free_.valid = false;
  } else if (!far) {
    shank(kSharpenWithin + kDullFar, [&](int) { far = true; });
    dull_far_ = {pose, axis, &bur, !far};
  }
  sharp_ = !any || budget > 0;
}

}  // namespace cusp::engine
