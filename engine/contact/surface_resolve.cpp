// Resolves the parts near the bur, some a tick.
#include "engine/contact/surface_near.h"

namespace cusp::engine {

namespace {

/// mm: parts this near to the bur are resolved, some ticks before it is there.
constexpr double kResolveWithinMm = 0.15;
/// mm: the check reaches this much further, so that it stays valid while the bur moves less.
constexpr double kUnresolvedMarginMm = 0.1;

}  // namespace

/// Calls visit(brick, parts) with the unresolved parts within margin_mm of the bur, the head's bricks first: of a ball the parts,
/// of neck, shank and another head all of a brick. What it visits is among what a pose `d` away visits with d more of margin.
template <class Visit>
void SurfaceContact::unresolved_near(const Volume& volume, const Tool& tool, Vec3 pose, double margin_mm, Visit&& visit) const noexcept {
  const double side = voxel_mm_, reach = tool.bur->radius_mm + margin_mm;
  const auto near = [&](IVec3 at) {
    CutSurface::Parts out = 0;
    const Vec3 corner = brick_corner(volume.grid(), at);
    for (int part = 0; part < 2 * kBrickEdge; ++part) {
      const double y = part % 2 * 4.0, z = part / 2;
      const Vec3 low = corner + Vec3(-0.2, y - 0.2, z - 0.2) * side, high = corner + Vec3(8.2, y + 4.2, z + 1.2) * side;
      out = static_cast<CutSurface::Parts>(out | (box_distance2(pose, low, high) <= reach * reach ? 1u << part : 0u));
    }
    return out;
  };
  const auto visit_among = [&](int brick, CutSurface::Parts parts) {
    parts = static_cast<CutSurface::Parts>(parts & cut_.unresolved(volume, brick));
    if (parts != 0) visit(brick, parts);
  };
  const auto visit_all = [&](int brick, IVec3, const TwoCylinders&) {
    if (volume.has_cut(brick)) visit_among(brick, CutSurface::kAllParts);
  };
  if (tool.ball())
    ball_bricks(volume, pose, reach, [&](int brick, IVec3 at, double) {
      if (volume.has_cut(brick) && cut_.unresolved(volume, brick) != 0) visit_among(brick, near(at));
    });
  else
    bricks_within(volume, tool.axis, pose, head_within(tool, margin_mm), visit_all);
  bricks_within(volume, tool.axis, pose, shank_within(tool, margin_mm), visit_all);
}

void SurfaceContact::resolve(const Volume& volume, const Bur& bur, Vec3 axis, Vec3 pose, Resolve when) noexcept {
  const bool on = when != Resolve::off;
  if (on != cut_.resolves()) {
    cut_.resolve(volume, on ? Resolving::on : Resolving::off);
    gathered_.valid = free_.valid = unresolved_far_.valid = false;
    all_resolved_ = on;
  }
  if (!on) return;
  if (cut_.unresolved_parts() == 0) {
    all_resolved_ = true;
    return;
  }
  const Vec3 gone = pose - unresolved_far_.at;
  if (unresolved_far_.valid && unresolved_far_.bur == &bur && unresolved_far_.axis == axis && glm::dot(gone, gone) <= kUnresolvedMarginMm * kUnresolvedMarginMm) return;

  const Tool tool{&bur, axis};
  int budget = when == Resolve::wait ? 0 : CutSurface::kResolvePerTick;
  bool any = false;
  unresolved_near(volume, tool, pose, kResolveWithinMm, [&](int brick, CutSurface::Parts parts) {
    any = true;
    if (budget > 0) budget = cut_.resolve_parts(volume, brick, parts, budget);
  });
  if (any) {
    gathered_.valid = free_.valid = false;
  } else {
    bool far = false;
    unresolved_near(volume, tool, pose, kResolveWithinMm + kUnresolvedMarginMm, [&](int, CutSurface::Parts) { far = true; });
    unresolved_far_ = {pose, axis, &bur, !far};
  }
  all_resolved_ = !any || budget > 0;
}

}  // namespace cusp::engine
