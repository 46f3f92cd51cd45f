/// Any device with a foot pedal beside it: what the pedal says is put into the device's samples. Whichever is further
/// down counts, so that a device's own button goes on working.
#pragma once

#include <memory>

#include "engine/base/haptic_port.h"
#include "engine/base/pedal_source.h"

namespace cusp::device {

class PedalledPort final : public HapticPort {
 public:
  /// `port` outlives this.
  PedalledPort(HapticPort& port, std::shared_ptr<const PedalSource> pedal);

  Result<void, PortFailure> open() override { return port_.open(); }
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  void write(const Feedback& feedback) noexcept override { port_.write(feedback); }
  DeviceLimits limits() const override { return port_.limits(); }
  void close() noexcept override { port_.close(); }

 private:
  HapticPort& port_;
  std::shared_ptr<const PedalSource> pedal_;
};

}  // namespace cusp::device
