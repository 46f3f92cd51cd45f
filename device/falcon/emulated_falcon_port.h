/// A whole Falcon to choose where there is none: the real driver, bytes and all, over the emulated device, whose grip a
/// hand of the caller's moves (the mouse's, a script's).
#pragma once

#include <functional>

#include "device/falcon/emulated_link.h"
#include "device/falcon/falcon_port.h"

namespace cusp::device {

/// Where the hand has the bur, in the specimen.
struct EmulatedHandPose {
  Vec3 position_mm{0.0};
  bool cut = false;
  std::uint16_t bur = 0;
};

/// Haptic thread, once a sample: what was felt, and the time since the last call. Does not throw, allocate or wait.
using EmulatedHand = std::function<EmulatedHandPose(const Feedback& felt, double dt_s)>;

struct EmulatedFalconSettings {
  Vec3 start_mm{0.0};        // the middle of the device's workspace comes to lie here
  double scale = 0.5;        // as falcon::WorkspaceSettings: reaches 40 mm * scale about the start
  bool cold = false;         // begin without firmware, so that opening uploads an image made up for it
  bool closed_loop = false;  // false for a hand that gives force and not depth
  falcon::EmulatedTime time = falcon::EmulatedTime::runs;
  falcon::EmulatorSettings device{};
};

class EmulatedFalconPort final : public HapticPort {
 public:
  explicit EmulatedFalconPort(EmulatedHand hand, const EmulatedFalconSettings& settings = {});

  /// Uploads if it begins cold, and homes: it moves its own grip out and in.
  Result<void, PortFailure> open() override;
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  void write(const Feedback& feedback) noexcept override;
  DeviceLimits limits() const override { return port_.limits(); }
  void close() noexcept override { port_.close(); }

  /// The haptic thread's, or while the loop stands.
  falcon::Emulator& falcon() noexcept { return falcon_; }
  falcon::EmulatedLink& link() noexcept { return *link_; }
  const FalconView& view() noexcept { return port_.view(); }

 private:
  /// Moves the grip towards hand_mm_ by at most so much; true when it is there.
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
