/// Durations of ticks, measured around step() alone.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "tests/bench/rows.h"

namespace cusp::bench {

using Clock = std::chrono::steady_clock;

/// The nearest-rank percentile; sorts the values. Pre: not empty, 0 <= share <= 1.
double percentile(std::vector<double>& values, double share);

class TickTimes {
 public:
  void reserve(std::size_t ticks) { us_.reserve(ticks); }
  void add_ns(std::int64_t ns) { us_.push_back(static_cast<float>(static_cast<double>(ns) * 1e-3)); }
  void append(const TickTimes& other) { us_.insert(us_.end(), other.us_.begin(), other.us_.end()); }
  std::size_t count() const { return us_.size(); }
  double sum_s() const;
  /// Sets updates_per_s and tick_us_* of the row; nothing when there are no ticks.
  void fill(Row& row) const;

 private:
  std::vector<float> us_;
};

}  // namespace cusp::bench
