/// From a wish and what the step answered to the next device point: a hand that gives force, not depth.
/// Pure in (its state, wish, feedback, dt). Haptic thread: no allocation, no lock, bounded.
#pragma once

#include <optional>

#include "device/pointer/pointer_hand.h"
#include "engine/base/haptic_port.h"

namespace cusp::device {

/// All [M], by feel in the trials that tests/device repeats; each bounds how fast the point may move or load.
struct PointerTuning {
  double slide_mm_s = 20.0;        // across the approach while touching
  double travel_mm_s = 60.0;       // across the approach in the air
  double descend_mm_s = 10.0;      // along the approach until something is touched
  double retreat_mm_s = 40.0;      // lifting off
  double hover_mm = 3.0;           // height of the pivot above the shown place while lifted
  double reach_mm = 12.0;          // a push that meets nothing stops so far beyond the shown place
  double lateral_n = 1.0;          // most force across the approach
  double push_rise_n_s = 20.0;     // how fast a push builds up; it may fall at once
  double smoothing_s = 0.025;      // of the pointer's own steps
  double sweep_mm_s = 10.0;        // a pointer that moves so fast sideways halves the push: sweeping wins over sinking
  double sweep_keeps_s = 0.15;     // a turn of the pointer is no rest: its speed falls no faster
  double clear_mm = 1.0;           // so far above the first touch of a push the bur is out of what it cut
  double max_step_mm = 0.15;       // a tick never moves the point further, whatever happens
};

class PointerMotion {
 public:
  PointerMotion(Vec3 start_mm, const PointerTuning& tuning = {}) noexcept
      : tuning_(tuning), device_mm_(start_mm), smooth_mm_(start_mm) {}

  /// The device point after dt (cut to 4 ms: after a stall the hand goes on, it does not leap).
  Vec3 advance(const PointerWish& wish, const Feedback& feedback, double dt_s) noexcept;

  Vec3 device_mm() const noexcept { return device_mm_; }

 private:
  PointerTuning tuning_;
  Vec3 device_mm_;
  Vec3 smooth_mm_;     // the wish's place, smoothed
  double push_n_ = 0;  // the push as it builds up
  double sweep_ = 0;   // of the pointer across the approach, mm/s
  std::optional<Vec3> entry_mm_;  // highest place of contact since the bur was clear
};

}  // namespace cusp::device
