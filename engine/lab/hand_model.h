/// The muscles of a scripted hand: a mass held by spring and damper between where the mind wants it and the device's
/// force, late by the nerves' delay, with a tremor. The same numbers for the same seed on one build; only the inputs
/// that come out are recorded, so a replay does not need it. Thread: the one that plays.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::engine {

/// Of a hand resting on the teeth while it holds a handpiece [M]: order of magnitude of a braced precision grip.
struct HandSettings {
  double mass_kg = 0.15;            // handpiece and fingers
  double stiffness_n_per_mm = 1.0;  // grip
  double damping_ratio = 1.0;       // of mass and grip alone; 1 = no overshoot
  double delay_s = 0.02;            // from wanting to pulling, for a practised movement
  double tremor_mm = 0.0;           // rms of each axis
  double tremor_hz = 9.0;           // physiological tremor: 8 to 12 Hz
  std::uint64_t seed = 1;
};

class HandModel {
 public:
  HandModel(const HandSettings& settings, Vec3 start_mm);
  /// One tick: where the grip is, after the mind wanted `wanted_mm` and the device pushed with `force_n`.
  /// 0 < dt_s <= 0.05.
  Vec3 advance(Vec3 wanted_mm, Vec3 force_n, double dt_s);
  Vec3 position_mm() const noexcept { return position_mm_; }
  double stiffness_n_per_mm() const noexcept { return settings_.stiffness_n_per_mm; }

 private:
  double uniform() noexcept;  // [-1, 1)

  HandSettings settings_;
  Vec3 position_mm_, velocity_mm_s_{0.0};
  std::vector<Vec3> late_;  // ring: what was wanted, one place a millisecond
  std::size_t at_ = 0;
  double carry_s_ = 0;
  Vec3 tremor_mm_{0.0}, tremor_rate_{0.0};
  std::uint64_t random_;
};

}  // namespace cusp::engine
