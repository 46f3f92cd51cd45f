#include "device/pointer/pointer_motion.h"

#include <algorithm>
#include <cmath>

namespace cusp::device {
namespace {

/// Longest time of one tick: after a stall the point continues from its position.
constexpr double kMostDtS = 0.004;
/// Slower than this the pointer rests, mm/s.
constexpr double kStillMmS = 0.5;
/// Softer is not met (plastic 1 N/mm and up); keeps push / K finite.
constexpr double kLeastStiffness = 0.05;

Vec3 shortened(Vec3 v, double most) noexcept {
  const double length = glm::length(v);
  return length > most ? v * (most / length) : v;
}

bool all_finite(Vec3 v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Largest steps of one tick.
struct Steps {
  double up, down;
};

/// From `from` towards `to`, by at most one step.
double towards(double from, double to, Steps most) noexcept {
  return std::clamp(to, from - most.down, from + most.up);
}

}  // namespace

double PointerMotion::deepest(const PointerWish& wish, double depth, double dt) noexcept {
  if (sweep_ < tuning_.rest_mm_s) {
    rested_depth_ = std::max(rested_depth_.value_or(depth), depth);
    if (depth < wish.floor_mm) return wish.stop_mm;
    waited_s_ += dt;
    if (waited_s_ > tuning_.floor_waits_s) return wish.stop_mm;
  } else {
    waited_s_ = 0;
  }
  return std::min(wish.stop_mm, std::max(wish.floor_mm, rested_depth_.value_or(wish.floor_mm)));
}

Vec3 PointerMotion::advance(const PointerWish& wish, const Feedback& feedback, double dt_s) noexcept {
  const double dt = dt_s > 0.0 ? std::min(dt_s, kMostDtS) : 0.0;
  const Vec3 proxy = all_finite(feedback.proxy_mm) ? feedback.proxy_mm : device_mm_;
  const bool touches = feedback.in_contact && all_finite(feedback.proxy_mm);
  const double stiffness =
      feedback.stiffness_n_per_mm > kLeastStiffness ? feedback.stiffness_n_per_mm : kLeastStiffness;
  const bool pushing = wish.push_n > 0.0 && !feedback.faulted;

  const Vec3 lag = wish.target_mm - smooth_mm_;
  const double asked_speed = glm::length(lag - wish.approach * glm::dot(lag, wish.approach)) / tuning_.smoothing_s;
  sweep_ = std::max(std::min(asked_speed, tuning_.travel_mm_s), sweep_ * (1.0 - dt / tuning_.sweep_keeps_s));
  const double sweeping = 1.0 / (1.0 + std::max(0.0, sweep_ - kStillMmS) / tuning_.sweep_mm_s);
  smooth_mm_ += (wish.target_mm - smooth_mm_) * (dt / (tuning_.smoothing_s + dt));

  // Along the approach: depths grow into the tissue.
  const Vec3 along = wish.approach;
  const double depth = glm::dot(device_mm_, along);
  const double proxy_depth = glm::dot(proxy, along);
  const double shown_depth = glm::dot(wish.target_mm, along);
  const double sink = tuning_.descend_mm_s * dt;
  const double rise = tuning_.retreat_mm_s * dt;
  double next_depth = depth;
  if (touches && (!entry_mm_ || proxy_depth < glm::dot(*entry_mm_, along))) entry_mm_ = proxy;
  const double clear_depth = entry_mm_ ? glm::dot(*entry_mm_, along) - tuning_.clear_mm : depth;
  if (!touches && depth <= clear_depth) entry_mm_.reset();
  const bool retracts = !pushing && entry_mm_;
  if (!pushing) {
    push_n_ = 0;
    rested_depth_.reset();
    waited_s_ = 0;
    // Off first what is touched and out of what was cut, then to the height of hovering.
    next_depth = retracts ? std::min(depth, proxy_depth) - rise
                          : towards(depth, shown_depth - tuning_.hover_mm, {sink, rise});
    // A ledge may hold it.
    if (touches) next_depth = std::max(next_depth, proxy_depth - tuning_.lateral_n / stiffness);
  } else if (touches) {
    push_n_ = std::min(wish.push_n * sweeping, push_n_ + tuning_.push_rise_n_s * dt);
    // The contact may be a wall's: then nothing holds the bur, and it sinks no faster than through the air.
    next_depth = std::min({proxy_depth + push_n_ / stiffness, depth + sink, deepest(wish, proxy_depth, dt)});
  } else {
    push_n_ = 0;
    next_depth = towards(depth, std::min(shown_depth + tuning_.reach_mm, deepest(wish, depth, dt)), {sink, rise});
  }

  // Across: the pointer's place, as fast as a hand would, pulling with no more than lateral_n.
  const Vec3 across = device_mm_ - along * depth;
  // On its way out it pulls at no wall.
  const Vec3 goal = retracts ? proxy - along * proxy_depth : smooth_mm_ - along * glm::dot(smooth_mm_, along);
  const double speed = touches ? tuning_.slide_mm_s : tuning_.travel_mm_s;
  Vec3 next = across + shortened(goal - across, speed * dt) + along * next_depth;
  if (touches) {
    Vec3 pull = next - proxy;
    const double pull_depth = glm::dot(pull, along);
    pull = along * pull_depth + shortened(pull - along * pull_depth, tuning_.lateral_n / stiffness);
    next = proxy + shortened(pull, PointerHand::kMaxPushN / stiffness);
  }

  const Vec3 moved = device_mm_ + shortened(next - device_mm_, tuning_.max_step_mm);
  if (all_finite(moved)) device_mm_ = moved;
  return device_mm_;
}

}  // namespace cusp::device
