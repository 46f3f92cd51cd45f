/// The mirror: a live replay. It runs the same step on the loop's inputs, with its own volume, on its own thread. Its
/// state is exactly the one after some tick. Picture, scores and recorder read one consistent instant without a lock in
/// the volume. It may be late: then it skips showing, never ticks. Once a second it compares its digest with the loop's
/// of the same tick.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "engine/loop/tick.h"
#include "engine/step/step.h"

namespace cusp::engine {

/// What changed since the last call of MirrorObserver::on_state.
struct StateNews {
  std::span<const std::int32_t> changed_bricks;  // whose cut field changed since the last call, first cut first
  std::uint64_t behind_ticks = 0;                // inputs still in the ring
  bool first = false;                            // the mirror's first call: every cut brick is listed
  bool last = false;                             // the mirror's last call: no input will follow
};

/// Thread: the mirror's. The references are valid during the call.
class MirrorObserver {
 public:
  virtual ~MirrorObserver() = default;
  /// Every tick, in order, with the state after it. Must be quick: there are a thousand calls a second.
  virtual void on_tick(const StepInput& input, const StepState& after) {
    static_cast<void>(input);
    static_cast<void>(after);
  }
  /// About every show_every_us of session time, later if the mirror is late: the whole state, with its volume.
  virtual void on_state(const StepState& state, const StateNews& news) = 0;
  /// Between inputs, every few milliseconds: the state as it stands. Inputs wait in the ring until it returns.
  virtual void on_idle(const StepState& state) { static_cast<void>(state); }
};

/// Loop and mirror have different digests: the session is not deterministic, so its record is not exact.
struct Mismatch {
  std::uint64_t tick = 0;
  std::uint64_t loop_digest = 0, mirror_digest = 0;
};

struct MirrorSettings {
  std::uint32_t show_every_us = 25'000;  // of session time
};

class Mirror {
 public:
  /// `state` equals the loop's at its start. `hand_over` outlives the mirror.
  Mirror(StepState state, HandOver& hand_over, const MirrorSettings& settings = {});
  ~Mirror();
  Mirror(const Mirror&) = delete;
  Mirror& operator=(const Mirror&) = delete;

  /// Before start(). The observer outlives the mirror. Observers are called in the order of adding.
  void add(MirrorObserver& observer) { observers_.push_back(&observer); }

  void start();
  /// After the loop has stopped: steps every remaining input, makes the last call, joins.
  void stop();

  /// Without a thread: steps the inputs in the ring, on the caller's thread. Returns the number of ticks.
  std::uint64_t pump();
  /// Without a thread: pump(), then the observers' last call.
  void finish();

  /// Any thread.
  std::optional<Mismatch> mismatch() const noexcept;
  std::uint64_t ticks() const noexcept { return ticks_.load(std::memory_order_acquire); }
  std::uint64_t compared() const noexcept { return compared_.load(std::memory_order_acquire); }

  /// After stop() or finish().
  const StepState& state() const noexcept { return state_; }

 private:
  void run();
  void one(const StepInput& input);
  /// Calls on_state() of all observers. A mirror makes one last call.
  enum class Call : std::uint8_t { further, last };
  void show(Call call);
  void compare() noexcept;

  StepState state_;
  HandOver& hand_over_;
  MirrorSettings settings_;
  std::vector<MirrorObserver*> observers_;
  RunningDigest digest_;
  std::vector<std::uint32_t> shown_revision_;  // [brick]
  std::vector<std::int32_t> changed_;
  std::uint64_t next_show_us_ = 0;
  bool first_ = true;
  std::vector<DigestMark> own_, loop_marks_;  // digests not yet compared
  std::atomic<std::uint64_t> ticks_{0};
  std::atomic<std::uint64_t> compared_{0};
  std::atomic<bool> differs_{false};
  Mismatch mismatch_;                          // written once, before differs_
  std::atomic<bool> stop_{false};
  bool threaded_ = false;  // written once, before the thread starts
  std::thread thread_;
};

}  // namespace cusp::engine
