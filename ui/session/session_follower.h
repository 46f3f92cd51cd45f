/// Follows an attempt on the mirror's thread: keeps the live scores, cuts the inputs into seconds for the recorder, and copies
/// what panels show under a mutex that the loop never takes.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "engine/mirror/mirror.h"
#include "scenarios/metrics/live.h"
#include "scenarios/metrics/process.h"
#include "ui/modules.h"
#include "ui/session/recorder.h"
#include "ui/session/removed_scores.h"
#include "ui/session/second_scorer.h"

namespace cusp::ui {

/// The mirror's part of LiveView.
struct FollowedView {
  std::uint64_t tick = 0, elapsed_us = 0;
  LiveReading scores;
  double deepest_mm = 0;
  double peak_push_n = 0;
};

class SessionFollower final : public MirrorObserver {
 public:
  /// Who reads the live scores: a screen ten times a second, or the record alone, once a second and on a thread of its own; view() has
  /// none then.
  enum class Scores : std::uint8_t { for_a_screen, for_the_record };
  struct Settings {
    Recorder* recorder = nullptr;  // null: nothing is kept
    Process process;               // of the part before, when a session is resumed
    double time_limit_s = 0;       // of session time; 0: none
    std::function<void()> hold;    // stops the loop's clock; mirror's thread; may be empty
    Scores scores = Scores::for_a_screen;
  };
  /// Calls `hold` when the record cannot be written and when the time limit is reached.
  SessionFollower(std::shared_ptr<const Reference> reference, const StepState& start, Settings settings);

  void on_tick(const StepInput& input, const StepState& after) override;
  void on_state(const StepState& state, const StateNews& news) override;

  /// Any thread.
  FollowedView view() const;
  /// Any thread. Whether the time limit is reached; never false again. Not in view(): a held loop brings no new state.
  bool time_is_up() const noexcept { return time_is_up_.load(std::memory_order_acquire); }
  /// After the mirror has stopped.
  const Process& process() const noexcept { return process_; }

 private:
  /// Into changed_: bricks that were cut since the last call.
  void find_changed(const Volume& volume);
  void update_scores(const Volume& volume);
  void flush(const StepState& after);
  /// Gives second_ to the recorder, with what was removed.
  void record(const Volume& volume, std::optional<KeyState> key_state);

  std::shared_ptr<const Reference> reference_;
  Recorder* recorder_;
  std::function<void()> hold_;
  Scores scores_;
  std::uint64_t limit_us_;  // of session time
  std::atomic<bool> time_is_up_{false};
  RemovedScores removed_;                 // for a screen
  std::unique_ptr<SecondScorer> scorer_;  // for the record; null without one, and after the last state
  Process process_;
  double deepest_mm_ = 0;

  std::vector<std::uint32_t> seen_revision_;  // [brick]
  std::vector<std::int32_t> changed_;

  RecordedSecond second_;
  std::uint64_t next_second_us_, next_key_us_;
  std::uint64_t next_scores_us_ = 0;
  double impulse_n_us_ = 0;
  std::uint64_t contact_us_ = 0;

  mutable std::mutex mutex_;
  FollowedView view_;
};

}  // namespace cusp::ui
