/// A bur of the catalogue mills the cavity of cavity.h at 5 mm/s, alone in its scene: the same device points for every bur. Its
/// neck is thin and so long that neither neck nor shank touches. Frame: specimen. Unit: mm. Thread: any but the haptic one.
#pragma once

#include <string_view>
#include <vector>

#include "tests/bench/cavity.h"
#include "tests/bench/head_courses.h"
#include "tests/bench/tick_times.h"

namespace cusp::bench {

class BurMill {
 public:
  /// axis: of kAxisMotions. It rests along the frame's z.
  BurMill(const Bur& bur, std::string_view axis, const MillHand& hand);

  /// The next tick of the milling. Before the first the bur comes through free space.
  StepOutput mill_tick();
  /// A tick with the button up and the axis in motion.
  StepOutput tick(Vec3 device) { return timed(device, axis_.next(), 0); }
  static constexpr double kOverMm = 5.0;  // of the pivot over the face, on the way into the cavity
  /// Straight through free space with the axis at rest; not timed.
  void lead_to(Vec3 to);

  StepState& state() { return state_; }
  TickTimes& times() { return times_; }
  /// Counted work of ticks, in units of the search for the proxy, against their times.
  struct Work {
    std::int64_t most = 0;  // of a tick
    double ticks = 0.0, sum = 0.0, squares = 0.0, us = 0.0, with_us = 0.0;
    void add(std::int64_t units, double tick_us) noexcept;
    /// Time of `most` units by the straight line that fits all ticks best; NaN where all count the same.
    double most_us() const noexcept;
  };
  const Work& work() const { return work_; }
  /// Forgets times and work.
  void start_measuring() {
    times_ = {};
    work_ = {};
  }

 private:
  StepOutput timed(Vec3 device, Vec3 wanted_axis, std::uint16_t buttons);
  StepState state_;
  AxisMotion axis_;
  MillMotion motion_;
  bool milling_ = false;
  TickTimes times_;
  Work work_;
};

/// `rate --task mill` with --bur, or with --full every bur of the catalogue: the surface method, a row for each bur, axis (fixed
/// and jitter), tremor (0.05 mm) and time (2 minutes). Throws std::runtime_error for a number that the catalogue lacks.
std::vector<Row> bur_mill_rows(const Options& options);

}  // namespace cusp::bench
