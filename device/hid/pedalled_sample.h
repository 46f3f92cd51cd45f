/// Adds a foot pedal to a device's sample. Pure but for the pedal's newest value. Thread: haptic; no allocation, no lock.
#pragma once

#include <chrono>

#include "engine/base/haptic_port.h"
#include "engine/base/pedal_source.h"

namespace cusp::device {

/// The larger of the two pedal values counts, so that a device's own button keeps working. A lost device holds nothing down.
/// `pedal`: null for none.
Sample pedalled(Sample sample, const PedalSource* pedal, std::chrono::steady_clock::time_point now) noexcept;

}  // namespace cusp::device
