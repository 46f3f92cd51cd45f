/// The port that a session's loop reads: the device's, with the foot pedal. It counts no cut that is held over a pause, stops a loop whose
/// driver stood still, and takes cut and force off the device on request, while the loop and its clock run.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>

#include "engine/base/haptic_port.h"
#include "engine/base/pedal_source.h"
#include "engine/loop/haptic_loop.h"
#include "ui/modules.h"
#include "ui/session/held_cut.h"

namespace cusp::ui {

/// A driver that does not come back for so long stands still; USB transfers time out within some ms.
inline constexpr std::chrono::seconds kSilent{1};

class WatchingPort final : public HapticPort {
 public:
  /// `port` outlives this. `pedal`: null for none. `held`: of a hand; a scripted operator knows what it presses.
  WatchingPort(HapticPort& port, std::shared_ptr<const PedalSource> pedal, const std::optional<HeldCut>& held)
      : port_(port), pedal_(std::move(pedal)), held_(held) {}
  /// Before the loop starts.
  void watch(HapticLoop& loop) noexcept { loop_ = &loop; }

  /// Any thread; only with `held`. The first sample after `false` re-arms: the force ramps in, as after a pause, and a cut that is held counts
  /// once it was released.
  void set_idle(bool on) noexcept { idle_.store(on, std::memory_order_release); }
  /// Any thread. Whether a stall has paused the loop since it ran last.
  bool stalled() const noexcept { return stalled_.load(std::memory_order_acquire); }
  /// Any thread. Whether a cut is held that counts for nothing. False while idle: nobody is to release it under a question.
  bool ignores_cut() const noexcept { return ignores_cut_.load(std::memory_order_acquire); }

  Result<void, PortFailure> open() override { return port_.open(); }
  /// Pauses the loop before the first tick after a driver, or the whole process, stood still for longer than kSilent: that tick would
  /// add the whole time to the session's clock, and a device that does not answer may not use up a time limit.
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  bool over() const noexcept override { return port_.over(); }
  void write(const Feedback& feedback) noexcept override;
  DeviceLimits limits() const override { return port_.limits(); }
  void close() noexcept override { port_.close(); }

 private:
  HapticPort& port_;
  std::shared_ptr<const PedalSource> pedal_;
  HapticLoop* loop_ = nullptr;
  std::atomic<bool> idle_{false}, stalled_{false}, ignores_cut_{false};
  // The haptic thread's.
  std::optional<HeldCut> held_;
  bool was_idle_ = false;                                        // in the sample before
  std::optional<std::chrono::steady_clock::time_point> before_;  // end of the wait() before
};

}  // namespace cusp::ui
