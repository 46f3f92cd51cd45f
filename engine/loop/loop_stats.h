/// Times of a loop, in histograms of fixed size that one thread fills and any thread reads.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace cusp::engine {

/// Counts of durations: buckets of 0.1 us up to 6.4 us, then 32 buckets to the power of two. A percentile is within
/// 3.2 %. A duration above 5 s counts as 5 s; the maximum is exact.
class TimeHistogram {
 public:
  /// One writer thread. Wait-free.
  void add_ns(std::uint64_t ns) noexcept;
  /// Any thread. Upper edge of the bucket in which the fraction (0 to 1) lies, in us; 0 without counts.
  double percentile_us(double fraction) const noexcept;
  double max_us() const noexcept;
  std::uint64_t count() const noexcept { return count_.load(std::memory_order_relaxed); }

 private:
  static constexpr std::size_t kBuckets = 64 + 20 * 32;
  std::array<std::atomic<std::uint32_t>, kBuckets> buckets_{};
  std::atomic<std::uint64_t> count_{0};
  std::atomic<std::uint64_t> max_ns_{0};
};

struct LoopStats {
  TimeHistogram tick_cpu;   // step and hand-over, the thread's own processor time
  TimeHistogram exchange;   // write() to the device, by the clock
  TimeHistogram late;       // from a tick's deadline to its beginning
  std::atomic<std::uint64_t> missed{0};  // deadlines skipped because a tick began a whole period late
};

/// Plain copy for a screen or a report.
struct LoopTimes {
  double tick_p50_us = 0, tick_p99_us = 0, tick_p999_us = 0, tick_max_us = 0;
  double exchange_p99_us = 0;
  double late_p50_us = 0, late_p99_us = 0, late_max_us = 0;
  std::uint64_t ticks = 0, missed = 0;
};
LoopTimes times_of(const LoopStats& stats) noexcept;

}  // namespace cusp::engine
