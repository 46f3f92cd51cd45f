/// How a hand holds the device: its mass rides on the device's, a spring and a damper tie both to where the hand
/// intends to be. Same in all directions. Figures of soft and firm: the laboratory's two grips [M], after published
/// ranges of a hand's endpoint impedance; no measurement on a dental grip is known.
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
