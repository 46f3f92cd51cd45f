#include "scenarios/operators/scripted_operator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/removal/spindle.h"
#include "scenarios/format/keys.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

namespace {
constexpr double kEasePerS = 8.0;       // speed towards a stroke's end, for each mm left
constexpr double kSlippedWanders = 2.0;  // this far beside the line, and
constexpr double kClimbedMm = 0.05;      // this high above it, the foot leaves the pedal until the bur is back
constexpr double kLeastSpeedMmS = 0.05; // but no less
constexpr double kProgressMm = 0.02;    // less than this within patience_s is none
constexpr double kTravelArriveMm = 0.1;
constexpr double kFurtherRadii = 0.5;    // repositions so much further on, in radii of the bur's head
constexpr std::size_t kMaxRepositions = 12;   // on one stroke
constexpr double kHeldN = 0.3;           // held: a larger force and no progress; with less the bur is only slow
constexpr double kStandsS = 0.4;         // no progress for so long may be a stall: releases for as long, then pushes
constexpr double kOfStall = 0.8;         // largest share of the stall force that an operator uses

double radius_mm_of(const Scenario& scenario, std::size_t bur) noexcept {
  return bur < scenario.instruments.size() ? scenario.instruments[bur].radius_mm : 0.0;
}
SpindleSettings handpiece_of(const Scenario& scenario) noexcept {
  return settings_of(phenomena_from_keys(scenario.phenomena).handpiece);
}
double stall_n_of(const SpindleSettings& handpiece, double radius_mm) noexcept {
  return handpiece.stall_n > 0.0 && radius_mm > 0.0 ? handpiece.stall_n * kStallRadiusMm / radius_mm
                                                    : std::numeric_limits<double>::infinity();
}
/// The push that removes most. Removal goes with push times speed, and the speed falls in proportion to the push by `sag`
/// at the stall (engine/removal/spindle.h): F (1 - sag F / F_stall) is largest at F_stall / (2 sag).
double push_that_removes_most_n(const SpindleSettings& handpiece, double radius_mm) noexcept {
  return stall_n_of(handpiece, radius_mm) * (handpiece.sag > 0.0 ? std::min(kOfStall, 0.5 / handpiece.sag) : kOfStall);
}
}  // namespace

double light_speed_share(const Scenario& scenario, std::uint16_t bur) noexcept {
  const SpindleSettings handpiece = handpiece_of(scenario);
  const double radius = radius_mm_of(scenario, bur), full = scenario.device.full_force_n;
  const double push = std::min(full, push_that_removes_most_n(handpiece, radius));
  return full > 0.0 ? push / full * (1.0 - handpiece.sag * push / stall_n_of(handpiece, radius)) : 1.0;
}

ScriptedOperator::ScriptedOperator(Plan plan, const OperatorStyle& style, const Scenario& scenario)
    : plan_(std::move(plan)),
      style_(style),
      muscles_(style.muscles, plan_.start_mm),
      full_force_n_(scenario.device.full_force_n),
      radius_mm_(radius_mm_of(scenario, plan_.bur)),
      hardest_push_n_(style.light ? push_that_removes_most_n(handpiece_of(scenario), radius_mm_)
                              : std::numeric_limits<double>::infinity()),
      coolant_(style.coolant && has_phenomenon(scenario.phenomena, "heat")),
      from_mm_(plan_.start_mm),
      lag_s_(style.muscles.delay_s +
             2.0 * style.muscles.damping_ratio *
                 std::sqrt(style.muscles.mass_kg / (1000.0 * style.muscles.stiffness_n_per_mm))) {
  for (const ScenarioTissue& t : scenario.tissues) feels_.push_back({t.stiffness_n_per_mm, t.speed_mm_s});
  if (feels_.empty()) feels_.push_back({});
  turn_to(0, plan_.start_mm);
}

void ScriptedOperator::begin(Vec3 from) noexcept {
  from_mm_ = from;
  since_s_ = clock_s_;
  if (stroke_ < plan_.strokes.size()) least_left_mm_ = glm::length(now().to_mm - from);
}

void ScriptedOperator::turn_to(std::size_t stroke, Vec3 from) noexcept {
  stroke_ = stroke;
  repositions_ = 0;
  reposition_step_ = kRepositionSteps;
  begin(from);
}

bool ScriptedOperator::reposition(Vec3 proxy) noexcept {
  const Stroke& stroke = plan_.strokes[stroke_];
  if (!stroke.cut || repositions_ >= kMaxRepositions) return false;
  const Vec3 to_end = stroke.to_mm - proxy;
  const double left = std::hypot(to_end.x, to_end.y);
  // The new place must lie before the stroke's end.
  const double further = kFurtherRadii * radius_mm_;
  if (left <= further) return false;
  ++repositions_;
  const Vec3 there = proxy + further / left * to_end;
  reposition_path_ = {{{Vec3(proxy.x, proxy.y, plan_.start_mm.z), true},
                {Vec3(there.x, there.y, plan_.start_mm.z), false},
                {Vec3(there.x, there.y, stroke.to_mm.z), true}}};
  reposition_step_ = 0;
  begin(proxy);
  return true;
}

const TissueFeel& ScriptedOperator::feel(double stiffness) const noexcept {
  const TissueFeel* best = &feels_.front();
  for (const TissueFeel& f : feels_)
    if (std::fabs(f.stiffness_n_per_mm - stiffness) < std::fabs(best->stiffness_n_per_mm - stiffness)) best = &f;
  return *best;
}

Vec3 ScriptedOperator::wanted(const StepOutput& last, double dt_s) noexcept {
  const Stroke& stroke = now();
  const Vec3 proxy = last.proxy_mm;
  const Vec3 whole = stroke.to_mm - from_mm_;
  const double length = glm::length(whole);
  const Vec3 to_end = stroke.to_mm - proxy;
  const double left = glm::length(to_end);
  if (left < 1e-9) return stroke.to_mm;
  const Vec3 along = length > 1e-6 ? whole / length : to_end / left;
  const double done = std::clamp(glm::dot(proxy - from_mm_, along), 0.0, length);
  const Vec3 off = from_mm_ + done * along - proxy;  // back to the line
  const double away = glm::length(off);

  const bool pressing = stroke.cut && last.contact;
  const TissueFeel& tissue = feel(last.stiffness_n_per_mm);
  const double most = pressing ? std::max(style_.feed * tissue.speed_mm_s, kLeastSpeedMmS)
                      : stroke.cut ? style_.approach_mm_s
                                   : style_.travel_mm_s;
  // Slows towards the end, except for the share that the next stroke carries on.
  const double to_go = length - done;
  double speed = to_go > 0.0 ? std::min(most, std::max(kEasePerS * to_go + carried_on() * most, kLeastSpeedMmS)) : 0.0;
  if (stroke.cut) speed *= std::clamp(1.0 - away / style_.wander_mm, 0.1, 1.0);
  Vec3 back = style_.correct_per_s * off;
  const double back_speed = glm::length(back);
  if (back_speed > most) back *= most / back_speed;
  const Vec3 velocity = along * speed + back;
  if (!pressing) {
    felt_ = Vec3(0.0);
    return proxy + velocity * lag_s_;
  }

  // The part against the felt force becomes a push, the part along the face a movement.
  const Vec3 spring = last.device_mm - last.proxy_mm;
  const double depth = glm::length(spring);
  if (glm::length(felt_) < 0.5) felt_ = along;  // just touched
  const double share = depth / (depth + style_.blunt_mm) * std::min(1.0, dt_s / style_.feel_s);
  if (depth > 1e-6) felt_ += (spring / depth - felt_) * share;
  const double sure = glm::length(felt_);
  const Vec3 into = sure > 1e-6 ? felt_ / sure : along;
  const double deeper = std::clamp(glm::dot(velocity, into), 0.0, most);
  const double stiffness = last.stiffness_n_per_mm > 0.0 ? last.stiffness_n_per_mm : tissue.stiffness_n_per_mm;
  // The side push stays small enough to stop when the bur breaks through; downwards the tissue holds it.
  const double down = std::clamp(-into.z, 0.0, 1.0);
  const double hardest = style_.side_push_n + down * down * std::max(0.0, full_force_n_ - style_.side_push_n);
  // A stalled handpiece runs up again without a push.
  const double no_way_s = clock_s_ - since_s_;
  if (std::isfinite(hardest_push_n_) && no_way_s > kStandsS && no_way_s < 2.0 * kStandsS) return proxy;
  const double push_n =
      std::min({full_force_n_ * deeper / std::max(tissue.speed_mm_s, kLeastSpeedMmS), hardest, hardest_push_n_});
  const Vec3 slide = velocity - glm::dot(velocity, into) * into;
  // A push of F holds the wanted place F (1/K + 1/grip) from the proxy.
  return proxy + into * (push_n * (1.0 / stiffness + 1.0 / muscles_.stiffness_n_per_mm())) +
         (slide + into * std::min(glm::dot(velocity, into), 0.0)) * lag_s_;
}

double ScriptedOperator::carried_on() const noexcept {
  if (stroke_ + 1 >= plan_.strokes.size() || reposition_step_ < kRepositionSteps) return 0.0;
  const Stroke& here = plan_.strokes[stroke_];
  const Stroke& next = plan_.strokes[stroke_ + 1];
  if (!here.cut || !next.cut) return 0.0;
  const Vec3 a = here.to_mm - from_mm_, b = next.to_mm - here.to_mm;
  const double size = glm::length(a) * glm::length(b);
  return size > 1e-12 ? std::max(0.0, glm::dot(a, b) / size) : 0.0;
}

bool ScriptedOperator::arrived(Vec3 proxy) const noexcept {
  const Stroke& stroke = now();
  const Vec3 to_end = stroke.to_mm - proxy;
  const double left = glm::length(to_end);
  if (!stroke.cut) return left <= kTravelArriveMm;
  if (left <= style_.arrive_mm) return true;
  // Past the end, and near enough for the next stroke to bring it back to its own line.
  return carried_on() > 0.0 && left <= style_.wander_mm && glm::dot(to_end, stroke.to_mm - from_mm_) <= 0.0;
}

bool ScriptedOperator::slipped(Vec3 proxy) const noexcept {
  const Vec3 whole = now().to_mm - from_mm_;
  const double square = glm::dot(whole, whole);
  const double done = square > 1e-12 ? std::clamp(glm::dot(proxy - from_mm_, whole) / square, 0.0, 1.0) : 0.0;
  const Vec3 off = proxy - (from_mm_ + done * whole);
  return off.z > kClimbedMm && std::hypot(off.x, off.y) > kSlippedWanders * style_.wander_mm;
}

Sample ScriptedOperator::next(const StepOutput& last, double dt_s) {
  clock_s_ += dt_s;
  Vec3 goal = muscles_.position_mm();
  if (!done()) {
    const double left = glm::length(now().to_mm - last.proxy_mm);
    if (left < least_left_mm_ - kProgressMm) {
      least_left_mm_ = left;
      since_s_ = clock_s_;
    }
    const bool blocked = clock_s_ - since_s_ > style_.patience_s;
    if (reposition_step_ < kRepositionSteps && (arrived(last.proxy_mm) || blocked)) {
      const Vec3 from = blocked ? last.proxy_mm : now().to_mm;
      if (blocked) repositions_ = kMaxRepositions;  // blocked on the way: no more tries
      ++reposition_step_;
      begin(from);
    } else if (arrived(last.proxy_mm)) {
      turn_to(stroke_ + 1, now().to_mm);
    } else if (blocked && !(glm::length(last.force_n) > kHeldN && reposition(last.proxy_mm))) {
      ++skipped_;
      // After a skipped stroke the next line starts at the bur's place.
      turn_to(stroke_ + 1, last.proxy_mm);
    }
    if (!done()) goal = wanted(last, dt_s);
  }
  Sample sample;
  sample.status = Sample::Status::fresh;
  sample.position_mm = muscles_.advance(goal, last.force_n, dt_s);
  sample.buttons = !done() && now().cut && !slipped(last.proxy_mm) ? StepInput::kCut : std::uint16_t{0};
  if (coolant_) sample.buttons |= StepInput::kCoolant;
  sample.bur = plan_.bur;
  return sample;
}

}  // namespace cusp::scenarios
