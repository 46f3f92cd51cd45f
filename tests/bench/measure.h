/// One row of `accuracy`: a method follows a motion, and each tick is compared with the exact proxy.
#pragma once

#include <memory>

#include "tests/bench/motions.h"
#include "tests/bench/options.h"
#include "tests/bench/rows.h"
#include "tests/bench/shapes.h"

namespace cusp::bench {

/// Settings of a measurement. stepper: the product's step, or a broken one in tests.
struct Measure {
  Method method = Method::surface;
  double voxel_mm = 10.0 / 128;
  double speed_mm_s = 50.0;  // slides
  double budget_s = 1.0;
  std::uint64_t seed = 1;
  std::int64_t most_ticks = 400000;  // a slide ends here at the latest, and presses
  Stepper stepper = [](StepState& state, const StepInput& input) { return step(state, input); };
};

/// Of the options: budget, samples and seed.
Measure measure_of(const Options& options);

/// Errors, tick by tick. Angle: between forces; a missing force counts as 90 degrees. A value that is not a number
/// counts as no force and as 1 m off.
class Errors {
 public:
  /// Adds a tick to the means. clearance_mm: exact, at the method's proxy.
  void add(const StepOutput& out, const Exact& exact, double clearance_mm);
  /// Leaves a tick out and interrupts the sequence of force steps.
  void skip() { steady_ = false; }
  /// Leaves out a tick whose exact force is below 50 um of spring.
  void skip_small() {
    ++skipped_;
    skip();
  }
  void followed(int ticks) { follow_.push_back(ticks); }
  void note(const StepOutput& out) { infeasible_ += out.infeasible ? 1 : 0; }

  void fill(Row& row);

 private:
  std::vector<double> angle_deg_, depth_um_, pose_um_, step_mn_, follow_;
  double error2_ = 0.0, exact2_ = 0.0;
  std::int64_t skipped_ = 0, infeasible_ = 0;
  bool steady_ = false;
  Vec3 last_force_{0.0}, last_exact_{0.0};
};

inline constexpr double kLeastSpringMm = 0.05;  // of the exact force, for a sample to count

/// Ticks of 1 ms along the shape's slide. If the exact minimum vanishes while the method stands within a voxel (at least
/// 50 um) of it, the ticks until the method follows, 100 at most, become follow_ticks.
Row measure_slide(const Shape& shape, const Measure& what);

/// Presses at random spots: from 50 um above, at 50 mm/s along the normal, to kDepthMm below the offset surface, then ten
/// ticks of rest. The last tick is the sample; tick times include all of them.
Row measure_presses(const Shape& shape, const Measure& what);

/// A row with names and sizes, without results.
Row row_of(const Shape& shape, const Measure& what, std::string_view motion);

}  // namespace cusp::bench
