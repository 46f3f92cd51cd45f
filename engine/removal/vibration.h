/// What the hand feels of a cutting bur's turning. A handpiece turns 300 to 5800 times a second, and a force sampled
/// 1000 times a second would alias it to a false, slow beat. subharmonic_of therefore renders every n-th turn only, which keeps the beat at 250 Hz or below, at least four samples to a wave, and in
/// proportion to the speed; the drilling sound has the true pitch. Where ticks come slower than that the wave fades out
/// before it could fold over. Pure, exact arithmetic. Thread: haptic; wait-free. Figures are [M].
#pragma once

#include <cstdint>

#include "engine/removal/spindle.h"

namespace cusp::engine {

inline constexpr double kMostVibrationN = 0.060;      // never above: 60 mN
inline constexpr double kMostVibrationShare = 0.10;   // nor above this share of the contact force: it never pulls
inline constexpr double kFeltHz = 250.0;              // where skin feels vibration best; a quarter of 1 kHz
inline constexpr double kWholePushN = 1.0;            // the usual load (dental.md 3.3): from here on it is whole

struct VibrationState {
  std::uint32_t phase = 0;  // of the felt wave; 2^32 is the whole
};

/// Every how many turns one beat is felt: the least whole number that keeps free_rpm at kFeltHz or below. 1 at least.
int subharmonic_of(const SpindleSettings& settings) noexcept;

/// sin(2 pi phase / 2^32), by a polynomial: within 4e-6, and within [-1, 1].
double sine_of(std::uint32_t phase) noexcept;

/// One tick: moves the phase on, and gives the wave's value in N, to be felt along the contact force. hardness: of what is
/// touched, 0 to 1, 1 the hardest of the scene. At rest, in the air, and with values that are no numbers: 0.
double vibration_n(VibrationState& state, const SpindleSettings& settings, double rpm, double push_n, double hardness,
                   double dt_s) noexcept;

}  // namespace cusp::engine
