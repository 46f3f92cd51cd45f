#include "tests/bench/mill.h"

#include <algorithm>

#include "tests/bench/cavity.h"
#include "tests/bench/names.h"
#include "tests/bench/tick_times.h"

namespace cusp::bench {

namespace {

struct MillLane {
  Method method;
  Cavity cavity;
  TickTimes times;
};

Row mill_row(const MillLane& lane, double radius_mm, double minutes, const MillHand& hand) {
  Row row;
  row.method = key_of(lane.method);
  row.shape = "cavity";
  row.task = "mill";
  row.speed_mm_s = kMillSpeedMmS;
  row.bur_radius_mm = radius_mm;
  row.voxel_mm = kCavityVoxelMm;
  row.minutes = minutes;
  row.tremor_mm = hand.tremor_mm;
  row.seed = static_cast<std::int64_t>(hand.seed);
  row.samples = static_cast<std::int64_t>(lane.times.count());
  lane.times.fill(row);
  row.tick_us_mean = 1e6 / row.updates_per_s;
  return row;
}

std::vector<Row> lanes_of(double radius_mm, double minutes, const MillHand& hand, const Options& options) {
  const auto ticks = std::max(kMillBlock, static_cast<int>(minutes * 60e3));
  std::vector<MillLane> lanes;
  for (const Method method : kMethods)
    if (asked(options.methods, key_of(method))) {
      lanes.push_back({method, Cavity(method, hand, radius_mm), {}});
      lanes.back().times.reserve(static_cast<std::size_t>(ticks + kMillBlock));
    }
  for (int done = 0; done < ticks; done += kMillBlock)
    for (MillLane& lane : lanes)
      for (int k = 0; k < kMillBlock; ++k) lane.times.add_ns(static_cast<std::int64_t>(lane.cavity.mill_tick() * 1e9));
  std::vector<Row> rows;
  for (const MillLane& lane : lanes) rows.push_back(mill_row(lane, radius_mm, minutes, hand));
  for (const Row& reference : rows)
    if (reference.method == key_of(Method::occupancy))
      for (Row& row : rows) row.ratio_to_occupancy = reference.tick_us_mean / row.tick_us_mean;
  return rows;
}

}  // namespace

std::vector<Row> mill_rows(const Options& options) {
  std::vector<Row> rows;
  for (const double radius : chosen(options.bur_radii_mm, {kMillRadiusMm}))
    for (const double tremor : chosen(options.tremors_mm, {0.05}))
      for (const double minutes : chosen(options.minutes, {kMillMinutes * std::min(1.0, options.budget_s)})) {
        const std::vector<Row> more = lanes_of(radius, minutes, {tremor, 0.0, options.seed}, options);
        rows.insert(rows.end(), more.begin(), more.end());
      }
  return rows;
}

}  // namespace cusp::bench
