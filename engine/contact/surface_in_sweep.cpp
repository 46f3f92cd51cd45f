// The search of a ball that one sweep holds, where neck and shank are free: in its own hole, at its own front while it cuts, and
// in wider cuts.

#include "engine/contact/surface_near.h"

namespace cusp::engine {

namespace {

// Looked for so far beyond what is asked for. At 0.1 mm a ball of 0.25 mm explores its own channel at half the rate; at 0.03 mm
// one of 0.5 mm loses a third in its oblique one (`cusp-bench rate`).
constexpr double kShankAheadMm = 0.05;
constexpr double kBesideMm = 0.01;       // that neck and shank must be free beyond the way
constexpr double kWays = 1.5, kWayMm = 0.02;  // a longer way than so many of the device's and so much is no slide

}  // namespace

/// True if nothing stands within within_mm of neck and shank.
bool SurfaceContact::shank_free(const Volume& volume, const Tool& tool, Vec3 pose, double within_mm) noexcept {
  const ShankFree& known = shank_free_;
  if (known.bur == tool.bur && known.axis == tool.axis && length_of(pose - known.centre) + within_mm <= known.margin_mm) return true;
  // One gathering serves both distances.
  const std::size_t at_hand = count_, from = gathered_.valid ? ball_count_ + shank_count_ : 0;
  count_ = from;
  gather_shank(volume, tool, pose, within_mm + kShankAheadMm);
  const int near = static_cast<int>(count_ - from);
  count_ = at_hand;
  const auto free = [&](double margin) {
    bool out = true;
    for_inside(&place_x_[from], &place_y_[from], &place_z_[from], near,
               CylinderLanes(shank_within(tool, margin + kMostMovedOut * voxel_mm_).cylinders(tool.axis, voxel_mm_)), [&out](int) { out = false; });
    return out;
  };
  for (const double ahead : {kShankAheadMm, 0.0}) {
    if (near > 0 && !free(within_mm + ahead)) continue;
    shank_free_ = {pose, tool.axis, within_mm + ahead, tool.bur};
    return true;
  }
  return false;
}

/// False if the sweeps about the ball do not answer alone.
bool SurfaceContact::solve_in_sweep(const Volume& volume, const Tool& tool, Vec3 from, Vec3 device, double moved_mm,
                                    Contact& out) noexcept {
  const CavityWalls::Held held = walls_.held_by_sweep(volume, {from, tool.bur->radius_mm - tool.thin_cut, 0.0}, device);
  candidates_left_ -= walls_.take_work();
  if (!held.held) return false;
  const double way = length_of(held.pose - from);
  if (way > kWays * moved_mm + kWayMm || !shank_free(volume, tool, from, way + kBesideMm)) return false;
  out = Contact{};
  out.pose_mm = held.pose;
  out.in_steps = true;
  if (held.gap_mm <= 0.0) return true;
  out.active = 1;
  out.normal[0] = held.n;
  out.weight[0] = held.gap_mm;
  out.tissue[0] = tissue_under(volume, held.foot, held.n);
  return true;
}

}  // namespace cusp::engine
