#include "tests/bench/stability_kmax.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/frame.h"
#include "tests/bench/motions.h"

namespace cusp::bench {

namespace {

using Verdict = lab::Steadiness::Verdict;

constexpr double kStartAboveMm = 0.25;  // mm above the touch where a run begins
constexpr double kReadyMm = 0.02;  // mm a tick at the end of the approach
constexpr double kLostMm = 10.0;   // mm beyond the press depth: the device has left the place
constexpr double kRestMm = 1e-12;  // mm; rounding of a solver at rest
// mm; a proxy further off has left the place. Across the push: a bur off an edge. Along it: a pivot that overlaps in a
// groove stands two bur radii too deep, which is an overlap and no departure.
constexpr double kLostAsideMm = 0.5, kLostThroughMm = 1.5;
constexpr int kRampTicks = 300;  // longer than GuardSettings::ramp_in_ms
constexpr int kMostApproachTicks = 200;
constexpr int kConfirmPlaces = 10;  // of the grid: 20 %
constexpr int kConfirmStride = 8;   // below those: places that this divides

StepInput rearmed(Vec3 device) {
  StepInput out = input_at(device);
  out.buttons |= StepInput::kRearm;
  return out;
}

}  // namespace

struct PressBench::Inner {
  explicit Inner(const KMaxCase& w) : what(w), place(PressPlace::make(w.place, w.bur_radius_mm)) {
    exact = place->truth();
  }

  /// Makes the state: one for all stiffnesses with the guard off, one for each with it on.
  void make_state(double k) {
    if (state && (what.guard == GuardUse::off || k == guarded_k)) return;
    guarded_k = k;
    auto scene = scene_of(place->shape(), *what.method, what.voxel_mm);
    scene->guard = unguarded();
    if (what.guard == GuardUse::on) {
      for (TissueFeel& feel : scene->tissues) feel.stiffness_n_per_mm = k;
      scene->guard = GuardSettings{};
      scene->guard.limit_n = what.device.limit_n;
      scene->guard.delay_ms = what.transport.delay_ms;
    }
    state = std::make_unique<StepState>(std::move(scene));
    place->shape().prepare(*state);
  }

  KMaxCase what;
  double guarded_k = 0.0;  // stiffness of the state, with the guard on
  std::unique_ptr<PressPlace> place;
  std::unique_ptr<Truth> exact;
  std::unique_ptr<StepState> state;
  Stepper stepper = [](StepState& s, const StepInput& input) { return step(s, input); };
};

PressBench::PressBench(const KMaxCase& what) : inner_(std::make_unique<Inner>(what)) {}
PressBench::~PressBench() = default;

void PressBench::use(const KMaxCase& what) {
  if (what.guard == GuardUse::on || inner_->what.guard == GuardUse::on) inner_->state.reset();  // the guard knows the device
  inner_->what = what;
}

namespace {

/// The force that the device renders, tick by tick, with what a press measures of it.
class PressController {
 public:
  /// state: nullptr renders the exact proxy.
  PressController(StepState* state, Truth& exact, const KMaxCase& what, double k, PressOptions options)
      : state_(state), exact_(exact), guarded_(what.guard == GuardUse::on), k_(k), options_(options) {}

  Vec3 operator()(const lab::Reading& reading) {
    const StepInput input = input_of(reading);
    const Vec3 device = input.position_mm();
    // If a method answers one reading twice with its proxy at rest, a third answer is the same and is not computed.
    const bool same = any_ && input.x == last_.x && input.y == last_.y && input.z == last_.z;
    if ((!state_ || options_.compare_exact) && !same) there_ = exact_.follow(device);
    if (state_ && !(same && rests_)) {
      const Vec3 before = answer_.proxy_mm;
      answer_ = step(*state_, input);
      rests_ = same && !guarded_ && length(answer_.proxy_mm - before) < kRestMm && !answer_.deferred;
    }
    last_ = input;
    any_ = true;
    touched_ = touched_ || (state_ ? answer_.contact : there_.contact);
    if (!state_) return there_.contact ? (there_.pose_mm - device) * k_ : Vec3(0.0);
    const Vec3 force = guarded_ ? answer_.force_n : answer_.force_raw_n * k_;
    if (options_.compare_exact) compare(force, device);
    return force;
  }

  bool touched() const { return touched_; }
  Vec3 proxy_mm() const { return state_ ? answer_.proxy_mm : there_.pose_mm; }
  void fill(PressRun& out) const {
    out.off_um = off_um_;
    out.force_step_mn = steps_.force_step_mn();
    out.guard_step_mn = steps_.guard_step_mn();
    out.penetration_um = penetration_.most_um();
    out.stuck_ms = stuck_.stuck_ms();
  }

 private:
  void compare(Vec3 force, Vec3 device) {
    const double off = length(answer_.proxy_mm - there_.pose_mm) * 1000.0;
    if (!(off <= off_um_)) off_um_ = off;
    steps_.add({force, (there_.pose_mm - device) * k_, guarded_ && answer_.guard_acts != 0});
    stuck_.add(there_.pose_mm, answer_.proxy_mm);
    penetration_.add(exact_.clearance_mm(answer_.proxy_mm));
  }

  StepState* state_;
  Truth& exact_;
  bool guarded_;
  double k_;
  PressOptions options_;
  lab::ForceSteps steps_;
  lab::StuckWatch stuck_;
  lab::Penetration penetration_;
  StepInput last_;
  StepOutput answer_;
  Exact there_;
  double off_um_ = 0.0;
  bool any_ = false, rests_ = false, touched_ = false;
};

/// The straight motion of the grip from first touch to the place where it presses with kPressN.
struct PressMotion {
  PressMotion(const KMaxCase& what, const Press& press, Vec3 from_mm, double k)
      : from(from_mm),
        to(press.touch + press.into * (kPressN * (1.0 / k + (what.grip.holds() ? 1.0 / what.grip.stiffness_n_per_mm : 0.0)))),
        arrive_s(length(to - from) / kApproachMmS),
        along((to - from) / length(to - from)),
        ticks(static_cast<int>(std::ceil((arrive_s + kPressS) / lab::kTickS))) {}

  void drive(lab::Plant& plant, const KMaxCase& what, const Press& press, double now_s) const {
    const bool arrived = now_s >= arrive_s;
    if (what.grip.holds()) {
      plant.intend(arrived ? to : from + along * (kApproachMmS * now_s), arrived ? Vec3(0.0) : along * kApproachMmS);
    } else {
      plant.push(press.into * (kPressN * std::min(1.0, now_s / arrive_s)));
    }
  }

  Vec3 from, to;
  double arrive_s;
  Vec3 along;
  int ticks;
};

}  // namespace

StepState* PressBench::state_at(double k, Vec3 start, const Press& press) {
  const KMaxCase& what = inner_->what;
  if (!what.method) return nullptr;
  const bool guarded = what.guard == GuardUse::on;
  inner_->make_state(k);
  StepState& state = *inner_->state;
  if (guarded && state.last().tick > 0) step(state, rearmed(state.last().device_mm));  // clears the last run's fault
  bring(state, inner_->stepper, inner_->place->shape(), start - press.approach * 2.0);
  lead(state, inner_->stepper, start, kReadyMm);
  // The guard's ramp ends before the touch.
  for (int t = 0; guarded && t < kRampTicks; ++t) step(state, t == 0 ? rearmed(start) : input_at(start));
  return &state;
}

PressRun PressBench::run(double k, std::uint64_t seed, PressOptions options) {
  const KMaxCase& what = inner_->what;
  const Press press = inner_->place->press(seed);
  const Vec3 start = press.touch - press.approach * kStartAboveMm;
  StepState* state = state_at(k, start, press);
  inner_->exact->start(start);

  Random random(seed * 7919);
  const Vec3 phase = random.in(Vec3(0.0), Vec3(1.0));
  lab::TransportSettings transport = what.transport;
  transport.seed = seed;
  lab::ClosedLoop loop(what.device, transport, what.grip, start, phase);
  if (!what.grip.holds()) loop.plant().rail(press.free_a, press.free_b);
  loop.plant().drive(press.approach * kApproachMmS);

  PressRun out;
  lab::ContactEnergy energy;
  PressController press_controller(state, *inner_->exact, what, k, options);
  const auto controller = [&press_controller](const lab::Reading& reading) { return press_controller(reading); };
  for (int t = 0; t < kMostApproachTicks && !press_controller.touched(); ++t) energy.add(loop.tick(controller));
  loop.plant().release();
  const PressMotion motion(what, press, loop.plant().position_mm(), k);
  const auto window = static_cast<int>(lab::Steadiness::kWindowS / lab::kTickS);
  lab::Steadiness steady(press.into, Frame::of(press.into, {0.3, 0.5, 1.0}, Vec3(0.0)).x);
  for (int t = 0; t < motion.ticks; ++t) {
    motion.drive(loop.plant(), what, press, t * lab::kTickS);
    const lab::LoopTick tick = loop.tick(controller);
    energy.add(tick);
    const bool final = t >= motion.ticks - window;
    steady.add(tick, final ? lab::Steadiness::Part::in_window : lab::Steadiness::Part::before_window);
    if (!(length(tick.to_mm - press.touch) < kLostMm + kPressN / k)) {
      out.verdict = Verdict::moves;
      break;
    }
    if (options.stop_early && (tick.over_limit || final)) {
      out.verdict = steady.verdict(what.device.encoder_step_mm);
      if (out.verdict == Verdict::over_limit || out.verdict == Verdict::moves) break;
      out.verdict = Verdict::steady;
    }
  }
  // The proxy decides, because a guard that softens the wall lets the device further in.
  const Vec3 off = press_controller.proxy_mm() - press.touch;
  const double in = glm::dot(off, press.into);
  out.left = !(length(off - press.into * in) < kLostAsideMm && std::fabs(in) < kLostThroughMm);
  if (out.verdict == Verdict::steady) out.verdict = steady.verdict(what.device.encoder_step_mm);
  if (out.left && out.verdict == Verdict::steady) out.verdict = Verdict::moves;
  out.cycle_um = steady.peak_to_peak_mm() * 1000.0;
  out.cycle_hz = steady.cycle_hz();
  out.window_mj = steady.energy_mj();
  out.energy_mj = energy.most_mj();
  press_controller.fill(out);
  return out;
}

double k_at(int place) { return kKMaxFloor * std::pow(kKMaxFactor, place); }

namespace {

/// Tries stiffnesses of the grid with all seeds until one fails.
class Tries {
 public:
  Tries(PressBench& bench, const KMaxCase& what) : bench_(bench), what_(what) {}
  bool fails(int place) {
    // The seed that failed last is tried first.
    for (int i = 0; i < what_.seeds; ++i) {
      const int nth = i == 0 ? likely_ : i == likely_ ? 0 : i;
      ++runs_;
      if (bench_.run(k_at(place), seed_of(nth), {.stop_early = true}).verdict != Verdict::steady) {
        likely_ = nth;
        return true;
      }
    }
    return false;
  }
  KMax answer(int first_failing) {
    KMax out;
    out.beyond = first_failing >= kKMaxPlaces;
    out.k_max_n_per_mm = first_failing > 0 ? k_at(std::min(first_failing, kKMaxPlaces) - 1) : 0.0;
    if (!out.beyond && fails(first_failing)) {
      // Repeats the run to its end for the cycle and the reason.
      const PressRun run = bench_.run(k_at(first_failing), seed_of(likely_));
      ++runs_;
      out.reason = run.verdict;
      out.cycle_um = run.cycle_um;
      out.cycle_hz = run.cycle_hz;
      out.left = run.left;
      out.seed = seed_of(likely_);
    }
    out.runs = runs_;
    return out;
  }

 private:
  std::uint64_t seed_of(int nth) const { return what_.first_seed + static_cast<std::uint64_t>(nth); }

  PressBench& bench_;
  const KMaxCase& what_;
  int likely_ = 0, runs_ = 0;  // likely: of the seeds
};

}  // namespace

KMax find_k_max(PressBench& bench, const KMaxCase& what, double near_n_per_mm) {
  bench.use(what);
  Tries tries(bench, what);
  int low = -1, high = kKMaxPlaces;
  if (near_n_per_mm >= kKMaxFloor) {
    // Outwards from the guess in doubling strides, until one place passes and a higher one fails.
    int at = static_cast<int>(std::lround(std::log(near_n_per_mm / kKMaxFloor) / std::log(kKMaxFactor)));
    for (int stride = 1; low < 0 || high == kKMaxPlaces; stride *= 2) {
      if (at < 0 || at >= kKMaxPlaces) break;
      if (tries.fails(at)) {
        high = at;
        if (low >= 0) break;
        at -= stride;
      } else {
        low = at;
        if (high < kKMaxPlaces) break;
        at += stride;
      }
    }
  }
  for (bool again = true; again;) {
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      (tries.fails(middle) ? high : low) = middle;
    }
    // A failure below restarts the search beneath it.
    again = false;
    for (int place = high - 2; place >= 0 && !again; --place) {
      if (what.search == KMaxSearch::spot_checks && high - place > kConfirmPlaces && place % kConfirmStride != 0) continue;
      if (!tries.fails(place)) continue;
      high = place;
      low = -1;
      again = true;
    }
  }
  return tries.answer(high);
}

KMax find_k_max(const KMaxCase& what) {
  PressBench bench(what);
  return find_k_max(bench, what);
}

KMax scan_k_max(PressBench& bench, const KMaxCase& what) {
  bench.use(what);
  Tries tries(bench, what);
  int place = 0;
  while (place < kKMaxPlaces && !tries.fails(place)) ++place;
  return tries.answer(place);
}

}  // namespace cusp::bench
