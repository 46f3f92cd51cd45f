/// What a bur leaves that is led along a known way: through tissue soft enough that it follows the device point, so that
/// the swept bur is known exactly; and what it takes while it slides over tissue that it wears.
#pragma once

#include <vector>

#include "tests/bench/removal_drill.h"

namespace cusp::bench {

/// Ways by name: straight and curved ones go obliquely into a face; tilted is straight with a leaning bur. A bur that is
/// no ball is first led in along its axis, so deep that its head reaches out by kHeadOutMm, kDeepestMm at most, less what
/// the way itself goes down. drilled is that alone, sideways goes on across the axis: upright, as closed forms have it.
enum class Path : std::uint8_t { straight, curved, tilted, drilled, sideways };
constexpr std::string_view key_of(Path w) {
  switch (w) {
    case Path::straight: return "straight";
    case Path::curved: return "curved";
    case Path::tilted: return "tilted";
    case Path::drilled: return "drilled";
    case Path::sideways: return "sideways";
  }
  return "straight";
}
inline constexpr double kHeadOutMm = 0.1, kDeepestMm = 6.0;

/// Device points of a way, a tick apart; corners == 0, or only every so many ticks a corner and straight between.
struct Feeding {
  double speed_mm_s = 50.0;
  double tick_ms = 1.0;
  double corner_mm = 0.0;  // straight stretches of this length replace the curve; 0: none
};
std::vector<Vec3> points_of(Path path, const Cutter& cutter, const Feeding& feeding);

/// A block that gives way at once, 1 N/mm; its face is the plane through the origin across kPathUp.
inline const Vec3 kPathUp{0.10540925533894598, 0.17249182691827525, 0.9793563823};
std::shared_ptr<Scene> soft_scene(const Cutter& cutter, Method method, double voxel_mm, Path way);

struct RemainingSurface {
  double mean_um = 0.0, most_um = 0.0;  // of the surface that is left off the swept bur's, away from edges
  Vec3 worst_mm{0.0};                   // where it is furthest off; z out of the face
  std::int64_t points = 0, edges = 0;   // that were compared; that were not, for an edge is near
  double removed_mm3 = 0.0;
};
/// Leads the bur along it (halves > 1: with the button up in between) and reads what is left.
RemainingSurface lead_along(const Cutter& cutter, double voxel_mm, Path way, const std::vector<Vec3>& points, double tick_ms,
                     int halves);
/// What the bur takes on that way: closed forms for drilled and sideways, else the swept bur's (swept_bur.h).
double exact_removed_mm3(const Cutter& cutter, Path way, const std::vector<Vec3>& points);

/// Sliding while cutting: a noisy hand on a circle.
struct SlideExcess {
  double p99_um = 0.0, most_um = 0.0;  // how much further the surface went back in a tick than wear allows
  double depth_um = 0.0;               // how deep the bur came, in all
  std::int64_t ticks = 0;
};
SlideExcess slide_cutting(const Cutter& cutter, double voxel_mm, const Feeding& feeding, std::uint64_t seed);

/// Two strokes side by side leave a ridge; the bur then slides over it, cutting as slowly as `wear_mm_s`.
struct RidgeError {
  double felt_um = 0.0;   // a finer ball on the ridge stands lower than on the exact one by this, before
  double after_um = 0.0;  // and after, less what wear allows
};
RidgeError ridge_between(const Cutter& cutter, double voxel_mm, double speed_mm_s);

/// Cost of a tick while the bur cuts, drilling and then milling, in time that the thread had the core.
struct CutCost {
  double p50_us = 0.0, p99_us = 0.0, most_us = 0.0;
  std::int64_t ticks = 0;
};
CutCost cost_of_cutting(const Cutter& cutter, Method method, double voxel_mm, double budget_s);

}  // namespace cusp::bench
