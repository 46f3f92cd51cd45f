/// Scenes side by side on one thread, in short blocks that alternate, so that a drift of the machine hits all alike.
#pragma once

#include <span>
#include <vector>

#include "engine/step/step.h"
#include "tests/bench/tick_times.h"
#include "tests/modules.h"

namespace cusp::bench {

/// Inputs that a lane goes through again and again, forth and back, so that the device never jumps.
class Track {
 public:
  /// Pre: at least two.
  explicit Track(std::vector<StepInput> inputs) : inputs_(std::move(inputs)) {}
  std::size_t size() const { return inputs_.size(); }
  const StepInput& next() {
    const StepInput& out = inputs_[at_];
    if (at_ + step_ >= inputs_.size()) step_ = 0 - step_;  // wraps below zero as well
    at_ += step_;
    return out;
  }

 private:
  std::vector<StepInput> inputs_;
  std::size_t at_ = 0, step_ = 1;
};

/// What blocks of ticks took.
struct Pace {
  TickTimes times;            // of the blocks with a clock round each step()
  std::vector<double> rates;  // updates in a second of the core's time, of each block without one
  std::int64_t untimed = 0;   // ticks of those
  std::int64_t free = 0;      // of those, answered from known free space

  void append(const Pace& other);
  /// Sets samples, updates_per_s (the median of the blocks without a clock in them, so that the clock's own 20 ns or so
  /// are not counted; time that other programs had the core is not either) and tick_us_* (by the wall, with both) of
  /// the row.
  void fill(Row& row) const;
};

struct Lane {
  StepState state;
  Track track;
  Pace pace;
};

/// Goes through the lanes in turn, a block without a clock and one with, until budget_s a lane is spent, after as much
/// again as a twentieth of it for warming up. Ends after a round, so that all lanes have as many blocks.
void run_lanes(std::span<Lane> lanes, double budget_s);

/// Median over the blocks of one's rate over the other's. Pre: both have run together.
double ratio_of(const Pace& pace, const Pace& to);

double median(std::vector<double> values);

}  // namespace cusp::bench
