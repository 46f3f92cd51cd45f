#include "device/hid/pedalled_port.h"

#include <algorithm>

namespace cusp::device {

namespace {
constexpr std::uint16_t kCut = 1, kCoolant = 2;  // Sample::buttons
}

PedalledPort::PedalledPort(HapticPort& port, std::shared_ptr<const PedalSource> pedal)
    : port_(port), pedal_(std::move(pedal)) {}

Sample PedalledPort::wait(std::chrono::steady_clock::time_point deadline) noexcept {
  Sample sample = port_.wait(deadline);
  if (!pedal_ || sample.status == Sample::Status::gone) return sample;
  const PedalReading reading = pedal_->latest(std::chrono::steady_clock::now());
  sample.pedal = std::max(sample.pedal, reading.pressed);
  if (reading.pressed > 0) sample.buttons |= kCut;
  if (reading.coolant) sample.buttons |= kCoolant;
  return sample;
}

}  // namespace cusp::device
