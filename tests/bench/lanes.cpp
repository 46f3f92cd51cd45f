#include "tests/bench/lanes.h"

#include <algorithm>
#include <chrono>

#include "tests/bench/candidates.h"
#include "tests/bench/pin.h"

namespace cusp::bench {

namespace {

constexpr double kBlockS = 0.004;             // some 4,000 ticks of a fast method, 50 of a slow one
constexpr int kMostBatch = 32;                // ticks between clock readings in an untimed block
constexpr std::size_t kTicksKept = 4u << 20;  // reserved before the run, so that the run does not allocate

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

double run_unclocked(Lane& lane, double block_s) {
  const auto start = Clock::now();
  const double begun = core_time_s();
  const std::int64_t free_before = answered_free(lane.state);
  std::int64_t ticks = 0;
  double spent = 0.0;
  int batch = 1;
  do {
    for (int k = 0; k < batch; ++k) step(lane.state, lane.track.next());
    ticks += batch;
    spent = seconds(Clock::now() - start);
    batch = static_cast<int>(std::clamp(0.1 * block_s * static_cast<double>(ticks) / spent, 1.0, double{kMostBatch}));
  } while (spent < block_s);
  lane.pace.untimed += ticks;
  if (free_before >= 0) lane.pace.free += answered_free(lane.state) - free_before;
  return static_cast<double>(ticks) / (core_time_s() - begun);
}

void run_clocked(Lane& lane, double block_s) {
  const auto start = Clock::now();
  auto end = start;
  do {
    const StepInput& input = lane.track.next();
    const auto before = Clock::now();
    step(lane.state, input);
    end = Clock::now();
    if (lane.pace.times.count() < kTicksKept)
      lane.pace.times.add_ns(std::chrono::duration_cast<std::chrono::nanoseconds>(end - before).count());
  } while (seconds(end - start) < block_s);
}

}  // namespace

void Pace::append(const Pace& other) {
  times.append(other.times);
  rates.insert(rates.end(), other.rates.begin(), other.rates.end());
  untimed += other.untimed;
}

void Pace::fill(Row& row) const {
  times.fill(row);
  row.samples = static_cast<std::int64_t>(times.count()) + untimed;
  if (!rates.empty()) row.updates_per_s = median(rates);
}

void run_lanes(std::span<Lane> lanes, double budget_s) {
  for (Lane& lane : lanes) {
    lane.pace.times.reserve(std::min(kTicksKept, static_cast<std::size_t>(budget_s * 5e6) + 1024));
    run_unclocked(lane, 0.05 * budget_s);
    lane.pace.untimed = lane.pace.free = 0;
  }
  const auto start = Clock::now();
  do {
    for (Lane& lane : lanes) {
      lane.pace.rates.push_back(run_unclocked(lane, kBlockS));
      run_clocked(lane, kBlockS);
    }
  } while (seconds(Clock::now() - start) < budget_s * static_cast<double>(lanes.size()));
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

double ratio_of(const Pace& pace, const Pace& to) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(pace.rates.size(), to.rates.size()); ++i)
    ratios.push_back(pace.rates[i] / to.rates[i]);
  return median(std::move(ratios));
}

}  // namespace cusp::bench
