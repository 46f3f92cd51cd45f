#include "tests/bench/stability_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "tests/bench/frame.h"
#include "tests/bench/tick_times.h"

namespace cusp::bench {

namespace {

constexpr double kGravity = 9.81;  // N/kg
constexpr int kWindowMs = static_cast<int>(lab::Steadiness::kWindowS * 1000.0);

/// Force times travel of a millisecond without an answer.
double late_mj_of(const lab::LoopTick& tick) {
  return tick.answers == 0 ? length(tick.held_n) * length(tick.to_mm - tick.from_mm) : 0.0;
}

double larger(double a, double b) { return std::isnan(a) ? b : std::max(a, b); }

/// Sets the hand's intent of each millisecond and calls tick(ms), for the motion and the rest.
template <class Tick>
lab::Steadiness run_intent(lab::ClosedLoop& loop, const Intent& intent, int ms, Tick&& tick) {
  lab::Steadiness steady;
  for (int t = 0; t < ms + kHoldMs; ++t) {
    const Vec3 now = intent(std::min(t, ms)), next = intent(std::min(t + 1, ms));
    loop.plant().intend(now, (next - now) / lab::kTickS);
    steady.add(tick(t),
               t >= ms + kHoldMs - kWindowMs ? lab::Steadiness::Part::in_window : lab::Steadiness::Part::before_window);
  }
  return steady;
}

}  // namespace

std::shared_ptr<Scene> stability_scene(const Shape& shape, Method method, double voxel_mm, GuardUse guard,
                                       double delay_ms) {
  auto scene = scene_of(shape, method, voxel_mm);
  for (TissueFeel& feel : scene->tissues) feel = {kStabilityNPerMm, 1.0};
  scene->guard = guard == GuardUse::on ? GuardSettings{} : unguarded();
  if (guard == GuardUse::on) {
    scene->guard.limit_n = lab::falcon({}).limit_n;
    scene->guard.delay_ms = delay_ms;
  }
  return scene;
}

lab::DeviceSettings Setting::device() const {
  lab::DeviceSettings out = lab::falcon({mass_kg, damping_ns_per_m, friction_n});
  if (weighs) out.weight_n = Vec3(0.0, 0.0, -kGravity * mass_kg);
  return out;
}

lab::Grip Setting::hand() const {
  return grip == "soft" ? lab::kSoftGrip : grip == "firm" ? lab::kFirmGrip : lab::kNoGrip;
}

lab::TransportSettings Setting::transport(std::uint64_t seed) const {
  lab::TransportSettings out;
  out.delay_ms = delay_ms;
  out.seed = seed;
  return out;
}

std::string device_name(double mass_kg, double damping_ns_per_m) {
  return fmt::format("m{:g}-b{:g}", mass_kg, damping_ns_per_m);
}

void name_setting(Row& row, const Setting& setting) {
  row.grip = setting.grip;
  if (!setting.in_loop()) return;
  row.device = device_name(setting.mass_kg, setting.damping_ns_per_m);
  row.mass_kg = setting.mass_kg;
  row.damping_n_s_m = setting.damping_ns_per_m;
  row.friction_n = setting.friction_n;
  row.delay_ms = setting.delay_ms;
}

int stuck_for_ms(int watched_ms) {
  const int behind = watched_ms - (lab::StuckWatch::kWindowMs - 1);
  return behind >= lab::StuckWatch::kWindowMs ? behind : 0;
}
int stuck_for_ms(const lab::StuckWatch& watch) { return stuck_for_ms(watch.stuck_ms()); }

void Tally::begin() {
  run_.clear();
  stuck_ = {};
  energy_ = exact_energy_ = left_ = exact_left_ = {};
  through_ = was_stuck_ = false;
  run_late_mj_ = 0.0;
}

void Tally::add(const StepOutput& out, const Exact& exact, const Contact& contact) {
  ++ticks_;
  const bool apart = !(length(out.proxy_mm - exact.pose_mm) <= contact.near_mm);
  run_.push_back({out.force_n, contact.exact_n, out.guard_acts != 0, apart, exact.vanished});
  if (out.faulted) {
    // A latched fault holds the proxy, which does not count as stuck.
    note_stuck();
  } else {
    stuck_.add(exact.pose_mm, out.proxy_mm);
  }
  penetration_.add(contact.clearance_mm);
  add_force(out);
  if (!(contact.clearance_mm > -contact.bur_radius_mm)) through_ = true;
}

void Tally::interrupt() {
  if (!run_.empty()) run_.back().ends = true;
}

void Tally::note_steps() {
  // Skips the ticks around a vanished minimum in which both proxies stand apart.
  const std::size_t n = run_.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!run_[i].vanished) continue;
    run_[i].skip = true;
    for (std::size_t k = i; k > 0 && i - k < kSooner && run_[k - 1].apart; --k) run_[k - 1].skip = true;
    for (std::size_t k = i; k < n && k - i < kLater; ++k) {
      run_[k].skip = true;
      if (!run_[k].apart) break;
    }
  }
  steps_.interrupt();
  bool acted = false;
  for (const Moment& m : run_) {
    // The guard also owns the rise after a tick that it limited.
    const bool guarded = m.acted || acted;
    if (m.skip && !guarded) steps_.interrupt();
    const auto step = steps_.add({m.force_n, m.exact_n, guarded});
    if (step) step_mn_.push_back(*step);
    if (m.ends) steps_.interrupt();
    acted = m.acted;
  }
}

void Tally::note_stuck() {
  const int ms = stuck_for_ms(stuck_);
  was_stuck_ = was_stuck_ || ms > 0;
  stuck_ms_ = std::max(stuck_ms_, ms);
  stuck_ = {};
}

void Tally::add_force(const StepOutput& out) { force_max_n_ = std::max(force_max_n_, length(out.force_n)); }

void Tally::add_loop(const lab::LoopTick& tick) {
  energy_.add(tick);
  left_.add(lab::ContactEnergy::Share{tick.held_any, tick.energy_mj - late_mj_of(tick)});
  run_late_mj_ += late_mj_of(tick);
}

void Tally::add_exact_loop(const lab::LoopTick& tick) {
  exact_energy_.add(tick);
  exact_left_.add(lab::ContactEnergy::Share{tick.held_any, tick.energy_mj - late_mj_of(tick)});
}

void Tally::add_rest(const lab::Steadiness& steady) {
  const double um = 1000.0 * steady.peak_to_peak_mm();
  if (std::isnan(cycle_um_) || um > cycle_um_) {
    cycle_um_ = um;
    cycle_hz_ = steady.cycle_hz();
  }
}

void Tally::add_exact_rest(const lab::Steadiness& steady) {
  exact_cycle_um_ = larger(exact_cycle_um_, 1000.0 * steady.peak_to_peak_mm());
}

void Tally::end() {
  ++runs_;
  note_steps();
  note_stuck();
  passed_ += through_ ? 1 : 0;
  stuck_runs_ += was_stuck_ ? 1 : 0;
  late_mj_ = std::max(late_mj_, run_late_mj_);
  if (energy_.episodes() > 0) energy_mj_ = larger(energy_mj_, energy_.most_mj());
  if (left_.episodes() > 0) left_mj_ = larger(left_mj_, left_.most_mj());
  if (exact_left_.episodes() > 0) exact_left_mj_ = larger(exact_left_mj_, exact_left_.most_mj());
  if (exact_energy_.episodes() > 0) exact_energy_mj_ = larger(exact_energy_mj_, exact_energy_.most_mj());
}

void Tally::fill(Row& row) {
  row.samples = ticks_;
  row.runs = runs_;
  row.energy_mj = energy_mj_;
  row.energy_exact_mj = exact_energy_mj_;
  if (late_mj_ > 0.0) {
    row.late_mj = late_mj_;
    row.energy_left_mj = left_mj_;
    row.energy_exact_left_mj = exact_left_mj_;
  }
  row.cycle_um = cycle_um_;
  row.cycle_hz = cycle_hz_;
  row.cycle_exact_um = exact_cycle_um_;
  row.force_max_n = force_max_n_;
  row.force_step_mn = steps_.force_step_mn();
  if (!step_mn_.empty()) row.force_step_p99_mn = std::max(0.0, percentile(step_mn_, 0.99));
  row.guard_step_mn = steps_.guard_step_mn();
  row.penetration_um = penetration_.most_um();
  row.passed_through = passed_;
  row.stuck = stuck_runs_;
  row.stuck_ms = stuck_ms_;
}

Pair::Pair(const Shape& shape, std::shared_ptr<const Scene> scene)
    : shape_(shape), state_(std::move(scene)), truth_(shape.truth()), radius_mm_(shape.bur_radius_mm()) {
  shape.prepare(state_);
}

void Pair::bring(Vec3 centre) {
  const auto rearmed = [](StepState& state, const StepInput& input) {
    StepInput with = input;
    if (state.fault() != Fault::none) with.buttons |= StepInput::kRearm;
    return step(state, with);
  };
  cusp::bench::bring(state_, rearmed, shape_, centre);
  const int ramp = state_.scene().guard.has(GuardPart::ramp_in) ? static_cast<int>(state_.scene().guard.ramp_in_ms) : 0;
  for (int k = 0; k <= ramp; ++k) rearmed(state_, input_at(centre));
  truth_->start(input_at(centre).position_mm());
}

void Pair::replace(std::unique_ptr<Truth> truth, double bur_radius_mm) {
  truth->start(truth_->exact().pose_mm);
  truth_ = std::move(truth);
  radius_mm_ = bur_radius_mm;
}

StepInput Pair::rearmed(StepInput input) {
  faulted_ = state_.fault() == Fault::none ? 0 : faulted_ + 1;
  if (faulted_ > kRearmTicks) input.buttons |= StepInput::kRearm;
  return input;
}

StepOutput Pair::tick(const StepInput& given, Tally& tally) {
  StepInput input = given;
  if (!named_.empty()) {
    input.fragment = named_.front();
    named_.erase(named_.begin());
  }
  const StepOutput out = step(state_, input);
  const Exact exact = truth_->follow(input.position_mm());
  const double k = stiffness ? stiffness(exact, out) : kStabilityNPerMm;
  exact_n_ = exact.contact ? k * (exact.pose_mm - input.position_mm()) : Vec3(0.0);
  tally.add(out, exact,
            {.exact_n = exact_n_,
             .clearance_mm = truth_->clearance_mm(out.proxy_mm),
             .bur_radius_mm = radius_mm_,
             .near_mm = std::max(0.05, state_.volume().grid().voxel_mm)});
  if (behind && behind(out.proxy_mm)) tally.mark_passed();
  return out;
}

void run_hand(Pair& pair, const Shape& shape, const Setting& setting, Vec3 start, const Intent& intent, int ms,
              std::uint64_t seed, Tally& tally, const Events& events) {
  Random random(seed);
  const Vec3 phase = random.in(Vec3(0.0), Vec3(1.0));
  {
    lab::ClosedLoop loop(setting.device(), setting.transport(seed), setting.hand(), start, phase);
    tally.add_rest(run_intent(loop, intent, ms, [&](int t) {
      if (events.method) events.method(t, pair, loop);
      const lab::LoopTick tick = loop.tick(
          [&](const lab::Reading& reading) { return pair.tick(pair.rearmed(input_of(reading)), tally).force_n; });
      tally.add_loop(tick);
      return tick;
    }));
  }
  std::unique_ptr<Truth> own = shape.truth();
  own->start(start);
  lab::ClosedLoop loop(setting.device(), setting.transport(seed), setting.hand(), start, phase);
  tally.add_exact_rest(run_intent(loop, intent, ms, [&](int t) {
    if (events.exact) events.exact(t, own, loop);
    const lab::LoopTick tick = loop.tick([&](const lab::Reading& reading) {
      const Exact exact = own->follow(reading.position_mm());
      const double k = pair.stiffness ? pair.stiffness(exact, StepOutput{}) : kStabilityNPerMm;
      return exact.contact ? k * (exact.pose_mm - reading.position_mm()) : Vec3(0.0);
    });
    tally.add_exact_loop(tick);
    return tick;
  }));
}

double depth_for(const Setting& setting, double force_n, double k_n_per_mm) {
  const lab::Grip hand = setting.hand();
  return force_n / k_n_per_mm + (hand.holds() ? force_n / hand.stiffness_n_per_mm : 0.0);
}

}  // namespace cusp::bench
