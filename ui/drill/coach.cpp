#include "ui/drill/coach.h"

#include <algorithm>
#include <cmath>

#include "ui/session/bur_depth.h"

namespace cusp::ui {
namespace {

constexpr double kThinMm = 0.5;          // dentine over the pulp, below which the coach warns
constexpr double kReachedMm = 0.1;       // this near the floor it is reached: a tenth is what the gauge shows
constexpr double kNearMm = 0.4;      // half a second before the floor at the usual push in dentine [M]
constexpr double kAlmostAllPercent = 97;
constexpr double kWritingMm = 1e-9;      // the rounding of decimal figures: 0.5 - 0.3 is 0.2 all the same
constexpr double kFirstMm3 = 0.01;       // less is a touch, not a cut

}  // namespace

bool stands_still(const LiveView& live) noexcept {
  return live.silent || live.phase == LoopPhase::paused || live.phase == LoopPhase::held || live.device == Sample::Status::gone;
}

CoachLine coach(const LiveView& live, const TargetShape& shape, const Leeway& leeway, double bur_radius_mm) {
  if (stands_still(live)) return {Coach::quiet, 0};
  if (live.cut_ignored) return {Coach::held_cut, 0};
  if (shape.empty()) return {Coach::quiet, 0};
  double removed = 0;
  for (const double mm3 : live.removed_mm3) removed += mm3;
  if (live.pulp_exposed) return {Coach::pulp_open, 0};
  if (removed < kFirstMm3) return {Coach::begin, 0};
  if (live.output.contact && live.over_pulp_mm && *live.over_pulp_mm < kThinMm) return {Coach::over_pulp, *live.over_pulp_mm};
  const Vec3 at = live.output.proxy_mm;
  const double floor_mm = floor_under_mm(shape, {at.x, at.y}).value_or(shape.floor_mm());
  const double left = shape.top_mm() - floor_mm - live.bur_depth_mm;
  const double beside = wall_mm(shape, {at.x, at.y}) + bur_radius_mm;  // of the bur's side beyond the wall
  if (live.output.contact && beside > leeway.side_mm) return {Coach::outside, beside};
  if (live.output.contact && left < -kReachedMm) return {Coach::too_deep, -left};
  if (live.target_removed_percent >= kAlmostAllPercent) return {Coach::finish, 0};
  if (!live.output.contact) return {};
  if (left > kNearMm) return {Coach::deeper, left};
  if (left > kReachedMm) return {Coach::nearly, left};
  return {Coach::sideways, 0};
}

CoachTone tone_of(const CoachLine& line, const Leeway& leeway) noexcept {
  switch (line.what) {
    case Coach::pulp_open:
    case Coach::outside: return CoachTone::bad;
    case Coach::too_deep: return line.mm > leeway.floor_mm + kWritingMm ? CoachTone::bad : CoachTone::look;
    case Coach::over_pulp:
    case Coach::nearly: return CoachTone::look;
    case Coach::begin:
    case Coach::deeper:
    case Coach::sideways:
    case Coach::finish:
    case Coach::carry_on:
    case Coach::held_cut:
    case Coach::quiet: break;
  }
  return CoachTone::good;
}

bool worth_saying(const CoachLine& spoken, const CoachLine& line) noexcept {
  return line.what != spoken.what || std::abs(line.mm - spoken.mm) >= kWorthSayingMm - kWritingMm;
}

}  // namespace cusp::ui
