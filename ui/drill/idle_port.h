/// A HapticPort that takes cut and force off a device on request, while the loop and its clock run. It adds the foot pedal
/// itself, because a pedal that is added later would still cut.
#pragma once

#include <atomic>
#include <memory>

#include "engine/base/haptic_port.h"
#include "engine/base/pedal_source.h"
#include "ui/modules.h"
#include "ui/session/held_cut.h"

namespace cusp::ui {

class IdlePort final : public HapticPort {
 public:
  /// `pedal` may be null.
  IdlePort(std::unique_ptr<HapticPort> port, std::shared_ptr<const PedalSource> pedal) : port_(std::move(port)), pedal_(std::move(pedal)) {}

  /// Any thread. The first sample after `false` re-arms: the force ramps in, as after a pause, and a cut that is held counts once it
  /// was released.
  void set_idle(bool on) noexcept { idle_.store(on, std::memory_order_release); }

  /// Any thread. Whether a cut is held, since a question that is over, that counts for nothing.
  bool ignores_cut() const noexcept { return ignores_cut_.load(std::memory_order_acquire); }

  Result<void, PortFailure> open() override { return port_->open(); }
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  bool over() const noexcept override { return port_->over(); }
  void write(const Feedback& feedback) noexcept override;
  DeviceLimits limits() const override { return port_->limits(); }
  void close() noexcept override { port_->close(); }

 private:
  std::unique_ptr<HapticPort> port_;
  std::shared_ptr<const PedalSource> pedal_;
  std::atomic<bool> idle_{false}, ignores_cut_{false};
  // The haptic thread's.
  HeldCut held_;
  bool was_idle_ = false;  // in the sample before
};

}  // namespace cusp::ui
