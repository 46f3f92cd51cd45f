/// A HapticPort that adds a foot pedal to another port's samples. The larger of the two pedal values counts, so that a
/// device's own button keeps working.
#pragma once

#include <memory>

#include "engine/base/haptic_port.h"
#include "engine/base/pedal_source.h"

namespace cusp::device {

class PedalledPort final : public HapticPort {
 public:
  /// Pre: `port` outlives this.
  PedalledPort(HapticPort& port, std::shared_ptr<const PedalSource> pedal);

  Result<void, PortFailure> open() override { return port_.open(); }
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  bool over() const noexcept override { return port_.over(); }
  void write(const Feedback& feedback) noexcept override { port_.write(feedback); }
  DeviceLimits limits() const override { return port_.limits(); }
  void close() noexcept override { port_.close(); }

 private:
  HapticPort& port_;
  std::shared_ptr<const PedalSource> pedal_;
};

}  // namespace cusp::device
