/// A hand's grip on the device: its mass adds to the device's; a spring and a damper connect both to the hand's
/// intended place. Alike in all directions. Soft and firm are the laboratory's two grips [M], after published ranges of
/// a hand's endpoint impedance; no measurement on a dental grip is known.
#pragma once

namespace cusp::engine::lab {

struct Grip {
  double stiffness_n_per_mm = 0.0;  // 0: nobody holds
  double damping_ns_per_m = 0.0;
  double mass_kg = 0.0;

  bool holds() const noexcept { return stiffness_n_per_mm > 0.0; }
};

inline constexpr Grip kNoGrip{};
inline constexpr Grip kSoftGrip{0.150, 2.0, 0.1};
inline constexpr Grip kFirmGrip{0.700, 8.0, 0.25};

}  // namespace cusp::engine::lab
