/// What a burr leaves that is led along a known way: through tissue soft enough that it follows the device point, so that
/// the swept burr is known exactly; and what it takes while it slides over tissue that it wears.
#pragma once

#include <vector>

#include "tests/bench/removal_drill.h"

namespace cusp::bench {

/// Ways by name: straight and curved ones go obliquely into a face; tilted is straight with a leaning burr.
enum class Way : std::uint8_t { straight, curved, tilted };
constexpr std::string_view key_of(Way w) {
  return w == Way::straight ? "straight" : w == Way::curved ? "curved" : "tilted";
}

/// Device points of a way, a tick apart; corners == 0, or only every so many ticks a corner and straight between.
std::vector<Vec3> points_of(Way way, double speed_mm_s, double tick_ms, double radius_mm, double corner_mm = 0.0);

/// A block that gives way at once, 1 N/mm; its face is the plane through the origin across kWayUp.
inline const Vec3 kWayUp{0.10540925533894598, 0.17249182691827525, 0.9793563823};
std::shared_ptr<Scene> soft_scene(const Cutter& cutter, Method method, double voxel_mm, Way way);

struct ShapeLeft {
  double mean_um = 0.0, most_um = 0.0;  // of the surface that is left off the swept burr's, away from edges
  std::int64_t points = 0;
  double removed_mm3 = 0.0;
};
/// Leads the burr along it (halves > 1: with the button up in between) and reads what is left.
ShapeLeft lead_along(const Cutter& cutter, double voxel_mm, Way way, const std::vector<Vec3>& points, double tick_ms,
                     int halves);

/// Sliding while cutting: a noisy hand on a circle.
struct SlideExcess {
  double p99_um = 0.0, most_um = 0.0;  // how much further the surface went back in a tick than wear allows
  double depth_um = 0.0;               // how deep the burr came, in all
  double allowed_um = 0.0;             // and would have, at the speed of wear all the time
  std::int64_t ticks = 0;
};
SlideExcess slide_cutting(const Cutter& cutter, double voxel_mm, double speed_mm_s, double tick_ms, std::uint64_t seed);

/// Two strokes side by side leave a ridge; the burr then slides over it, cutting as slowly as `wear_mm_s`.
struct RidgeKept {
  double felt_um = 0.0;   // a finer ball on the ridge stands lower than on the exact one by this, before
  double after_um = 0.0;  // and after, less what wear allows
};
RidgeKept ridge_between(const Cutter& cutter, double voxel_mm, double speed_mm_s);

/// Cost of a tick while the burr cuts, drilling and then milling, in time that the thread had the core.
struct CutCost {
  double p50_us = 0.0, p99_us = 0.0, most_us = 0.0;
  std::int64_t ticks = 0;
};
CutCost cost_of_cutting(const Cutter& cutter, Method method, double voxel_mm, double budget_s);

}  // namespace cusp::bench
