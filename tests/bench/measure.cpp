#include "tests/bench/measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "tests/bench/candidates.h"
#include "tests/bench/frame.h"
#include "tests/bench/tick_times.h"

namespace cusp::bench {

namespace {

constexpr double kDegrees = 57.295779513082320877;
constexpr double kPressAboveMm = 0.05;        // where a press starts
constexpr double kPressStepMm = 0.05;        // a tick: 50 mm/s
constexpr double kNotFiniteMm = 1000.0;  // error of a value that is not a number
constexpr int kPressRestTicks = 10;           // before the sample: some methods arrive late
constexpr double kNoBudgetS = 1e6;            // samples end a row long before
constexpr int kFollowMost = 100;         // ticks; a later method counts as wrong

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

StepOutput timed(const Measure& what, StepState& state, const StepInput& input, TickTimes& times) {
  const auto before = Clock::now();
  const StepOutput out = what.stepper(state, input);
  times.add_ns(std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - before).count());
  return out;
}

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// True if the exact force is too small for a sample.
bool too_small(const Exact& exact, Vec3 device) {
  return !exact.contact || length(exact.pose_mm - device) < kLeastSpringMm;
}

}  // namespace

Measure measure_of(const Options& options) {
  Measure out;
  out.budget_s = options.budget_s;
  out.seed = options.seed;
  if (options.samples > 0) {
    out.budget_s = kNoBudgetS;
    out.most_ticks = options.samples;
  }
  return out;
}

void Errors::add(const StepOutput& out, const Exact& exact, double clearance_mm) {
  if (!finite(out.force_raw_n) || !finite(out.proxy_mm)) {
    StepOutput nothing = out;
    nothing.force_raw_n = Vec3(0.0);
    nothing.proxy_mm = exact.pose_mm + Vec3(kNotFiniteMm, 0.0, 0.0);
    add(nothing, exact, kNotFiniteMm);
    return;
  }
  const Vec3 force = out.force_raw_n;
  const Vec3 wanted = exact.pose_mm - out.device_mm;  // 1 N/mm
  const double sine = length(glm::cross(force, wanted)), cosine = glm::dot(force, wanted);
  angle_deg_.push_back(length(force) > 1e-9 ? std::atan2(sine, cosine) * kDegrees : 90.0);
  depth_um_.push_back(std::fabs(clearance_mm) * 1000.0);
  pose_um_.push_back(length(out.proxy_mm - exact.pose_mm) * 1000.0);
  error2_ += glm::dot(force - wanted, force - wanted);
  exact2_ += glm::dot(wanted, wanted);
  if (steady_) step_mn_.push_back((length(force - last_force_) - length(wanted - last_exact_)) * 1000.0);
  steady_ = true;
  last_force_ = force;
  last_exact_ = wanted;
}

void Errors::fill(Row& row) {
  row.samples = static_cast<std::int64_t>(angle_deg_.size());
  row.skipped = skipped_;
  row.infeasible_ticks = infeasible_;
  if (!follow_.empty()) row.follow_ticks = mean(follow_);
  if (angle_deg_.empty()) return;
  row.angle_deg_mean = mean(angle_deg_);
  row.angle_deg_p95 = percentile(angle_deg_, 0.95);
  row.angle_deg_p99 = percentile(angle_deg_, 0.99);
  row.angle_deg_max = angle_deg_.back();
  row.depth_um_mean = mean(depth_um_);
  row.depth_um_p95 = percentile(depth_um_, 0.95);
  row.depth_um_max = depth_um_.back();
  row.pose_um_mean = mean(pose_um_);
  row.pose_um_p95 = percentile(pose_um_, 0.95);
  row.pose_um_max = pose_um_.back();
  row.force_error_percent_rms = 100.0 * std::sqrt(error2_ / exact2_);
  if (step_mn_.empty()) return;
  row.force_step_excess_mn_p99 = percentile(step_mn_, 0.99);
  row.force_step_excess_mn_max = step_mn_.back();
}

Row row_of(const Shape& shape, const Measure& what, std::string_view motion) {
  Row row;
  row.method = key_of(what.method);
  row.shape = shape.name();
  row.variant = shape.variant();
  row.motion = motion;
  if (motion == "slide") row.speed_mm_s = what.speed_mm_s;
  row.bur_radius_mm = shape.bur_radius_mm();
  row.voxel_mm = what.voxel_mm;
  row.seed = static_cast<std::int64_t>(what.seed);
  row.unresolved = shape.unresolved(what.voxel_mm);
  return row;
}

Row measure_slide(const Shape& shape, const Measure& what) {
  StepState state(scene_of(shape, what.method, what.voxel_mm));
  shape.prepare(state);
  const std::unique_ptr<Truth> truth = shape.truth();
  Slide slide(shape, what.speed_mm_s, what.seed);
  const Vec3 first = slide.next();
  const Vec3 before = shape.before(first);
  bring(state, what.stepper, shape, before);
  lead(state, what.stepper, first, kPressStepMm);
  truth->start(before);
  truth->follow(input_at(first).position_mm());

  Errors errors;
  TickTimes times;
  times.reserve(static_cast<std::size_t>(what.most_ticks));
  const double near = std::max(0.05, what.voxel_mm);
  bool with_exact = false;
  int following = -1;  // ticks since a minimum vanished that the method shared; -1: none
  const auto end = Clock::now() + std::chrono::duration<double>(what.budget_s);
  for (std::int64_t tick = 0; tick < what.most_ticks; ++tick) {
    if (tick % 64 == 0 && Clock::now() >= end) break;
    const StepInput input = input_at(slide.next());
    const StepOutput out = timed(what, state, input, times);
    const Exact exact = truth->follow(input.position_mm());
    errors.note(out);
    if (exact.vanished && with_exact) following = 0;
    with_exact = length(out.proxy_mm - exact.pose_mm) <= near;
    if (following >= 0) {
      if (with_exact || following == kFollowMost) {
        errors.followed(following);
        following = -1;
      } else {
        ++following;
        errors.skip();
        continue;
      }
    }
    if (too_small(exact, out.device_mm)) {
      errors.skip_small();
      continue;
    }
    errors.add(out, exact, truth->clearance_mm(out.proxy_mm));
  }
  Row row = row_of(shape, what, "slide");
  errors.fill(row);
  times.fill(row);
  row.max_candidates = most_candidates(state);
  return row;
}

Row measure_presses(const Shape& shape, const Measure& what) {
  StepState state(scene_of(shape, what.method, what.voxel_mm));
  shape.prepare(state);
  const std::unique_ptr<Truth> truth = shape.truth();
  Random random(what.seed);
  Errors errors;
  TickTimes times;
  const auto end = Clock::now() + std::chrono::duration<double>(what.budget_s);
  for (int k = 0; k < std::min<std::int64_t>(kPresses, what.most_ticks) && Clock::now() < end; ++k) {
    const Spot spot = shape.spot(random);
    const Vec3 above = spot.centre + spot.normal * kPressAboveMm;
    bring(state, what.stepper, shape, above);
    const Vec3 target = spot.centre - spot.normal * kDepthMm;
    const int ticks = static_cast<int>(std::ceil(length(target - above) / kPressStepMm));
    StepOutput out;
    for (int t = 1; t <= ticks + kPressRestTicks; ++t) {
      const double share = std::min(1.0, static_cast<double>(t) / ticks);
      out = timed(what, state, input_at(above + (target - above) * share), times);
      errors.note(out);
    }
    truth->start(spot.centre);
    const Exact exact = truth->follow(out.device_mm);
    errors.skip();
    if (too_small(exact, out.device_mm)) {
      errors.skip_small();
    } else {
      errors.add(out, exact, truth->clearance_mm(out.proxy_mm));
    }
  }
  Row row = row_of(shape, what, "press");
  errors.fill(row);
  times.fill(row);
  row.max_candidates = most_candidates(state);
  return row;
}

}  // namespace cusp::bench
