/// What a bur leaves that is led along a known way: through tissue soft enough that it follows the device point, so that
/// the swept bur is known exactly; and what it takes while it slides over tissue that it wears.
#pragma once

#include <vector>

#include "tests/bench/removal_drill.h"

namespace cusp::bench {

/// Ways by name: straight and curved ones go obliquely into a face; tilted is straight with a leaning bur. A bur that is
/// no ball is first led in along its axis, so deep that its head reaches out by kHeadOutMm, kDeepestMm at most, less what
/// the way itself goes down. drilled is that alone, sideways goes on across the axis: upright, as closed forms have it.
enum class Way : std::uint8_t { straight, curved, tilted, drilled, sideways };
constexpr std::string_view key_of(Way w) {
  switch (w) {
    case Way::straight: return "straight";
    case Way::curved: return "curved";
    case Way::tilted: return "tilted";
    case Way::drilled: return "drilled";
    case Way::sideways: return "sideways";
  }
  return "straight";
}
inline constexpr double kHeadOutMm = 0.1, kDeepestMm = 6.0;

/// Device points of a way, a tick apart; corners == 0, or only every so many ticks a corner and straight between.
std::vector<Vec3> points_of(Way way, const Cutter& cutter, double speed_mm_s, double tick_ms, double corner_mm = 0.0);

/// A block that gives way at once, 1 N/mm; its face is the plane through the origin across kWayUp.
inline const Vec3 kWayUp{0.10540925533894598, 0.17249182691827525, 0.9793563823};
std::shared_ptr<Scene> soft_scene(const Cutter& cutter, Method method, double voxel_mm, Way way);

struct ShapeLeft {
  double mean_um = 0.0, most_um = 0.0;  // of the surface that is left off the swept bur's, away from edges
  Vec3 worst_mm{0.0};                   // where it is furthest off; z out of the face
  std::int64_t points = 0, edges = 0;   // that were compared; that were not, for an edge is near
  double removed_mm3 = 0.0;
};
/// Leads the bur along it (halves > 1: with the button up in between) and reads what is left.
ShapeLeft lead_along(const Cutter& cutter, double voxel_mm, Way way, const std::vector<Vec3>& points, double tick_ms,
                     int halves);
/// What the bur takes on that way: closed forms for drilled and sideways, else the swept bur's (swept_bur.h).
double taken_on_mm3(const Cutter& cutter, Way way, const std::vector<Vec3>& points);

/// Sliding while cutting: a noisy hand on a circle.
struct SlideExcess {
  double p99_um = 0.0, most_um = 0.0;  // how much further the surface went back in a tick than wear allows
  double depth_um = 0.0;               // how deep the bur came, in all
  double allowed_um = 0.0;             // and would have, at the speed of wear all the time
  std::int64_t ticks = 0;
};
SlideExcess slide_cutting(const Cutter& cutter, double voxel_mm, double speed_mm_s, double tick_ms, std::uint64_t seed);

/// Two strokes side by side leave a ridge; the bur then slides over it, cutting as slowly as `wear_mm_s`.
struct RidgeKept {
  double felt_um = 0.0;   // a finer ball on the ridge stands lower than on the exact one by this, before
  double after_um = 0.0;  // and after, less what wear allows
};
RidgeKept ridge_between(const Cutter& cutter, double voxel_mm, double speed_mm_s);

/// Cost of a tick while the bur cuts, drilling and then milling, in time that the thread had the core.
struct CutCost {
  double p50_us = 0.0, p99_us = 0.0, most_us = 0.0;
  std::int64_t ticks = 0;
};
CutCost cost_of_cutting(const Cutter& cutter, Method method, double voxel_mm, double budget_s);

}  // namespace cusp::bench
