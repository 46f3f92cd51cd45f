/// Mouse and keyboard as a HapticPort; the default of a new installation. The hand gives force: the device point stands
/// push / K beyond the proxy along the approach, and follows the pointer across it.
#pragma once

#include <chrono>

#include "device/pointer/pointer_hand.h"
#include "device/pointer/pointer_motion.h"
#include "engine/base/haptic_port.h"

namespace cusp::device {

class PointerPort final : public HapticPort {
 public:
  /// start_mm: start of the bur, outside the tissue.
  explicit PointerPort(Vec3 start_mm, const PointerTuning& tuning = {});

  /// For the UI thread; lives as long as the port.
  PointerHand& hand() noexcept { return hand_; }

  Result<void, PortFailure> open() override;
  /// Sleeps to the deadline. dt is the time between deadlines, so that a late thread moves the point no further.
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  void write(const Feedback& feedback) noexcept override;
  DeviceLimits limits() const override;
  void close() noexcept override;

 private:
  PointerHand hand_;
  PointerMotion motion_;
  Feedback feedback_;
  std::chrono::steady_clock::time_point before_{};
  bool has_before_ = false;
  bool open_ = false;
};

}  // namespace cusp::device
