/// The verb `rate`: how many updates a second each method comes to in the paper's three tasks (its figure 13), all
/// methods side by side in one run on one core. 10/128 mm voxels, 128^3 in 10 mm.
/// Displacement: 50 mm/s, 0.1 mm clear of the surface. Exploration: slides at 50 mm/s, 0.3 mm below the offset surface,
/// and in and out of the bur's own channel. Perforation: the bur wholly in tissue, advancing 1 mm/s at ticks of 1 ms,
/// with all the upkeep that the step does.
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

/// Device points of a slide, `clear_mm` outside the offset surface when given, else where the shape's way leads.
std::vector<StepInput> slide_inputs(const Shape& shape, double speed_mm_s, std::uint64_t seed, std::size_t ticks);
std::vector<StepInput> clear_inputs(const Shape& shape, double speed_mm_s, std::uint64_t seed, std::size_t ticks);

/// A bur that drills straight into a face, from where it is wholly in tissue on.
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
