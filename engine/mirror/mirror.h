/// The mirror: a replay that runs live. A second run of the same step on the loop's inputs, with its own volume, on its
/// own thread. Always exactly the state after some tick, so that picture, scores and recorder see one consistent
/// instant without a lock in the volume. It may run behind (then it skips showing, never ticks), never wrong: once a
/// second its digest is compared with the loop's at the same tick.
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
  std::uint64_t behind_ticks = 0;                // inputs that still wait
  bool first = false;                            // the first call of this run: every cut brick is listed
  bool last = false;                             // no further input will come
};

/// Thread: all calls come from the mirror's. The references live only as long as the call.
class MirrorObserver {
 public:
  virtual ~MirrorObserver() = default;
  /// Every tick, in order, with the state after it. To be quick: it runs a thousand times a second.
  virtual void on_tick(const StepInput& input, const StepState& after) {
    static_cast<void>(input);
    static_cast<void>(after);
  }
  /// About every show_every_us of session time: the whole state, with its volume. Later when it runs behind.
  virtual void on_state(const StepState& state, const StateNews& news) = 0;
};

/// The loop and its mirror came to different digests: the run is not deterministic, the record cannot be trusted.
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

  /// Before start(). The observer outlives the mirror; called in the order of adding.
  void add(MirrorObserver& observer) { observers_.push_back(&observer); }

  void start();
  /// After the loop has stopped: works through every input left, makes the last call, joins.
  void stop();

  /// Without a thread: works through what waits, on the caller's thread. Returns the ticks done.
  std::uint64_t pump();
  /// Without a thread: pump, then the last call to the observers.
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
  void show(bool last);
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
  std::vector<DigestMark> own_, loop_marks_;   // digests that wait for their opposite
  std::atomic<std::uint64_t> ticks_{0};
  std::atomic<std::uint64_t> compared_{0};
  std::atomic<bool> differs_{false};
  Mismatch mismatch_;                          // written once, before differs_
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace cusp::engine
