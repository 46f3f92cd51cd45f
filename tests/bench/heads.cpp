#include "tests/bench/heads.h"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "scenarios/burs/bur_catalogue.h"
#include "tests/bench/candidates.h"
#include "tests/bench/head_courses.h"
#include "tests/bench/pin.h"
#include "tests/bench/tick_times.h"

namespace cusp::bench {

namespace {

constexpr double kHeadVoxelMm = 10.0 / 128;
constexpr int kTilts = 3;
constexpr double kLeadMm = 0.05;    // a tick, into a place
constexpr double kLeadFarMm = 0.5;  // between two places
constexpr int kHeadRestTicks = 10;  // at the end of a press
constexpr int kLatestFollow = 100;  // ticks after a vanished minimum; a later method counts as wrong

std::shared_ptr<Scene> scene_of(const HeadCourse& course, const Bur& bur, double voxel_mm) {
  auto scene = std::make_shared<Scene>();
  scene->method = Method::surface;
  scene->specimen = course.specimen(voxel_mm);
  scene->burs = {bur};
  scene->tool_axis = course.rest_axis();
  scene->tilt_cosine = 0.5;  // 60 degrees: beyond every course
  for (TissueFeel& feel : scene->tissues) feel = {1.0, 1.0};
  scene->guard = unguarded();
  scene->guard.jump_mm = 1e6;
  return scene;
}

/// A tick of the method: its answer, and the axis that its input asked for.
struct HeadTick {
  StepOutput out;
  Vec3 axis{0.0};
};

/// A state on a course, with the axis in motion.
struct HeadRun {
  HeadRun(const HeadCase& of, const Bur& bur, const Measure& measure, std::uint64_t seed)
      : what(measure),
        course(make_course(of.shape, bur, seed)),
        axis(course->axis_motion(of.axis, seed)),
        state(scene_of(*course, bur, measure.voxel_mm)) {
    if (!course->prepare(state)) throw std::runtime_error("no room to mill a slot");
  }
  HeadTick tick(Vec3 device, Vec3 wanted_axis) {
    const StepInput input = turned_input(device, course->rest_axis(), wanted_axis);
    const double before = core_time_s();
    HeadTick out{what.stepper(state, input), axis_of_input(input, course->rest_axis())};
    times.add_ns(static_cast<std::int64_t>((core_time_s() - before) * 1e9));
    out.out.device_mm = input.position_mm();
    return out;
  }
  /// Straight to a place with the axis as it is; not timed.
  void lead(Vec3 to, double per_tick_mm) {
    const Vec3 from = state.last().tick == 0 ? to : state.last().device_mm;
    const int ticks = static_cast<int>(length(to - from) / per_tick_mm) + 1;
    for (int k = 1; k <= ticks; ++k)
      what.stepper(
          state, turned_input(from + (to - from) * (static_cast<double>(k) / ticks), course->rest_axis(), axis.now()));
  }
  /// The axis that the input of axis.now() asks for.
  Vec3 asked_axis() const {
    return axis_of_input(turned_input(Vec3(0.0), course->rest_axis(), axis.now()), course->rest_axis());
  }

  const Measure& what;
  std::unique_ptr<HeadCourse> course;
  AxisMotion axis;
  StepState state;
  TickTimes times;
};

bool is_small(const Exact& exact, Vec3 device) {
  return !exact.contact || length(exact.pose_mm - device) < kLeastSpringMm;
}

/// Errors of a row, and how many of its samples are another minimum's.
struct HeadErrors {
  Errors errors;
  std::int64_t samples = 0, apart = 0;

  void add(const StepOutput& out, const Exact& exact, const HeadTruth& truth, double near_mm) {
    if (is_small(exact, out.device_mm) || !truth.is_valid()) {
      errors.skip_small();
      return;
    }
    errors.add(out, exact, truth.clearance_mm(out.proxy_mm));
    ++samples;
    apart += length(out.proxy_mm - exact.pose_mm) <= near_mm ? 0 : 1;
  }
};

double near_mm(const Measure& what) { return std::max(0.05, what.voxel_mm); }

/// Compares a slide's ticks with the exact proxy until `end`.
void compare(HeadTruth& truth, const std::vector<HeadTick>& ticks, double near, Clock::time_point end,
             HeadErrors& all) {
  Errors& errors = all.errors;
  bool with_exact = false;
  int following = -1;  // ticks since a minimum vanished that the method shared; -1: none
  errors.skip();
  for (const HeadTick& tick : ticks) {
    if (Clock::now() >= end) return;
    const Exact exact = truth.follow(tick.out.device_mm, tick.axis);
    errors.note(tick.out);
    if (exact.vanished && with_exact) following = 0;
    with_exact = length(tick.out.proxy_mm - exact.pose_mm) <= near;
    if (following >= 0 && !with_exact && following < kLatestFollow) {
      ++following;
      errors.skip();
      continue;
    }
    if (following >= 0) errors.followed(following);
    following = -1;
    all.add(tick.out, exact, truth, near);
  }
}

Clock::time_point after(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

void slide(HeadRun& run, double budget_s, HeadErrors& errors) {
  const std::unique_ptr<HeadTruth> truth = run.course->truth();
  const Vec3 axis = run.asked_axis();
  const std::vector<Vec3> way = run.course->way_in(axis);
  for (const Vec3& to : way) run.lead(to, kLeadMm);
  const double per_tick = run.what.speed_mm_s * kTickUs * 1e-6;
  const Vec3 first = run.course->next(axis, per_tick);
  run.lead(first, kLeadMm);
  truth->start(way.back(), axis);
  truth->follow(run.state.last().device_mm, axis);

  std::vector<HeadTick> ticks;
  const auto end = after(0.5 * budget_s);
  for (std::int64_t k = 0; k < run.what.most_ticks && (k % 64 != 0 || Clock::now() < end); ++k) {
    const Vec3 wanted = run.axis.next();
    ticks.push_back(run.tick(run.course->next(run.asked_axis(), per_tick), wanted));
  }
  compare(*truth, ticks, near_mm(run.what), after(0.5 * budget_s), errors);
}

/// From 50 um above a random place to kDepthMm below the offset surface at 50 mm/s, then rest; the last tick counts.
void press(HeadRun& run, double budget_s, HeadErrors& all) {
  const std::unique_ptr<HeadTruth> truth = run.course->truth();
  Random random(run.what.seed);
  const auto end = after(budget_s);
  for (std::int64_t k = 0; k < std::min<std::int64_t>(kPresses, run.what.most_ticks) && Clock::now() < end; ++k) {
    run.axis.next();
    const Vec3 axis = run.asked_axis();
    const Spot spot = run.course->spot(axis, random);
    const Vec3 above = spot.centre + spot.normal * kLeadMm, below = spot.centre - spot.normal * kDepthMm;
    if (run.state.last().tick != 0) run.lead(run.state.last().proxy_mm + run.course->rest_axis() * 8.0, kLeadFarMm);
    run.lead(above + run.course->rest_axis() * 8.0, kLeadFarMm);
    run.lead(above, kLeadFarMm);
    truth->start(above, axis);
    const int ticks = static_cast<int>(std::ceil(length(below - above) / kLeadMm));
    HeadTick last;
    Exact exact;
    for (int t = 1; t <= ticks + kHeadRestTicks; ++t) {
      const double share = std::min(1.0, static_cast<double>(t) / ticks);
      last = run.tick(above + (below - above) * share, run.axis.next());
      exact = truth->follow(last.out.device_mm, last.axis);
      all.errors.note(last.out);
    }
    all.errors.skip();
    all.add(last.out, exact, *truth, near_mm(run.what));
  }
}

void print_heads(const std::vector<Row>& rows) {
  fmt::print(
      "{:24} {:7} {:8} {:6} {:>4} {:>7} {:>7} {:>6} | {:>8} {:>8} {:>8} | {:>8} {:>8} {:>8} {:>6} | {:>8} {:>8} | "
      "{:>6} {:>7} {:>7}\n",
      "bur", "shape", "axis", "motion", "mm/s", "samples", "skipped", "infeas", "deg", "p95", "max", "pose um", "p95",
      "max", "apart%", "depth um", "max", "p50 us", "p99.9", "kHz");
  for (const Row& r : rows)
    fmt::print(
        "{:24} {:7} {:8} {:6} {:4.0f} {:7} {:7} {:6} | {:8.4f} {:8.3f} {:8.2f} | {:8.3f} {:8.2f} {:8.1f} {:6.1f} | "
        "{:8.3f} {:8.2f} | "
        "{:6.1f} {:7.1f} {:7.1f}\n",
        r.bur, r.shape, r.axis, r.motion, r.speed_mm_s, r.samples, r.skipped, r.infeasible_ticks, r.angle_deg_mean,
        r.angle_deg_p95, r.angle_deg_max, r.pose_um_mean, r.pose_um_p95, r.pose_um_max, r.apart_percent,
        r.depth_um_mean, r.depth_um_max, r.tick_us_p50, r.tick_us_p999, r.updates_per_s * 1e-3);
}

}  // namespace

Row measure_head(const HeadCase& of, std::string_view motion, const Measure& what) {
  const CatalogueBur* entry = catalogue_bur(of.bur);
  if (entry == nullptr || entry->bur.head.ball()) throw std::runtime_error("no head " + std::string(of.bur));
  Row row;
  row.method = key_of(Method::surface);
  row.bur = entry->shape + ' ' + entry->bur.name;
  row.shape = of.shape;
  row.axis = of.axis;
  row.motion = motion;
  if (motion == "slide") row.speed_mm_s = what.speed_mm_s;
  row.bur_radius_mm = entry->bur.radius_mm;
  row.voxel_mm = what.voxel_mm;
  row.seed = static_cast<std::int64_t>(what.seed);
  HeadErrors errors;
  TickTimes times;
  const int runs = of.axis == "turning" && of.shape != "slot" ? 1 : kTilts;
  for (int k = 0; k < runs; ++k) {
    HeadRun run(of, entry->bur, what, what.seed + static_cast<std::uint64_t>(k) * 1000);
    (motion == "press" ? press : slide)(run, what.budget_s / runs, errors);
    times.append(run.times);
    row.max_candidates = std::max(row.max_candidates, most_candidates(run.state));
  }
  errors.errors.fill(row);
  if (errors.samples > 0)
    row.apart_percent = 100.0 * static_cast<double>(errors.apart) / static_cast<double>(errors.samples);
  times.fill(row);
  return row;
}

namespace {

std::vector<std::string_view> burs_asked(const Options& options) {
  if (options.burs.empty()) return {kHeadBurs.begin(), kHeadBurs.end()};
  return {options.burs.begin(), options.burs.end()};
}

void add_cavities(const Options& options, std::vector<Row>& rows) {
  Measure what;
  what.seed = options.seed;
  for (const std::string_view bur : burs_asked(options))
    for (const std::string_view axis : {"fixed", "jitter"})
      for (const double speed : chosen(options.speeds_mm_s, {5.0, 50.0}))
        for (const double minutes : chosen(options.minutes, {0.5}))
          for (const double tremor : chosen(options.tremors_mm, {0.05})) {
            if (!asked(options.axes, axis)) continue;
            what.speed_mm_s = speed;
            rows.push_back(measure_head_cavity({bur, "cavity", axis}, what, {minutes, tremor}));
          }
}

}  // namespace

std::vector<Row> heads_rows(const Options& options) {
  std::vector<Row> rows;
  if (!asked(options.methods, key_of(Method::surface))) return rows;
  Measure what = measure_of(options);
  for (const std::string_view bur : burs_asked(options))
    for (const std::string_view shape : kHeadShapes)
      for (const std::string_view axis : kAxisMotions) {
        if (!asked(options.shapes, shape) || !asked(options.axes, axis)) continue;
        for (const double voxel : chosen(options.voxels_mm, {kHeadVoxelMm})) {
          what.voxel_mm = voxel;
          const HeadCase of{bur, shape, axis};
          if (asked(options.motions, "press") && shape != "slot") rows.push_back(measure_head(of, "press", what));
          if (!asked(options.motions, "slide")) continue;
          for (const double speed : chosen(options.speeds_mm_s, {5.0, 50.0})) {
            what.speed_mm_s = speed;
            rows.push_back(measure_head(of, "slide", what));
          }
        }
      }
  if (!options.shapes.empty() && asked(options.shapes, "cavity")) add_cavities(options, rows);
  return rows;
}

int run_heads(const Options& options) {
  Report report = empty_report();
  report.rows = heads_rows(options);
  return write_report(report, options.json, print_heads);
}

}  // namespace cusp::bench
