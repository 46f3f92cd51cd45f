#include "tests/bench/channel.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/contact/surface_contact.h"
#include "tests/bench/candidates.h"
#include "tests/bench/tick_times.h"
#include "tests/modules.h"

namespace cusp::bench {

namespace {

constexpr double kUnambiguousMm = 0.05;
constexpr double kSearchStepMm = 0.05;      // a tick, while unambiguous_holes tests a hole
constexpr double kHoleLeadMm = 0.02;      // a tick, into the hole and aside

}  // namespace

std::vector<std::shared_ptr<const Hole>> unambiguous_holes(double r, HoleKind kind, std::uint64_t seed, int count) {
  struct Other {
    double clearance, pull;  // as shares of the hole's own
  };
  constexpr Other kOthers[] = {{1.5, 1.0}, {0.6, 0.95}, {1.0, 1.05}};
  std::vector<std::shared_ptr<const Hole>> out;
  for (; static_cast<int>(out.size()) < count; ++seed) {
    auto hole = std::make_shared<const Hole>(r, kind, seed, SurfaceContact::kClearanceMm);
    Random none(0);
    const Leg leg = hole->leg(none, nullptr);
    bool unambiguous = true;
    for (const Other& other : kOthers) {
      const Hole like(r, kind, seed, other.clearance * SurfaceContact::kClearanceMm);
      const auto a = hole->truth(), b = like.truth();
      a->start(hole->bottom());
      b->start(hole->bottom());
      const Vec3 aside = hole->pull() * (other.pull - 1.0);
      for (double s = 0.0; s < leg.length_mm && unambiguous; s += kSearchStepMm) {
        const Vec3 device = input_at(leg.at(s)).position_mm();
        unambiguous = length(a->follow(device).pose_mm - b->follow(device + aside).pose_mm) < kUnambiguousMm;
      }
      if (!unambiguous) break;
    }
    if (unambiguous) out.push_back(std::move(hole));
  }
  return out;
}

Row measure_channel(const std::vector<std::shared_ptr<const Hole>>& holes, const Measure& what) {
  Errors errors;
  TickTimes times;
  std::int64_t candidates = -1;
  for (const auto& hole : holes) {
    StepState state(scene_of(*hole, what.method, what.voxel_mm));
    hole->prepare(state);
    Random none(0);
    const Leg leg = hole->leg(none, nullptr);
    bring(state, what.stepper, *hole, hole->outside());
    lead(state, what.stepper, hole->bottom(), kHoleLeadMm);
    lead(state, what.stepper, leg.at(0.0), kHoleLeadMm);
    const auto truth = hole->truth();
    truth->start(hole->bottom());
    truth->follow(input_at(leg.at(0.0)).position_mm());
    errors.skip();
    const double per_tick = what.speed_mm_s * kTickUs * 1e-6;
    for (double s = per_tick; s <= leg.length_mm; s += per_tick) {
      const StepInput input = input_at(leg.at(s));
      const auto before = Clock::now();
      const StepOutput out = what.stepper(state, input);
      times.add_ns(std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - before).count());
      const Exact exact = truth->follow(input.position_mm());
      errors.note(out);
      if (!exact.contact || length(exact.pose_mm - out.device_mm) < kLeastSpringMm) {
        errors.skip_small();
      } else {
        errors.add(out, exact, truth->clearance_mm(out.proxy_mm));
      }
    }
    candidates = std::max(candidates, most_candidates(state));
  }
  Row row = row_of(*holes.front(), what, "slide");
  errors.fill(row);
  times.fill(row);
  row.max_candidates = candidates;
  return row;
}

}  // namespace cusp::bench
