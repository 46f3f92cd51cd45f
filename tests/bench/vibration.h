/// Vibration: the part of a force above 20 Hz, faster than an arm moves.
#pragma once

#include <vector>

#include "engine/base/vec.h"

namespace cusp::bench {

inline constexpr double kVibrationHz = 20.0;

/// Peak to peak over [from, to) of a force sampled at 1 kHz after a second-order Butterworth high-pass at kVibrationHz, run
/// forwards and backwards without phase shift; the largest of the three axes. Pre: from < to <= size.
double vibration_n(const std::vector<Vec3>& force_n, std::size_t from, std::size_t to);

}  // namespace cusp::bench
