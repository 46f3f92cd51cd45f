#include "device/hid/pedalled_sample.h"

#include <algorithm>

namespace cusp::device {

namespace {
constexpr std::uint16_t kCut = 1, kCoolant = 2;  // Sample::buttons
}

Sample pedalled(Sample sample, const PedalSource* pedal, std::chrono::steady_clock::time_point now) noexcept {
  if (pedal == nullptr || sample.status == Sample::Status::gone) return sample;
  const PedalReading reading = pedal->latest(now);
  sample.pedal = std::max(sample.pedal, reading.pressed);
  if (reading.pressed > 0) sample.buttons |= kCut;
  if (reading.coolant) sample.buttons |= kCoolant;
  return sample;
}

}  // namespace cusp::device
