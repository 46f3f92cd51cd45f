#include "tests/bench/stability_kmax.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/frame.h"
#include "tests/bench/motions.h"

namespace cusp::bench {

namespace {

using Verdict = lab::Steadiness::Verdict;

constexpr double kAboveMm = 0.25;  // where the way down begins
constexpr double kReadyMm = 0.02;  // a tick, on the last bit of the way there
constexpr double kLostMm = 10.0;   // off the touch, besides the press's own depth: the device has left the place
constexpr double kRestMm = 1e-12;  // rounding in a solver that starts where it ended
// A proxy further off is elsewhere. Across the push: a bur that has slipped off an edge. Along it: a pivot that
// overlaps in a groove stands two bur radii too deep, which is its fault but not elsewhere.
constexpr double kAsideMm = 0.5, kThroughMm = 1.5;
constexpr int kRampTicks = 300;  // longer than GuardSettings::ramp_in_ms
constexpr int kMostApproachTicks = 200;
constexpr int kConfirmPlaces = 10;  // of the grid: 20 %
constexpr int kConfirmStride = 8;   // below those: places of the grid that this divides

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

  /// The state to run on: one for all stiffnesses without a guard, one for each with it.
  void make_state(double k) {
    if (state && (!what.guard || k == guarded_k)) return;
    guarded_k = k;
    auto scene = scene_of(place->shape(), *what.method, what.voxel_mm);
    scene->guard = unguarded();
    if (what.guard) {
      for (TissueFeel& feel : scene->tissues) feel.stiffness_n_per_mm = k;
      scene->guard = GuardSettings{};
      scene->guard.limit_n = what.device.limit_n;
      scene->guard.delay_ms = what.transport.delay_ms;
    }
    state = std::make_unique<StepState>(std::move(scene));
    place->shape().prepare(*state);
  }

  KMaxCase what;
  double guarded_k = 0.0;  // of the state, with the guard on
  std::unique_ptr<PressPlace> place;
  std::unique_ptr<Truth> exact;
  std::unique_ptr<StepState> state;
  Stepper stepper = [](StepState& s, const StepInput& input) { return step(s, input); };
};

PressBench::PressBench(const KMaxCase& what) : inner_(std::make_unique<Inner>(what)) {}
PressBench::~PressBench() = default;

void PressBench::use(const KMaxCase& what) {
  if (what.guard || inner_->what.guard) inner_->state.reset();  // the guard knows the device
  inner_->what = what;
}

PressRun PressBench::run(double k, std::uint64_t seed, bool early, bool compare) {
  const KMaxCase& what = inner_->what;
  const Press press = inner_->place->press(seed);
  const Vec3 start = press.touch - press.approach * kAboveMm;
  StepState* state = nullptr;
  if (what.method) {
    inner_->make_state(k);
    state = inner_->state.get();
    if (what.guard && state->last().tick > 0)
      step(*state, rearmed(state->last().device_mm));  // a fault of the last run
    bring(*state, inner_->stepper, inner_->place->shape(), start - press.approach * 2.0);
    lead(*state, inner_->stepper, start, kReadyMm);
    // A guard begins anew, and lets the force in slowly: that is over before the touch.
    for (int t = 0; what.guard && t < kRampTicks; ++t) step(*state, t == 0 ? rearmed(start) : input_at(start));
  }
  Truth& exact = *inner_->exact;
  const bool follow = !state || compare;
  exact.start(start);

  Random random(seed * 7919);
  const Vec3 phase(random.between(0.0, 1.0), random.between(0.0, 1.0), random.between(0.0, 1.0));
  lab::TransportSettings transport = what.transport;
  transport.seed = seed;
  lab::ClosedLoop loop(what.device, transport, what.grip, start, phase);
  if (!what.grip.holds()) loop.plant().rail(press.free_a, press.free_b);
  loop.plant().drive(press.approach * kApproachMmS);

  PressRun out;
  lab::ContactEnergy energy;
  lab::ForceSteps steps;
  lab::StuckWatch stuck;
  lab::Penetration penetration;
  bool touched = false;
  // Most readings of a device that hardly moves repeat the one before. A method that has answered the same reading
  // twice with its proxy in the same place is at rest: what it would say the third time is known.
  StepInput last;
  StepOutput answer;
  Exact there;
  bool any = false, rests = false;
  const auto controller = [&](const lab::Reading& reading) {
    StepInput input;
    input.x = reading.x;
    input.y = reading.y;
    input.z = reading.z;
    input.elapsed_us = reading.elapsed_us;
    const Vec3 device = input.position_mm();
    const bool same = any && input.x == last.x && input.y == last.y && input.z == last.z;
    if (follow && !same) there = exact.follow(device);
    if (state && !(same && rests)) {
      const Vec3 before = answer.proxy_mm;
      answer = step(*state, input);
      rests = same && !what.guard && length(answer.proxy_mm - before) < kRestMm && !answer.deferred;
    }
    last = input;
    any = true;
    if (!state) {
      touched = touched || there.contact;
      return there.contact ? (there.pose_mm - press.into * what.out_mm - device) * k : Vec3(0.0);
    }
    touched = touched || answer.contact;
    const Vec3 force = what.guard ? answer.force_n : answer.force_raw_n * k;
    if (compare) {
      const double off = length(answer.proxy_mm - there.pose_mm) * 1000.0;
      if (!(off <= out.off_um)) out.off_um = off;
      steps.add(force, (there.pose_mm - device) * k, what.guard && answer.guard_acts != 0);
      stuck.add(there.pose_mm, answer.proxy_mm);
      penetration.add(exact.clearance_mm(answer.proxy_mm));
    }
    return force;
  };

  // To the first force.
  for (int t = 0; t < kMostApproachTicks && !touched; ++t) energy.add(loop.tick(controller));
  lab::Plant& plant = loop.plant();
  plant.release();
  // From here on the hand goes straight to where it presses with kPressN against the wall as it is.
  const Vec3 from = plant.position_mm();
  const double give = 1.0 / k + (what.grip.holds() ? 1.0 / what.grip.stiffness_n_per_mm : 0.0);
  const Vec3 to = press.touch + press.into * (kPressN * give);
  const double way = length(to - from);
  const double arrive_s = way / kApproachMmS, end_s = arrive_s + kPressS;
  const Vec3 along = (to - from) / way;
  const auto ticks = static_cast<int>(std::ceil(end_s / lab::kTickS));
  const auto window = static_cast<int>(lab::Steadiness::kWindowS / lab::kTickS);
  lab::Steadiness steady(press.into, Frame::of(press.into, {0.3, 0.5, 1.0}, Vec3(0.0)).x);
  for (int t = 0; t < ticks; ++t) {
    const double now = t * lab::kTickS;
    const bool arrived = now >= arrive_s;
    if (what.grip.holds()) {
      plant.intend(arrived ? to : from + along * (kApproachMmS * now), arrived ? Vec3(0.0) : along * kApproachMmS);
    } else {
      plant.push(press.into * (kPressN * std::min(1.0, now / arrive_s)));
    }
    const lab::LoopTick tick = loop.tick(controller);
    energy.add(tick);
    const bool final = t >= ticks - window;
    steady.add(tick, final);
    if (!(length(tick.to_mm - press.touch) < kLostMm + kPressN / k)) {
      out.verdict = Verdict::moves;
      break;
    }
    if (early && (tick.over_limit || final)) {
      out.verdict = steady.verdict(what.device.encoder_step_mm);
      if (out.verdict == Verdict::over_limit || out.verdict == Verdict::moves) break;
      out.verdict = Verdict::steady;
    }
  }
  // By where the proxy is: a guard that softens the wall lets the device further in.
  const Vec3 off = (state ? answer.proxy_mm : there.pose_mm) - press.touch;
  const double in = glm::dot(off, press.into);
  out.left = !(length(off - press.into * in) < kAsideMm && std::fabs(in) < kThroughMm);
  if (out.verdict == Verdict::steady) out.verdict = steady.verdict(what.device.encoder_step_mm);
  if (out.left && out.verdict == Verdict::steady) out.verdict = Verdict::moves;
  out.cycle_um = steady.peak_to_peak_mm() * 1000.0;
  out.cycle_hz = steady.cycle_hz();
  out.window_mj = steady.energy_mj();
  out.energy_mj = energy.most_mj();
  out.force_step_mn = steps.force_step_mn();
  out.guard_step_mn = steps.guard_step_mn();
  out.penetration_um = penetration.most_um();
  out.stuck_ms = stuck.stuck_ms();
  return out;
}

double k_at(int place) { return kKMaxFloor * std::pow(kKMaxFactor, place); }

namespace {

/// What a stiffness of the grid comes to, over the seeds: the first that fails.
class Tries {
 public:
  Tries(PressBench& bench, const KMaxCase& what) : bench_(bench), what_(what) {}
  bool fails(int place) {
    // The seed that failed last is the likeliest to fail next.
    for (int i = 0; i < what_.seeds; ++i) {
      const int nth = i == 0 ? likely_ : i == likely_ ? 0 : i;
      ++runs_;
      if (bench_.run(k_at(place), seed_of(nth), true).verdict != Verdict::steady) {
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
      // Again, to its end, for what it looks like.
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
    // Outwards from the guess in growing strides, until one place holds and a higher one fails.
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
    // Below: a place that fails begins the search anew beneath it.
    again = false;
    for (int place = high - 2; place >= 0 && !again; --place) {
      if (!what.every && high - place > kConfirmPlaces && place % kConfirmStride != 0) continue;
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

std::vector<KMaxCase> k_max_cells(std::string_view place, std::optional<Method> method) {
  std::vector<KMaxCase> out;
  for (const lab::Grip& grip : {lab::kNoGrip, lab::kSoftGrip, lab::kFirmGrip})
    for (const double delay : {0.0, 1.0, 3.0})
      for (const double friction : {0.0, 0.1})
        for (const double mass : {0.1, 0.25})
          for (const double damping : {0.5, 2.0, 5.0}) {
            KMaxCase cell;
            cell.place = place;
            cell.method = method;
            cell.grip = grip;
            cell.transport.delay_ms = delay;
            cell.device.friction_n = friction;
            cell.device.mass_kg = mass;
            cell.device.damping_ns_per_m = damping;
            out.push_back(cell);
          }
  return out;
}

}  // namespace cusp::bench
