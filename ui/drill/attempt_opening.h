/// The beginning of an attempt, on a thread of its own: specimen, pictures, device, and the session itself. A Falcon that waits to be
/// homed can be looked at and called off meanwhile.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "ui/drill/drill_feed.h"
#include "ui/session/exercise_session.h"
#include "ui/session/session_device.h"
#include "ui/view/start_view.h"
#include "ui/view/tooth_cache.h"

namespace cusp::ui {

/// What the window gets.
struct OpenedAttempt {
  SessionDevice device;            // without its port
  std::shared_ptr<HapticPort> port;  // the device's; the session may keep it
  std::shared_ptr<PatchFeed> patches;
  std::shared_ptr<DrillFeed> feed;
  std::vector<OverlayLine> lines;
  std::shared_ptr<TargetLook> look;  // empty without guidance
  StartView start_view;
  std::shared_ptr<const SceneryLook> scenery;
  Box bounds;
  bool has_pulp = false;
  std::optional<double> pulp_depth_mm;  // of the highest pulp under the target, below its top
  std::unique_ptr<ExerciseSession> session;
};

class AttemptOpening {
 public:
  struct Order {
    SessionPlan plan;
    DeviceChoice choice;
    std::unique_ptr<HapticPort> port;    // instead of the device that was chosen
    std::shared_ptr<ToothCache> teeth;   // null: the tooth is made for this attempt alone
    std::function<void()> frame_wanted;  // called on the mirror's thread, as long as the attempt lives
  };
  /// On the opening's thread, once. Without a failure the session has started; with one, the attempt may be there or not.
  using Answer = std::function<void(std::shared_ptr<OpenedAttempt>, std::optional<SessionFailure>)>;

  /// Begins at once.
  AttemptOpening(Order order, Answer answer);
  /// Cancels, and waits until the device is released; for a driver that does not come back 3 s at most (ExerciseSession::start).
  ~AttemptOpening();
  AttemptOpening(const AttemptOpening&) = delete;
  AttemptOpening& operator=(const AttemptOpening&) = delete;

  // The window's thread.
  /// What is done now, and its share in [0, 1]; negative: it cannot be counted.
  struct Progress {
    std::optional<ToothPart> part;  // nullopt: device and session
    double share = -1;
  };
  Progress progress() const;
  /// A Falcon that is being opened; nullptr before and after, and for other devices.
  FalconPort* falcon() const noexcept { return falcon_.load(std::memory_order_acquire); }
  /// Tooth, device and the past of an attempt that resumes are waited for no longer, a driver that does not come back for 3 s. Comes as a
  /// failure.
  void call_off() noexcept;
  bool called_off() const noexcept { return called_off_; }

 private:
  void open(Order order, const Answer& answer);
  Outcome<std::shared_ptr<const ReadyTooth>> tooth(Order& order);

  // The port lives in the OpenedAttempt, which comes to the window whole, or the pointer is taken back first.
  std::atomic<FalconPort*> falcon_{nullptr};
  std::atomic<InversePort*> inverse_{nullptr};
  std::atomic<bool> over_{false};  // nothing more is done with the device
  std::atomic<bool> stop_{false};
  mutable std::mutex mutex_;  // guards progress_; held for a copy
  Progress progress_;
  bool called_off_ = false;
  std::thread thread_;
};

}  // namespace cusp::ui
