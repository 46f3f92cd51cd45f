/// The verb `latency`: how late the haptic loop's ticks begin and how long they take, in real time on this machine, with
/// and without drawing going on. The loop, its mirror and the ports are the program's own; nothing is pinned or slowed.
/// Rows: a port that sleeps to its deadline ("clock", as mouse and keys do), and the emulated Falcon with all of its
/// driver ("emulated-falcon"), each with load off and on. The exchange with the device is timed apart from the tick.
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
  std::uint64_t late_samples = 0;  // of the device; of a port without a clock of its own none
  Spread late_us;            // clock: after the deadline; device: after the millisecond since its last answer
  Spread tick_us;            // step and hand-over, processor time of the thread
  Spread exchange_us;        // handing the force to the device, by the clock
  bool mirror_equal = true;  // the loop and its mirror came to the same state
  double frames_per_s = 0;   // of the load
};

/// One row in real time: `seconds` long. A load that cannot be drawn here gives none.
LatencyRow measure_latency(const std::string& port, Load load, double seconds);
/// {"commit", "machine", "rows": [...]}
std::string latency_json(const std::vector<LatencyRow>& rows);
int run_latency(const Options& options);

}  // namespace cusp::bench
