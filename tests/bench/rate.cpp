#include "tests/bench/rate.h"

#include <fmt/core.h>

#include <array>
#include <chrono>
#include <iostream>
#include <stdexcept>

#include "tests/bench/bur_mill.h"
#include "tests/bench/channel.h"
#include "tests/bench/frame.h"
#include "tests/bench/mill.h"
#include "tests/bench/motions.h"
#include "tests/bench/names.h"
#include "tests/bench/pin.h"

namespace cusp::bench {

namespace {

constexpr std::size_t kRateTrackTicks = 4096;  // 0.2 m; the inputs fit the second-level cache
constexpr int kPerforationBlock = 250;
constexpr int kHolesAKind = 4;

struct RateTask {
  std::string_view task, shape;
  std::vector<double> radii;
  std::vector<double> voxels_mm = {kRateVoxelMm};
};

const std::vector<RateTask>& standard_tasks() {
  static const std::vector<RateTask> tasks = {
      {"displacement", "face", {0.25, 0.5}},
      {"displacement", "sphere", {0.25, 0.5}},
      {"displacement", "cylinder", {0.25, 0.5}},
      {"exploration", "face", {0.25, 0.5, 1.15, 3.0}},
      {"exploration", "sphere", {0.25, 0.5, 1.15, 3.0}},
      {"exploration", "cylinder", {0.25, 0.5, 1.15, 3.0}},
      {"exploration", "face", {0.5}, {0.2, 0.1, 0.04}},
      {"exploration", "sphere", {0.5}, {0.2, 0.1, 0.04}},
      {"exploration", "channel", {0.25, 0.5}},
      {"perforation", "face", {0.25, 0.5}},
  };
  return tasks;
}

std::vector<Method> methods_asked(const Options& options) {
  std::vector<Method> out;
  for (const Method m : kMethods)
    if (asked(options.methods, key_of(m))) out.push_back(m);
  return out;
}

Row rate_row(Method method, const Shape& shape, std::string_view task, double voxel_mm, const Options& options) {
  Row row;
  row.method = key_of(method);
  row.shape = shape.name();
  row.task = task;
  row.bur_radius_mm = shape.bur_radius_mm();
  row.voxel_mm = voxel_mm;
  row.seed = static_cast<std::int64_t>(options.seed);
  row.unresolved = shape.unresolved(voxel_mm);
  return row;
}

/// Writes the paces into the rows, with ratios if the occupancy proxy ran.
void fill_rates(std::vector<Row>& rows, const std::vector<Method>& methods, const std::vector<const Pace*>& paces) {
  for (std::size_t i = 0; i < rows.size(); ++i) paces[i]->fill(rows[i]);
  for (std::size_t reference = 0; reference < methods.size(); ++reference) {
    if (methods[reference] != Method::occupancy) continue;
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].ratio_to_occupancy = ratio_of(*paces[i], *paces[reference]);
  }
}

std::vector<Row> slide_rows(const Shape& shape, std::string_view task, double speed, double voxel_mm,
                            const Options& options) {
  const bool clear = task == "displacement";
  const std::vector<StepInput> inputs = clear ? clear_inputs(shape, speed, options.seed, kRateTrackTicks)
                                              : slide_inputs(shape, speed, options.seed, kRateTrackTicks);
  const std::vector<Method> methods = methods_asked(options);
  std::vector<Lane> lanes;
  lanes.reserve(methods.size());
  for (const Method method : methods) {
    Lane& lane = lanes.emplace_back(Lane{StepState(scene_of(shape, method, voxel_mm)), Track(inputs), {}});
    if (!shape.prepare(lane.state)) throw std::runtime_error("no room to prepare " + shape.name());
    bring(lane.state, step, shape, shape.before(inputs.front().position_mm()));
    lead(lane.state, step, inputs.front().position_mm(), speed * 1e-3);
  }
  run_lanes(lanes, options.budget_s);
  std::vector<Row> rows;
  std::vector<const Pace*> paces;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    Row& row = rows.emplace_back(rate_row(methods[i], shape, task, voxel_mm, options));
    row.motion = "slide";
    row.speed_mm_s = speed;
    const Pace& pace = lanes[i].pace;
    if (clear && methods[i] == Method::surface && pace.untimed > 0)
      row.cached_share = static_cast<double>(pace.free) / static_cast<double>(pace.untimed);
    paces.push_back(&pace);
  }
  fill_rates(rows, methods, paces);
  return rows;
}

/// In and out of holes that the bur cut, 0.1 mm aside, from the end until the centre of the ball passes the face.
std::vector<Row> channel_rate_rows(double radius, HoleKind kind, double speed, double voxel_mm, const Options& options) {
  const std::vector<Method> methods = methods_asked(options);
  const auto holes = unambiguous_holes(radius, kind, options.seed, kHolesAKind);
  std::vector<Pace> all(methods.size());
  for (const auto& hole : holes) {
    Random none(0);
    const Leg leg = hole->leg(none, nullptr);
    const double inside = length(hole->outside() - hole->bottom()) - 3.0 * radius;
    std::vector<StepInput> inputs;
    for (double s = 0.0; s <= inside; s += speed * kTickUs * 1e-6) inputs.push_back(input_at(leg.at(s)));
    std::vector<Lane> lanes;
    lanes.reserve(methods.size());
    for (const Method method : methods) {
      Lane& lane = lanes.emplace_back(Lane{StepState(scene_of(*hole, method, voxel_mm)), Track(inputs), {}});
      if (!hole->prepare(lane.state)) throw std::runtime_error("no room to prepare channel");
      bring(lane.state, step, *hole, hole->outside());
      lead(lane.state, step, hole->bottom(), 0.02);
      lead(lane.state, step, inputs.front().position_mm(), 0.02);
    }
    run_lanes(lanes, options.budget_s / kHolesAKind);
    for (std::size_t i = 0; i < lanes.size(); ++i) all[i].append(lanes[i].pace);
  }
  std::vector<Row> rows;
  std::vector<const Pace*> paces;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    Row& row = rows.emplace_back(rate_row(methods[i], *holes.front(), "exploration", voxel_mm, options));
    row.variant = name_of(kind);
    row.motion = "slide";
    row.speed_mm_s = speed;
    paces.push_back(&all[i]);
  }
  fill_rates(rows, methods, paces);
  return rows;
}

/// Blocks have a fixed number of ticks, because each pass ends; passes start at different spots.
std::vector<Row> perforation_rows(const Shape& face, double voxel_mm, const Options& options) {
  const std::vector<Method> methods = methods_asked(options);
  std::vector<Pace> all(methods.size());
  const auto start = Clock::now();
  for (std::uint64_t pass = 0; pass == 0 || std::chrono::duration<double>(Clock::now() - start).count() <
                                                options.budget_s * static_cast<double>(methods.size());
       ++pass) {
    std::vector<Perforation> runs;
    runs.reserve(methods.size());
    for (const Method method : methods) runs.emplace_back(method, face, voxel_mm, options.seed + pass);
    for (int done = 0; done < Perforation::kTicks; done += 2 * kPerforationBlock)
      for (std::size_t i = 0; i < methods.size(); ++i) {
        Perforation& run = runs[i];
        Pace& pace = all[i];
        std::array<StepInput, kPerforationBlock> inputs;
        for (StepInput& input : inputs) input = run.next();
        const double before = core_time_s();
        for (const StepInput& input : inputs) step(run.state(), input);
        pace.rates.push_back(kPerforationBlock / (core_time_s() - before));
        pace.untimed += kPerforationBlock;
        for (int k = 0; k < kPerforationBlock; ++k) {
          const StepInput input = run.next();
          const auto a = Clock::now();
          step(run.state(), input);
          const auto b = Clock::now();
          pace.times.add_ns(std::chrono::duration_cast<std::chrono::nanoseconds>(b - a).count());
        }
      }
  }
  std::vector<Row> rows;
  std::vector<const Pace*> paces;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    Row& row = rows.emplace_back(rate_row(methods[i], face, "perforation", voxel_mm, options));
    row.speed_mm_s = kAdvanceMmS;
    paces.push_back(&all[i]);
  }
  fill_rates(rows, methods, paces);
  return rows;
}

void print_bur_mills(const std::vector<Row>& rows) {
  fmt::print("{:<28}{:<8}{:>6}{:>10}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>10}{:>10}\n", "bur", "axis", "min", "mean us", "p50", "p99", "p99.9",
             "p99.99", "max", "work us", "deferred%", "ticks");
  for (const Row& r : rows)
    fmt::print("{:<28}{:<8}{:>6.3g}{:>10.1f}{:>9.1f}{:>9.1f}{:>9.1f}{:>9.1f}{:>9.1f}{:>9.1f}{:>10.3f}{:>10}\n", r.bur, r.axis, r.minutes,
               r.tick_us_mean, r.tick_us_p50, r.tick_us_p99, r.tick_us_p999, r.tick_us_p9999, r.tick_us_max, r.work_us_max,
               r.deferred_percent, r.samples);
}

void print_rates(const std::vector<Row>& rows) {
  if (!rows.empty() && !rows.front().bur.empty()) return print_bur_mills(rows);
  fmt::print("{:<13}{:<10}{:>6}{:>8}  {:<16}{:>11}{:>9}{:>9}{:>9}{:>10}{:>10}\n", "task", "shape", "r", "voxel",
             "method", "updates/s", "ratio", "p50 us", "p99", "p99.9", "max");
  for (const Row& r : rows)
    fmt::print("{:<13}{:<10}{:>6.2f}{:>8.3f}  {:<16}{:>11.0f}{:>9.3g}{:>9.2f}{:>9.2f}{:>10.2f}{:>10.1f}\n",
               r.task, r.variant.empty() ? r.shape : r.variant, r.bur_radius_mm, r.voxel_mm, r.method, r.updates_per_s,
               r.ratio_to_occupancy, r.tick_us_p50, r.tick_us_p99, r.tick_us_p999, r.tick_us_max);
}

}  // namespace

std::vector<StepInput> slide_inputs(const Shape& shape, double speed_mm_s, std::uint64_t seed, std::size_t ticks) {
  Slide slide(shape, speed_mm_s, seed);
  std::vector<StepInput> out;
  for (std::size_t k = 0; k < ticks; ++k) out.push_back(input_at(slide.next()));
  return out;
}

std::vector<StepInput> clear_inputs(const Shape& shape, double speed_mm_s, std::uint64_t seed, std::size_t ticks) {
  const auto lifted = [&shape](Vec3 p) {
    // The gradient of the distance is the normal; the distance is exact near the surface.
    constexpr double kStep = 1e-4;
    Vec3 n(0.0);
    for (int a = 0; a < 3; ++a) {
      Vec3 d(0.0);
      d[a] = kStep;
      n[a] = shape.distance_mm(p + d) - shape.distance_mm(p - d);
    }
    return p + unit(n) * (shape.bur_radius_mm() + kClearMm - shape.distance_mm(p));
  };
  // Around a convex shape the lifted path is longer, so the slide below is slower by the same ratio.
  Slide trial(shape, speed_mm_s, seed);
  double below = 0.0, above = 0.0;
  Vec3 last = trial.next();
  for (std::size_t k = 1; k < ticks; ++k) {
    const Vec3 p = trial.next();
    below += length(p - last);
    above += length(lifted(p) - lifted(last));
    last = p;
  }
  Slide slide(shape, speed_mm_s * below / above, seed);
  std::vector<StepInput> out;
  for (std::size_t k = 0; k < ticks; ++k) out.push_back(input_at(lifted(slide.next())));
  return out;
}

std::vector<Row> rate_rows(const Options& options) {
  if (options.full || !options.burs.empty()) return asked(options.tasks, "mill") ? bur_mill_rows(options) : std::vector<Row>{};
  std::vector<Row> rows;
  const auto add = [&rows](std::vector<Row> more) { rows.insert(rows.end(), more.begin(), more.end()); };
  for (const RateTask& task : standard_tasks()) {
    if (!asked(options.tasks, task.task) || !asked(options.shapes, task.shape)) continue;
    if (!asked(options.motions, "slide") && task.task != "perforation") continue;
    // Tasks at other voxel sizes serve the chart; filters apply to the first ones.
    const bool usual = task.voxels_mm.size() == 1;
    if (!usual && !(options.voxels_mm.empty() && options.bur_radii_mm.empty())) continue;
    for (const double voxel : usual ? chosen(options.voxels_mm, task.voxels_mm) : task.voxels_mm)
      for (const double radius : chosen(options.bur_radii_mm, task.radii)) {
        if (task.shape == "channel") {
          for (const double speed : chosen(options.speeds_mm_s, {kRateSpeedMmS}))
            for (const HoleKind kind : {HoleKind::straight, HoleKind::oblique, HoleKind::slot})
              add(channel_rate_rows(radius, kind, speed, voxel, options));
          continue;
        }
        const std::unique_ptr<Shape> shape = make_shape(task.shape, radius);
        if (task.task == "perforation") {
          add(perforation_rows(*shape, voxel, options));
          continue;
        }
        for (const double speed : chosen(options.speeds_mm_s, {kRateSpeedMmS}))
          add(slide_rows(*shape, task.task, speed, voxel, options));
      }
  }
  if (asked(options.tasks, "mill") && asked(options.shapes, "cavity") && options.motions.empty()) add(mill_rows(options));
  return rows;
}

int run_rate(const Options& options) {
  if (!pin_to_core()) std::cerr << "cusp-bench: this thread could not be kept on one core\n";
  Report report = empty_report();
  report.rows = rate_rows(options);
  return write_report(report, options.json, print_rates);
}

}  // namespace cusp::bench
