/// What of a force a hand would feel as vibration: what goes faster than 20 Hz, above what an arm moves at.
#pragma once

#include <vector>

#include "engine/base/vec.h"

namespace cusp::bench {

inline constexpr double kVibrationHz = 20.0;

/// Peak to peak over [from, to) of what a second-order Butterworth high-pass at 20 Hz, run forth and back (so that
/// nothing is shifted), leaves of a force sampled at 1 kHz; of the axis that has most. Pre: from < to <= size.
double vibration_n(const std::vector<Vec3>& force_n, std::size_t from, std::size_t to);

}  // namespace cusp::bench
