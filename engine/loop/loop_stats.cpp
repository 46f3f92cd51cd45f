#include "engine/loop/loop_stats.h"

#include <algorithm>
#include <bit>

namespace cusp::engine {

namespace {
// Bucket of a duration in tenths of a microsecond: below 64 one bucket each, then 32 to the power of two.
constexpr std::size_t kLinear = 64;

std::size_t bucket_of(std::uint64_t units) noexcept {
  if (units < kLinear) return units;
  const auto octave = static_cast<std::size_t>(std::bit_width(units)) - 6;  // 64..127 is octave 1
  return kLinear + (octave - 1) * 32 + static_cast<std::size_t>((units >> octave) - 32);
}
std::uint64_t upper_edge_of(std::size_t bucket) noexcept {
  if (bucket < kLinear) return bucket + 1;
  const std::size_t octave = (bucket - kLinear) / 32 + 1;
  return (static_cast<std::uint64_t>((bucket - kLinear) % 32) + 33) << octave;
}
}  // namespace

void TimeHistogram::add_ns(std::uint64_t ns) noexcept {
  const std::size_t bucket = std::min(bucket_of(ns / 100), buckets_.size() - 1);
  buckets_[bucket].fetch_add(1, std::memory_order_relaxed);
  count_.fetch_add(1, std::memory_order_relaxed);
  if (ns > max_ns_.load(std::memory_order_relaxed)) max_ns_.store(ns, std::memory_order_relaxed);
}

double TimeHistogram::percentile_us(double fraction) const noexcept {
  std::uint64_t total = 0;
  for (const auto& b : buckets_) total += b.load(std::memory_order_relaxed);
  if (total == 0) return 0;
  const auto wanted = static_cast<std::uint64_t>(fraction * static_cast<double>(total));
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < buckets_.size(); ++i) {
    seen += buckets_[i].load(std::memory_order_relaxed);
    if (seen > wanted || seen == total) return std::min(static_cast<double>(upper_edge_of(i)) / 10.0, max_us());
  }
  return max_us();
}

double TimeHistogram::max_us() const noexcept {
  return static_cast<double>(max_ns_.load(std::memory_order_relaxed)) / 1000.0;
}

LoopTimes times_of(const LoopStats& stats) noexcept {
  LoopTimes t;
  t.tick_p50_us = stats.tick_cpu.percentile_us(0.5);
  t.tick_p99_us = stats.tick_cpu.percentile_us(0.99);
  t.tick_p999_us = stats.tick_cpu.percentile_us(0.999);
  t.tick_max_us = stats.tick_cpu.max_us();
  t.exchange_p99_us = stats.exchange.percentile_us(0.99);
  t.late_p50_us = stats.late.percentile_us(0.5);
  t.late_p99_us = stats.late.percentile_us(0.99);
  t.late_max_us = stats.late.max_us();
  t.ticks = stats.tick_cpu.count();
  t.missed = stats.missed.load(std::memory_order_relaxed);
  return t;
}

}  // namespace cusp::engine
