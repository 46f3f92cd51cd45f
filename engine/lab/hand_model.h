/// The hand of a scripted operator: a mass on a spring and a damper, between the wanted place and the device's force.
/// It has a delay and a tremor. The same numbers for the same seed on one build. A replay does not need it, because the
/// inputs are recorded. Thread: the operator's.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::engine {

/// A hand that rests on the teeth and holds a handpiece [M]: order of magnitude of a braced precision grip.
struct HandSettings {
  double mass_kg = 0.15;            // handpiece and fingers
  double stiffness_n_per_mm = 1.0;  // grip
  double damping_ratio = 1.0;       // of mass and grip alone; 1 = no overshoot
  double delay_s = 0.02;            // from the wanted place to the muscles' force, for a practised movement
  double tremor_mm = 0.0;           // rms of each axis
  double tremor_hz = 9.0;           // physiological tremor: 8 to 12 Hz
  std::uint64_t seed = 1;
};

class HandModel {
 public:
  HandModel(const HandSettings& settings, Vec3 start_mm);
  /// One tick. Returns the grip's place. force_n: of the device. 0 < dt_s <= 0.05.
  Vec3 advance(Vec3 wanted_mm, Vec3 force_n, double dt_s);
  Vec3 position_mm() const noexcept { return position_mm_; }
  double stiffness_n_per_mm() const noexcept { return settings_.stiffness_n_per_mm; }

 private:
  double uniform() noexcept;  // [-1, 1)

  HandSettings settings_;
  Vec3 position_mm_, velocity_mm_s_{0.0};
  std::vector<Vec3> late_;  // ring of wanted places, one a millisecond
  std::size_t at_ = 0;
  double carry_s_ = 0;
  Vec3 tremor_mm_{0.0}, tremor_rate_{0.0};
  std::uint64_t random_;
};

}  // namespace cusp::engine
