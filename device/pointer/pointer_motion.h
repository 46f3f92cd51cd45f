/// The next device point from a request and the step's feedback, for a hand that gives force and not depth.
/// Pure in (its state, request, feedback, dt). Thread: haptic. No allocation, no lock, bounded.
#pragma once

#include <optional>

#include "device/pointer/pointer_hand.h"
#include "engine/base/haptic_port.h"

namespace cusp::device {

/// [M], all: set by feel in the trials that tests/device repeats. Each bounds how fast the point moves or loads.
struct PointerTuning {
  double slide_mm_s = 20.0;        // across the approach while touching
  double travel_mm_s = 60.0;       // across the approach in the air
  double descend_mm_s = 10.0;      // along the approach until something is touched
  double retreat_mm_s = 40.0;      // lifting off
  double hover_mm = 3.0;           // height of the pivot above the target while lifted
  double reach_mm = 12.0;          // a push without contact stops so far beyond the target
  double lateral_n = 1.0;          // most force across the approach, and against it
  double push_rise_n_s = 20.0;     // how fast a push builds up; it may fall at once
  double smoothing_s = 0.025;      // of the pointer's own steps
  double sweep_mm_s = 10.0;        // sideways speed that halves the push
  double sweep_keeps_s = 0.15;     // time constant of the falling speed, so that a turn of the pointer is no rest
  double rest_mm_s = 1.5;          // slower than this the hand rests, and its push sinks; a tremor of 1.5 pixels stays below
  double floor_waits_s = 0.6;      // a push that rests waits so long at the floor: twice what a hand needs to see and release
  double clear_mm = 1.0;           // height above the first contact of a push at which the bur is out of the cavity
  double max_step_mm = 0.15;       // largest move of the point in one tick
};

class PointerMotion {
 public:
  PointerMotion(Vec3 start_mm, const PointerTuning& tuning = {}) noexcept
      : tuning_(tuning), device_mm_(start_mm), smooth_mm_(start_mm) {}

  /// The device point after dt_s, limited to 4 ms: after a stall the point does not jump.
  Vec3 advance(const PointerWish& wish, const Feedback& feedback, double dt_s) noexcept;

  Vec3 device_mm() const noexcept { return device_mm_; }

 private:
  /// The deepest place along the approach that a push may reach now: a held depth; the floor, or deeper where the hand has
  /// rested, while it sweeps and until it has waited there. `depth`: of the pivot.
  double deepest(const PointerWish& wish, double depth, double dt) noexcept;

  PointerTuning tuning_;
  Vec3 device_mm_;
  Vec3 smooth_mm_;     // the target, smoothed
  double push_n_ = 0;  // the rising push
  double sweep_ = 0;   // of the pointer across the approach, mm/s
  std::optional<double> rested_depth_;  // along the approach, deepest of this push while the pointer rested
  double waited_s_ = 0;  // at the floor, since the pointer came to rest
  std::optional<Vec3> entry_mm_;  // highest contact since the bur was clear
};

}  // namespace cusp::device
