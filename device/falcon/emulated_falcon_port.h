/// A Falcon without hardware: the real driver over the emulated device. A hand of the caller moves the grip (a mouse, or a
/// script).
#pragma once

#include <functional>

#include "device/falcon/emulated_link.h"
#include "device/falcon/falcon_port.h"

namespace cusp::device {

/// Position of the bur in the specimen.
struct EmulatedHandPose {
  Vec3 position_mm{0.0};
  bool cut = false;
  std::uint16_t bur = 0;
};

/// Called once a sample with the force and the time since the last call. Thread: haptic. Must not throw, allocate or wait.
using EmulatedHand = std::function<EmulatedHandPose(const Feedback& felt, double dt_s)>;

struct EmulatedFalconSettings {
  Vec3 start_mm{0.0};        // middle of the device's workspace, in the specimen
  double scale = 0.5;        // as falcon::WorkspaceSettings: reaches 40 mm * scale about the start
  bool cold = false;         // true: starts without firmware, so that opening uploads a dummy image
  bool closed_loop = false;  // false for a hand that gives force and not depth
  falcon::EmulatedTime time = falcon::EmulatedTime::runs;
  falcon::EmulatorSettings device{};
};

class EmulatedFalconPort final : public HapticPort {
 public:
  explicit EmulatedFalconPort(EmulatedHand hand, const EmulatedFalconSettings& settings = {});

  /// Uploads if cold, and homes by moving its own grip out and in.
  Result<void, PortFailure> open() override;
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  void write(const Feedback& feedback) noexcept override;
  DeviceLimits limits() const override { return port_.limits(); }
  void close() noexcept override { port_.close(); }

  /// Thread: haptic, or any while the loop stands.
  falcon::Emulator& falcon() noexcept { return falcon_; }
  falcon::EmulatedLink& link() noexcept { return *link_; }
  const FalconView& view() noexcept { return port_.view(); }

 private:
  /// Moves the grip towards hand_mm_, by at most `most_m`; true on arrival.
  bool lead(double most_m) noexcept;

  EmulatedHand hand_;
  Vec3 hand_mm_{0.0};
  EmulatedFalconSettings settings_;
  falcon::Workspace workspace_;
  falcon::Emulator falcon_;
  falcon::EmulatedLink* link_ = nullptr;  // port_'s
  FalconPort port_;
  Feedback felt_;
  falcon::LinkTime before_{0};
};

}  // namespace cusp::device
