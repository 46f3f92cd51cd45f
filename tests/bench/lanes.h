/// Scenes that alternate in short blocks on one thread, so that a drift of the machine affects all alike.
#pragma once

#include <span>
#include <vector>

#include "engine/step/step.h"
#include "tests/bench/tick_times.h"
#include "tests/modules.h"

namespace cusp::bench {

/// Inputs in a loop, forwards and backwards, so that the device never jumps.
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

/// Times of blocks of ticks.
struct Pace {
  TickTimes times;            // of the blocks that time each step()
  std::vector<double> rates;  // updates per second of thread CPU time, of each untimed block
  std::int64_t untimed = 0;   // ticks in untimed blocks
  std::int64_t free = 0;      // of those, answered by the cached free space

  void append(const Pace& other);
  /// Sets samples, updates_per_s and tick_us_* of the row. updates_per_s is the median of the untimed blocks by thread
  /// CPU time. tick_us_* are wall times and include the clock's own 20 ns.
  void fill(Row& row) const;
};

struct Lane {
  StepState state;
  Track track;
  Pace pace;
};

/// Runs an untimed and a timed block of each lane in turn until budget_s a lane is spent, after a warm-up of a twentieth
/// of it. All lanes get the same number of blocks.
void run_lanes(std::span<Lane> lanes, double budget_s);

/// Median over the blocks of the ratio of both rates. Pre: both have run in one run_lanes.
double ratio_of(const Pace& pace, const Pace& to);

double median(std::vector<double> values);

}  // namespace cusp::bench
