/// The verb `rate`: updates a second of each method in the paper's three tasks (its figure 13). All methods alternate in
/// one run on one core, with voxels of 10/128 mm, 128^3 in 10 mm.
/// Displacement: 50 mm/s, kClearMm outside the offset surface. Exploration: slides at 50 mm/s, kDepthMm below it, and
/// through the bur's own channel. Perforation: the bur in tissue, 1 mm/s at ticks of 1 ms, updates of the volume included.
/// A fourth task is Cusp's own: mill (mill.h). With --bur or --full nothing but mill is measured, bur by bur (bur_mill.h).
#pragma once

#include <memory>
#include <vector>

#include "tests/bench/lanes.h"
#include "tests/bench/options.h"
#include "tests/bench/rows.h"
#include "tests/bench/shapes.h"

namespace cusp::bench {

inline constexpr double kRateVoxelMm = 10.0 / 128;
inline constexpr double kClearMm = 0.1;
inline constexpr double kRateSpeedMmS = 50.0;
inline constexpr double kAdvanceMmS = 1.0;

/// Inputs of a slide along the shape's legs; clear_inputs stays kClearMm outside the offset surface.
std::vector<StepInput> slide_inputs(const Shape& shape, double speed_mm_s, std::uint64_t seed, std::size_t ticks);
std::vector<StepInput> clear_inputs(const Shape& shape, double speed_mm_s, std::uint64_t seed, std::size_t ticks);

/// A bur that drills straight into a face and starts wholly in tissue.
class Perforation {
 public:
  static constexpr int kTicks = 2000;  // 2 mm

  Perforation(Method method, const Shape& face, double voxel_mm, std::uint64_t seed);
  StepState& state() { return state_; }
  /// Pre: at most kTicks calls.
  StepInput next();

 private:
  StepState state_;
  Vec3 start_{0.0}, inwards_{0.0};
  int tick_ = 0;
};

std::vector<Row> rate_rows(const Options& options);
int run_rate(const Options& options);

}  // namespace cusp::bench
