// Cases of motion: scripted, or by a hand in the laboratory's closed loop.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/volume/fragments.h"
#include "tests/bench/cut_shape.h"
#include "tests/bench/frame.h"
#include "tests/bench/motions.h"
#include "tests/bench/pin.h"
#include "tests/bench/stability_cases.h"
#include "tests/modules.h"

namespace cusp::bench {

namespace {

constexpr double kSpeedMmS = 50.0;  // of scripted motion
constexpr double kHeldMmS = 20.0;   // of a hand's intent
constexpr double kDownMm = 0.05;    // mm a tick during the approach
constexpr int kMotionTicks = 2000, kHeldMs = 1800, kInMs = 200;
constexpr double kHeldPushN = 0.5;  // N; push of a hand
constexpr int kStallEveryMs = 150, kMostLateMs = 50;

/// Allows runs until the CPU budget is spent or most_runs are done; one at least.
class Budget {
 public:
  explicit Budget(const CaseRun& what) : end_(core_time_s() + what.budget_s), most_(what.most_runs) {}
  bool more(std::int64_t done) const { return done == 0 || (done < most_ && core_time_s() < end_); }

 private:
  double end_;
  std::int64_t most_;
};

std::string_view shape_of(std::string_view key) {
  if (key == "tissues") return "joint";
  if (key == "islands") return "islet";
  if (key == "volume-edge") return "rim";
  if (key == "voxel-size") return "sphere";
  if (key == "narrow-slot") return "narrow-slot";
  return "face";
}

/// Enamel twice as stiff as dentine.
constexpr double kEnamelNPerMm = 2.0;

void two_tissues(Scene& scene) { scene.tissues[index_of(Tissue::enamel)].stiffness_n_per_mm = kEnamelNPerMm; }

/// Tissues are known by the voxel, so near their boundary the exact proxy takes the method's stiffness.
void two_tissues(Pair& pair, const Shape& shape, double voxel_mm) {
  pair.stiffness = [&shape, voxel_mm, axis = shape.tool_axis()](const Exact& exact, const StepOutput& out) {
    const Frame frame = oblique_frame();
    const Vec3 touch = exact.pose_mm - axis * shape.bur_radius_mm();
    const double x = frame.to_local(touch).x;
    if (std::fabs(x) < 1.8 * voxel_mm && out.stiffness_n_per_mm > 0.0) return out.stiffness_n_per_mm;
    return x < 0.0 ? kEnamelNPerMm : kStabilityNPerMm;
  };
}

enum class Ticks : std::uint8_t { on_time, late };

/// Length of the stall that begins at ms: 1 to 49 ms every 150 ms, else 0.
int stall_at(Random& random, int ms) {
  return ms % kStallEveryMs == kStallEveryMs - 1 ? static_cast<int>(random.between(1.0, kMostLateMs)) : 0;
}

void run_scripted(Pair& pair, const Shape& shape, std::uint64_t seed, Ticks ticks, Tally& tally) {
  Slide slide(shape, kSpeedMmS, seed);
  Random random(seed);
  const Vec3 first = slide.next(), before = shape.before(first);
  pair.bring(before);
  tally.begin();
  const int in = static_cast<int>(length(first - before) / kDownMm) + 1;
  for (int k = 1; k <= in; ++k) pair.tick(input_at(before + (first - before) * (static_cast<double>(k) / in)), tally);
  for (int k = 0; k < kMotionTicks; ++k) {
    StepInput input = input_at(slide.next());
    if (const int ms = ticks == Ticks::late ? stall_at(random, k) : 0; ms > 0) {
      for (int gone = 0; gone < ms; ++gone) input = input_at(slide.next());
      input.elapsed_us = static_cast<std::uint32_t>(ms + 1) * 1000u;
    }
    pair.tick(pair.rearmed(input), tally);
  }
  tally.end();
}

void run_held(Pair& pair, const Shape& shape, const Setting& setting, std::uint64_t seed, Ticks ticks, Tally& tally) {
  Slide slide(shape, kHeldMmS, seed);
  std::vector<Vec3> way;
  const double deeper = depth_for(setting, kHeldPushN) - kDepthMm;
  Vec3 before(0.0);
  for (int ms = 0; ms <= kHeldMs - kInMs; ++ms) {
    const Vec3 at = slide.next();
    if (ms == 0) before = shape.before(at);
    // Into the tissue. On a sphere towards its centre, or the hand pulls the bur round it.
    const Vec3 in = shape.name() == "sphere" ? unit(at - shape.before(at)) : -shape.tool_axis();
    way.push_back(at + in * deeper);
  }
  const Intent intent = [&](int ms) {
    return ms < kInMs ? before + (way.front() - before) * (static_cast<double>(ms) / kInMs)
                      : way[static_cast<std::size_t>(ms - kInMs)];
  };
  Events events;
  Random stalls(seed), same(seed);
  if (ticks == Ticks::late) {
    events.method = [&stalls](int ms, Pair&, lab::ClosedLoop& loop) { loop.stall_ms(stall_at(stalls, ms)); };
    events.exact = [&same](int ms, std::unique_ptr<Truth>&, lab::ClosedLoop& loop) {
      loop.stall_ms(stall_at(same, ms));
    };
  }
  pair.bring(before);
  tally.begin();
  run_hand(pair, shape, setting, before, intent, kHeldMs, seed, tally, events);
  tally.end();
}

}  // namespace

Row row_of(const CaseRun& what) {
  Row row;
  row.method = key_of(what.method);
  row.case_name = what.key;
  row.guard = what.guard == GuardUse::on ? "on" : "off";
  name_setting(row, what.setting);
  row.bur_radius_mm = what.bur_radius_mm;
  row.voxel_mm = what.voxel_mm;
  row.seed = static_cast<std::int64_t>(what.seed);
  return row;
}

Row run_motion(const CaseRun& what) {
  const std::unique_ptr<Shape> shape = make_shape(shape_of(what.key), what.bur_radius_mm);
  auto scene = stability_scene(*shape, what.method, what.voxel_mm, what.guard, what.setting.delay_ms);
  const bool tissues = what.key == "tissues";
  const Ticks ticks = what.key == "late-ticks" ? Ticks::late : Ticks::on_time;
  if (tissues) two_tissues(*scene);
  Tally tally;
  Pair pair(*shape, scene);
  if (tissues) two_tissues(pair, *shape, what.voxel_mm);
  const Budget budget(what);
  for (std::uint64_t run = 0; budget.more(static_cast<std::int64_t>(run)); ++run) {
    if (what.setting.in_loop()) {
      run_held(pair, *shape, what.setting, what.seed + run, ticks, tally);
    } else {
      run_scripted(pair, *shape, what.seed + run, ticks, tally);
    }
  }
  Row row = row_of(what);
  row.shape = shape->name();
  row.unresolved = shape->unresolved(what.voxel_mm);
  tally.fill(row);
  return row;
}

Row run_thin_wall(const CaseRun& what) {
  const std::unique_ptr<Shape> wall = make_shape("wall", what.bur_radius_mm);
  const Frame frame = oblique_frame();
  constexpr double kDiscMm = 1.2, kAboveMm = 1.0, kBeyondMm = 1.0, kAsideMm = 2.1, kAsideBeforeMm = 3.0;
  constexpr double kSteepest = 1.0, kFlattest = 0.17;    // cosines: straight down, and 80 degrees from that
  constexpr double kSlowestMm = 0.05, kFastestMm = 1.0;  // a tick
  constexpr int kRestTicks = 5;
  const double r = what.bur_radius_mm;
  Pair pair(*wall, stability_scene(*wall, what.method, what.voxel_mm, what.guard));
  pair.behind = [&frame](Vec3 proxy) { return frame.to_local(proxy).z < 0.0; };
  Tally tally;
  Random random(what.seed);
  Vec3 at = frame.to_world({0.0, 0.0, r + kAboveMm});
  pair.bring(at);
  const Budget budget(what);
  for (std::int64_t run = 0; budget.more(run); ++run) {
    const double cosine = random.between(kFlattest, kSteepest), sine = std::sqrt(1.0 - cosine * cosine);
    const double phi = random.between(0.0, 6.283185307179586), rho = kDiscMm * std::sqrt(random.between(0.0, 1.0));
    const double side = random.between(0.0, 6.283185307179586);
    const Vec3 way(sine * std::cos(phi), sine * std::sin(phi), -cosine);
    const Vec3 aim(rho * std::cos(side), rho * std::sin(side), 0.0);
    const double before = std::min((r + kAboveMm) / cosine, kAsideBeforeMm / std::max(sine, 1e-9));
    const double beyond = std::min(kBeyondMm / cosine, kAsideMm / std::max(sine, 1e-9));
    // A flat approach starts higher, so that the bur begins clear of the wall.
    const Vec3 lifted(0.0, 0.0, std::max(0.0, r + 0.1 - cosine * before));
    const Vec3 from = frame.to_world(aim - way * before + lifted), to = frame.to_world(aim + way * beyond);
    lead(pair.state(), step, from, kFastestMm);
    pair.truth().start(input_at(from).position_mm());
    tally.begin();
    const double speed = random.between(kSlowestMm, kFastestMm);
    const int ticks = static_cast<int>(length(to - from) / speed) + 1;
    bool through = false;
    for (int k = 1; k <= ticks + kRestTicks; ++k) {
      const double share = std::min(1.0, static_cast<double>(k) / ticks);
      const StepOutput out = pair.tick(pair.rearmed(input_at(from + (to - from) * share)), tally);
      through = through || pair.behind(out.proxy_mm);
    }
    tally.end();
    // The bur returns along its path, or round the wall from behind it.
    if (through) {
      for (const Vec3 p : {frame.to_local(to) + Vec3(14.0, 0.0, 0.0), Vec3(18.0, 0.0, 8.0), Vec3(0.0, 0.0, 8.0)})
        lead(pair.state(), step, frame.to_world(p), 1.0);
      pair.bring(frame.to_world({0.0, 0.0, r + kAboveMm}));
    } else {
      lead(pair.state(), step, from, kFastestMm);
      lead(pair.state(), step, frame.to_world({0.0, 0.0, r + kAboveMm}), kFastestMm);
    }
  }
  Row row = row_of(what);
  row.shape = "wall";
  row.unresolved = wall->unresolved(what.voxel_mm);
  tally.fill(row);
  return row;
}

namespace {

constexpr int kGoneMs = 600, kLedGoneMs = 150, kLedMs = 500;  // ms until give_way; length of a scripted run

/// Moves the scripted device point `down` mm below its beginning in millisecond ms.
using Led = std::function<StepOutput(int ms, double down)>;

/// A bur presses on a ChangingFace by a hand, or by the scripted motion `led`.
Row run_giving_way(const CaseRun& what, const ChangingFace& shape, const std::function<void(Pair&)>& gives_way,
                   const std::function<void(const Led&)>& led) {
  const auto scene = stability_scene(shape, what.method, what.voxel_mm, what.guard, what.setting.delay_ms);
  Tally tally;
  const Budget budget(what);
  for (std::uint64_t run = 0; budget.more(static_cast<std::int64_t>(run)); ++run) {
    Random random(what.seed + run);
    const Spot spot = shape.spot(random);
    Pair pair(shape, scene);
    const Vec3 above = spot.centre + spot.normal * 0.05;
    pair.bring(above);
    tally.begin();
    if (what.setting.in_loop()) {
      const Vec3 deep = spot.centre - spot.normal * depth_for(what.setting, kHeldPushN);
      const Intent intent = [&](int ms) { return above + (deep - above) * std::min(1.0, ms / double{kInMs}); };
      Events events;
      events.method = [&](int ms, Pair& p, lab::ClosedLoop&) {
        if (ms == kGoneMs) gives_way(p);
      };
      events.exact = [&](int ms, std::unique_ptr<Truth>& truth, lab::ClosedLoop&) {
        if (ms != kGoneMs) return;
        const Vec3 pose = truth->exact().pose_mm;
        truth = shape.truth_after();
        truth->start(pose);
      };
      run_hand(pair, shape, what.setting, above, intent, kHeldMs, what.seed + run, tally, events);
    } else {
      led([&](int ms, double down) {
        if (ms == kLedGoneMs) gives_way(pair);
        return pair.tick(input_at(above - spot.normal * (std::min(ms * kDownMm, 0.05 + kDepthMm) + down)), tally);
      });
    }
    tally.end();
  }
  Row row = row_of(what);
  row.shape = shape.name();
  tally.fill(row);
  return row;
}

}  // namespace

Row run_vanishing(const CaseRun& what) {
  const SuddenHole shape(what.bur_radius_mm);
  constexpr double kLedMm = 0.005;  // mm a tick downwards
  const auto gives_way = [&shape](Pair& pair) {
    if (!shape.give_way(pair.state())) throw std::runtime_error("no room for the hole");
    pair.replace(shape.truth_after(), shape.bur_radius_mm());
  };
  return run_giving_way(what, shape, gives_way, [](const Led& to) {
    for (int ms = 1; ms <= kLedMs; ++ms) to(ms, kLedMm * std::max(0, ms - kLedGoneMs));
  });
}

Row run_fragment(const CaseRun& what) {
  const DetachablePlate shape(what.bur_radius_mm);
  double off_ms = 0.0;
  const auto detaches = [&shape](Pair& pair) {
    if (!shape.give_way(pair.state())) throw std::runtime_error("no room for the cut");
    const auto names = find_severed_fragments(pair.state().volume(), pair.state().volume().cut_bricks());
    if (names.empty()) throw std::runtime_error("the plate is not detached");
    pair.name_fragment(names.front());
    pair.replace(shape.truth_after(), shape.bur_radius_mm());
  };
  Row row = run_giving_way(what, shape, detaches, [&off_ms](const Led& to) {
    int last = kLedGoneMs;  // last millisecond with a force
    for (int ms = 1; ms <= kLedMs; ++ms)
      if (length(to(ms, 0.0).force_n) > 0.0) last = ms;
    off_ms = last == kLedMs ? kAbsent : std::fmax(off_ms, last + 1 - kLedGoneMs);
  });
  if (!what.setting.in_loop()) row.zero_ms = off_ms;
  return row;
}

Row run_start_inside(const CaseRun& what) {
  const std::unique_ptr<Shape> face = make_shape("face", what.bur_radius_mm);
  const auto scene = stability_scene(*face, what.method, what.voxel_mm, what.guard);
  constexpr int kStayMs = 300, kMoveMs = 250, kOutMs = 100;
  constexpr double kLeastMm = 0.1, kMostMm = 3.0, kAgainMm = 0.3;
  Tally tally;
  const Budget budget(what);
  for (std::uint64_t run = 0; budget.more(static_cast<std::int64_t>(run)); ++run) {
    Random random(what.seed + run);
    const Spot spot = face->spot(random);
    const Vec3 inside = spot.centre - spot.normal * random.between(kLeastMm, kMostMm);
    const Vec3 outside = spot.centre + spot.normal * 0.3, again = spot.centre - spot.normal * kAgainMm;
    Pair pair(*face, scene);
    pair.truth().start(input_at(inside).position_mm());
    tally.begin();
    for (int ms = 0; ms < kStayMs + 2 * kMoveMs + kOutMs; ++ms) {
      const double out = std::clamp((ms - kStayMs) / double{kMoveMs}, 0.0, 1.0);
      const double in = std::clamp((ms - kStayMs - kMoveMs - kOutMs) / double{kMoveMs}, 0.0, 1.0);
      pair.tick(pair.rearmed(input_at(inside + (outside - inside) * out + (again - outside) * in)), tally);
    }
    tally.end();
  }
  Row row = row_of(what);
  row.shape = "face";
  tally.fill(row);
  return row;
}

Row run_weight(const CaseRun& what) {
  const std::unique_ptr<Shape> corner = make_shape("corner", what.bur_radius_mm);
  const auto scene = stability_scene(*corner, what.method, what.voxel_mm, what.guard, what.setting.delay_ms);
  Setting setting = what.setting;
  setting.weighs = true;
  Tally tally;
  Pair pair(*corner, scene);
  const Budget budget(what);
  for (std::uint64_t run = 0; budget.more(static_cast<std::int64_t>(run)); ++run) {
    Random random(what.seed + run);
    // A hand lowers the bur into the corner of three walls and lets it rest there.
    const Vec3 bottom = corner->before(corner->tool_axis() * -5.0);
    const Vec3 begin = bottom + corner->tool_axis() * random.between(0.2, 0.6);
    const Intent intent = [&](int ms) { return begin + (bottom - begin) * std::min(1.0, ms / double{kInMs}); };
    pair.bring(begin);
    tally.begin();
    run_hand(pair, *corner, setting, begin, intent, kHeldMs, what.seed + run, tally);
    tally.end();
  }
  Row row = row_of(what);
  row.shape = "corner";
  tally.fill(row);
  return row;
}

}  // namespace cusp::bench
