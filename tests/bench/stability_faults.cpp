// Faults of the device and exchanges by the session on a face, and vibration in the paper's tasks.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/bench/frame.h"
#include "tests/bench/motions.h"
#include "tests/bench/scale.h"
#include "tests/bench/stability_cases.h"
#include "tests/bench/tasks.h"
#include "tests/bench/vibration.h"

namespace cusp::bench {

namespace {

constexpr int kFaultRuns = 20;
constexpr int kSettleMs = 50, kFaultMs = 60, kLatchedMs = 150, kBackMs = 500;
constexpr double kSlideMm = 0.02;  // a tick, all the while
constexpr double kBackShare = 0.95;
constexpr double kJumpMm = 20.0;
constexpr double kLargerBur = 1.5;

Vec3 random_direction(Random& random) {
  const double z = random.between(-1.0, 1.0), phi = random.between(0.0, 6.283185307179586);
  const double rho = std::sqrt(1.0 - z * z);
  return {rho * std::cos(phi), rho * std::sin(phi), z};
}

/// A faulty sample of the device. held: its last good position.
Sample faulty(std::string_view key, Vec3 now, Vec3 held, Vec3 jump) {
  Sample sample;
  sample.status = Sample::Status::fresh;
  sample.position_mm = now;
  if (key == "frozen") {
    sample.status = Sample::Status::late;
    sample.position_mm = held;
  } else if (key == "jump") {
    sample.position_mm = now + jump;
  } else if (key == "nan") {
    sample.position_mm = Vec3(std::numeric_limits<double>::quiet_NaN());
  } else if (key == "infinite") {
    sample.position_mm.x = std::numeric_limits<double>::infinity();
  } else if (key == "out-of-range") {
    sample.position_mm.z = -1e9;
  } else if (key == "device-gone") {
    sample.status = Sample::Status::gone;
  }
  return sample;
}

/// zero: ms from the first faulty input until the force stays zero. back: ms from re-arming until it is within 5 % of its
/// final value. share: that value over the exact force.
struct Times {
  double zero = 0.0, back = 0.0, share = 1e9;
  void longer(const Times& other) {
    // NaN means never, and remains NaN.
    zero = std::isnan(zero) || std::isnan(other.zero) ? kAbsent : std::max(zero, other.zero);
    back = std::isnan(back) || std::isnan(other.back) ? kAbsent : std::max(back, other.back);
    share = std::min(share, other.share);
  }
};

Times one_fault(const CaseRun& what, const Shape& face, const std::shared_ptr<const Scene>& scene, std::uint64_t seed,
                Tally& tally) {
  Random random(seed);
  const Spot spot = face.spot(random);
  const Vec3 touch = spot.centre + spot.normal * 0.05;
  const Vec3 aside = unit(spot.centre - face.home() + spot.normal * glm::dot(face.home() - spot.centre, spot.normal));
  const Vec3 jump = random_direction(random) * kJumpMm;
  const int in = static_cast<int>((0.05 + kDepthMm) / 0.05);
  const int begins = in + kSettleMs + static_cast<int>(random.between(0.0, 20.0));
  // The real device moves to and fro across the face at 20 mm/s during the fault too.
  const auto place = [&](int ms) {
    const int turn = ms % 100;
    const double to = kSlideMm * (turn < 50 ? turn : 100 - turn);
    return touch - spot.normal * std::min(0.05 * ms, 0.05 + kDepthMm) - aside * to;
  };
  Pair pair(face, scene);
  pair.bring(touch);
  StepInput last = input_at(touch);
  Times out{kAbsent, kAbsent, 0.0};
  int zero_since = -1;
  Tally faulty_ticks;
  std::vector<double> after;  // [ms since re-arming]: the hand's force
  tally.begin();
  const int rearm = begins + kFaultMs + kLatchedMs;
  for (int ms = 1; ms <= rearm + kBackMs; ++ms) {
    const bool wrong = ms >= begins && ms < begins + kFaultMs;
    Sample sample;
    sample.status = Sample::Status::fresh;
    sample.position_mm = place(ms);
    if (wrong) sample = faulty(what.key, place(ms), place(begins - 1), jump);
    StepInput input = quantise(sample, kTickUs, last);
    if (ms == rearm) input.buttons |= StepInput::kRearm;
    last = input;
    // A faulty position has no exact proxy; only the rendered force counts.
    const StepOutput answer = wrong ? pair.tick(input, faulty_ticks) : pair.tick(input, tally);
    const double given = length(answer.force_n);
    if (wrong) {
      tally.interrupt();
      tally.add_force(answer);
    }
    if (ms >= begins && ms < rearm) {
      if (given > 0.0) zero_since = -1;
      if (given == 0.0 && zero_since < 0) zero_since = ms;
    }
    if (ms == rearm && zero_since >= 0) out.zero = zero_since - begins;
    if (ms >= rearm) after.push_back(given);
    if (ms == rearm + kBackMs) out.share = given / length(pair.exact_n());
  }
  tally.end();
  for (std::size_t ms = 0; ms < after.size() && std::isnan(out.back); ++ms)
    if (after[ms] >= kBackShare * after.back() && after.back() > 0.0) out.back = static_cast<double>(ms);
  return out;
}

/// Depth of the hand ms after a larger bur was asked for: it lifts at the pace of its approach, for the bur changes in the air, and
/// presses again.
double depth_of_change(int ms) {
  constexpr double kPace = 0.05, kAirMm = 1.0;
  const double lifted = std::min(kPace * ms, kDepthMm + kAirMm);
  const double back = std::max(0.0, kPace * ms - 2.0 * (kDepthMm + kAirMm));
  return std::min(kDepthMm, kDepthMm - lifted + back);
}

/// Exchanges the specimen for one with a thin wall, or the bur for a larger one.
void one_exchange(const CaseRun& what, const Shape& face, const std::shared_ptr<const Scene>& scene, std::uint64_t seed,
                  Tally& tally) {
  Random random(seed);
  const Spot spot = face.spot(random);
  const Vec3 touch = spot.centre + spot.normal * 0.05;
  const Vec3 aside = unit(glm::cross(spot.normal, random_direction(random)));
  const bool bur = what.key == "bur-exchange";
  const int in = static_cast<int>((0.05 + kDepthMm) / 0.05), exchange = in + kSettleMs;
  const std::unique_ptr<Shape> other =
      bur ? make_shape("face", kLargerBur * what.bur_radius_mm) : make_shape("wall", what.bur_radius_mm);
  Pair pair(face, scene);
  pair.bring(touch);
  Pair fresh(*other, stability_scene(*other, what.method, what.voxel_mm, what.guard));
  Pair* now = &pair;
  tally.begin();
  for (int ms = 1; ms <= exchange + kBackMs; ++ms) {
    const double pressed = bur && ms > exchange ? 0.05 + depth_of_change(ms - exchange) : std::min(0.05 * ms, 0.05 + kDepthMm);
    StepInput input = input_at(touch - spot.normal * pressed + aside * (kSlideMm * ms * 0.1));
    if (!bur && ms == exchange) {
      tally.interrupt();
      fresh.truth().start(input.position_mm());
      now = &fresh;
    }
    if (bur && ms >= exchange) input.bur = 1;
    const std::uint16_t before = now->state().last().bur;
    if (now->tick(now->rearmed(input), tally).bur != before) {
      tally.interrupt();
      pair.replace(other->truth(), other->bur_radius_mm());
    }
  }
  tally.end();
}

/// Exact proxy of the top of the block.
class BlockTop : public Truth {
 public:
  BlockTop(double top_mm, double radius_mm) : rest_(top_mm + radius_mm) {}
  double clearance_mm(Vec3 centre) const override { return centre.z - rest_; }

 protected:
  Vec3 place(Vec3 centre) override { return {centre.x, centre.y, std::max(centre.z, rest_)}; }
  Exact move_to(Vec3 device) override { return {place(device), device.z < rest_, false}; }

 private:
  double rest_;
};

}  // namespace

Row run_fault(const CaseRun& what) {
  const std::unique_ptr<Shape> face = make_shape("face", what.bur_radius_mm);
  const auto scene = stability_scene(*face, what.method, what.voxel_mm, what.guard);
  const bool exchange = what.key == "specimen-exchange" || what.key == "bur-exchange";
  if (what.key == "bur-exchange") {
    Bur larger = scene->burs.front();
    larger.radius_mm *= kLargerBur;
    larger.neck_length_mm += larger.radius_mm;
    scene->burs.push_back(larger);
  }
  Tally tally;
  Times worst;
  for (std::uint64_t run = 0; run < kFaultRuns; ++run) {
    if (exchange) {
      one_exchange(what, *face, scene, what.seed + run, tally);
    } else {
      worst.longer(one_fault(what, *face, scene, what.seed + run, tally));
    }
  }
  Row row = row_of(what);
  row.shape = "face";
  tally.fill(row);
  if (what.key == "jump" && what.guard == GuardUse::off) {
    // The jump leads through the specimen, where the endless face is no truth.
    Row only = row_of(what);
    only.shape = row.shape;
    only.runs = row.runs;
    only.force_max_n = row.force_max_n;
    row = only;
  }
  if (!exchange) {
    row.zero_ms = worst.zero;
    row.back_ms = worst.back;
    row.back_share = worst.share;
  }
  return row;
}

Row run_task(const CaseRun& what) {
  const double top = solid_block_half_mm(128, 10.0 / 128), r = what.bur_radius_mm;
  auto scene = task_scene(what.method);
  if (what.guard == GuardUse::off) scene->guard = unguarded();
  StepState state(scene);
  BlockTop exact(top, r);
  const Vec3 begin = scripted_device_mm(0.0, {top, r});
  lead(state, step, begin, 0.05);
  exact.start(begin);
  const double from = what.key == "displacement" ? 0.0 : what.key == "exploration" ? kFreeS : kFreeS + kExploreS;
  const double whole = what.key == "perforation" ? kDrillS : what.key == "exploration" ? kExploreS : kFreeS;
  const bool drills = what.key == "perforation";
  Tally tally;
  tally.begin();
  std::vector<Vec3> beyond;  // [ms]: the method's force less the exact one
  const int ticks = static_cast<int>((from + whole) * 1000.0);
  for (int k = 1; k <= ticks; ++k) {
    const double t = k * 1e-3;
    const StepInput input = input_at(scripted_device_mm(t, {top, r}), t > kFreeS + kExploreS ? Button::down : Button::up);
    const StepOutput out = step(state, input);
    const Exact pose = exact.follow(input.position_mm());
    // Drilling has no exact proxy; its scripted motion has nothing above 3 Hz.
    const Vec3 force = pose.contact && !drills ? kStabilityNPerMm * (pose.pose_mm - out.device_mm) : Vec3(0.0);
    beyond.push_back(out.force_n - force);
    if (t > from && !drills) tally.add(out, pose, {force, exact.clearance_mm(out.proxy_mm), r, 0.1});
  }
  tally.end();
  Row row = row_of(what);
  row.shape = "block";
  row.task = what.key;
  if (!drills) tally.fill(row);
  row.samples = static_cast<std::int64_t>(whole * 1000.0);
  row.runs = 1;
  // The scripted motion has corners in the first eighth of exploring and drilling.
  row.vibration_mn = 1000.0 * vibration_n(beyond, static_cast<std::size_t>((from + 0.2 * whole) * 1000.0),
                                          static_cast<std::size_t>((from + 0.98 * whole) * 1000.0));
  return row;
}

Row run_case(const CaseRun& what) {
  if (what.key == "thin-wall") return run_thin_wall(what);
  if (what.key == "vanishing") return run_vanishing(what);
  if (what.key == "fragment") return run_fragment(what);
  if (what.key == "start-inside") return run_start_inside(what);
  if (what.key == "grip-weight") return run_weight(what);
  for (std::string_view name : kFaultCases)
    if (name == what.key) return run_fault(what);
  for (std::string_view name : kTaskCases)
    if (name == what.key) return run_task(what);
  return run_motion(what);
}

}  // namespace cusp::bench
