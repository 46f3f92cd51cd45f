/// The verb `latency`: lateness and duration of the haptic loop's ticks in real time, with and without drawing.
/// The loop, mirror and ports are the product's; no thread is pinned. Port "clock" sleeps to its deadline, as mouse and
/// keys do. Port "emulated-falcon" runs the whole driver. The device exchange is timed apart from the tick.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/loop/loop_stats.h"
#include "engine/loop/realtime.h"
#include "tests/bench/options.h"
#include "tests/modules.h"

namespace cusp::bench {

/// Of one histogram, in us.
struct Spread {
  double p50 = 0, p99 = 0, p999 = 0, max = 0;
};
Spread spread_of(const TimeHistogram& times) noexcept;

/// Whether a DrawingLoad runs beside the loop.
enum class Load : std::uint8_t { off, on };

struct LatencyRow {
  std::string port;          // "clock", "emulated-falcon"
  Load load = Load::off;
  double seconds = 0;        // of wall clock
  RealtimeGrant grant;
  std::uint64_t ticks = 0, missed = 0;
  std::uint64_t late_samples = 0;  // ticks without a new device sample; 0 for "clock"
  Spread late_us;            // clock: after the deadline; device: after last answer + 1 ms
  Spread tick_us;            // step and hand-over, thread CPU time
  Spread exchange_us;        // write() of the port, wall time
  bool mirror_equal = true;  // loop and mirror have equal hashes
  double frames_per_s = 0;   // of the load
};

/// One row in real time, `seconds` long. ticks is 0 if no OpenGL context can be made for Load::on.
LatencyRow measure_latency(const std::string& port, Load load, double seconds);
/// {"commit", "engine", "machine", "rows": [...]}
std::string latency_json(const std::vector<LatencyRow>& rows);
int run_latency(const Options& options);

}  // namespace cusp::bench
