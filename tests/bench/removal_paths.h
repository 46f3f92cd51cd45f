/// Strokes along known paths. The tissue is so soft that the bur follows the device point and the swept bur is known
/// exactly. slide_cutting and ridge_between measure cutting while sliding.
#pragma once

#include <vector>

#include "tests/bench/removal_drill.h"

namespace cusp::bench {

/// straight and curved lead obliquely into a face; tilted is straight with a leaning bur. A bur that is no ball first
/// enters along its axis until kHeadOutMm of its head remains outside, kDeepestMm at most. drilled is that entry alone;
/// sideways continues across the axis. Both are upright and have closed forms.
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

/// Device points of a path, one a tick.
struct Feeding {
  double speed_mm_s = 50.0;
  double tick_ms = 1.0;
  double corner_mm = 0.0;  // straight stretches of this length replace the curve; 0: none
};
std::vector<Vec3> points_of(Path path, const Cutter& cutter, const Feeding& feeding);

/// A block that wears at once, 1 N/mm; its face is the plane through the origin with normal kPathUp.
inline const Vec3 kPathUp{0.10540925533894598, 0.17249182691827525, 0.9793563823};
std::shared_ptr<Scene> soft_scene(const Cutter& cutter, Method method, double voxel_mm, Path path);

struct RemainingSurface {
  double mean_um = 0.0, most_um = 0.0;  // distance from the swept bur's surface, away from edges
  Vec3 worst_mm{0.0};                   // place of most_um; z out of the face
  std::int64_t points = 0, edges = 0;   // compared; left out because an edge is near
  double removed_mm3 = 0.0;
};
/// Moves the bur along the points and reads the remaining surface. halves > 1: the button goes up in between.
RemainingSurface lead_along(const Cutter& cutter, double voxel_mm, Path path, const std::vector<Vec3>& points, double tick_ms,
                     int halves);
/// Exact removed volume: closed forms for drilled and sideways, else that of SweptBur.
double exact_removed_mm3(const Cutter& cutter, Path path, const std::vector<Vec3>& points);

/// Cutting while sliding on a circle with tremor and noise.
struct SlideExcess {
  double p99_um = 0.0, most_um = 0.0;  // excess of the surface's recession in a tick over the wear
  double depth_um = 0.0;               // final depth of the bur
  std::int64_t ticks = 0;
};
SlideExcess slide_cutting(const Cutter& cutter, double voxel_mm, const Feeding& feeding, std::uint64_t seed);

/// Two strokes side by side leave a ridge; the bur then slides over it 40 times in tissue that hardly wears.
struct RidgeError {
  double felt_um = 0.0;   // height error that a finer ball feels, before the passes
  double after_um = 0.0;  // after them, less the wear
};
RidgeError ridge_between(const Cutter& cutter, double voxel_mm, double speed_mm_s);

/// Cost of a cutting tick, drilling and then milling, by thread CPU time.
struct CutCost {
  double p50_us = 0.0, p99_us = 0.0, most_us = 0.0;
  std::int64_t ticks = 0;
};
CutCost cost_of_cutting(const Cutter& cutter, Method method, double voxel_mm, double budget_s);

}  // namespace cusp::bench
