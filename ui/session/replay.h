/// Old sessions: open their results, rebuild any moment of them, grade them, and prove that nothing was changed.
/// Thread: the store's. Rebuilding takes a few seconds for a long session.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "scenarios/metrics/process.h"
#include "storage/store.h"
#include "storage/verify.h"
#include "ui/session/exercise_run.h"

namespace cusp {

/// A stored session with everything that its replay needs.
struct OpenedSession {
  Session session;
  std::vector<SessionEvent> events;
  SessionState state = SessionState::running;
  ScenarioVersion version;
  Scenario scenario;
  std::shared_ptr<const Scene> scene;
  std::uint64_t ticks = 0;           // stored
  std::uint64_t elapsed_us = 0;
  bool same_engine = true;           // else inputs cannot be run again, only stored results open
};

/// storage, scenario, specimen_changed or scene.
Run<OpenedSession> open_session(Store& store, SessionId id);

/// A session being run again. Starts before the first tick.
class Replay {
 public:
  /// other_engine; storage when the trace cannot be read.
  static Run<Replay> open(Store& store, OpenedSession session);

  /// Runs to just after `tick` (at most the last): forward from where it stands, or from the nearest key state when that is
  /// less work. `full` forbids key states: then process() is of the whole session.
  Run<void> to(std::uint64_t tick, bool full = false);
  void add(Observer& observer) { observers_.push_back(&observer); }  // sees the state after each to()

  const OpenedSession& session() const noexcept { return session_; }
  const StepState& state() const noexcept { return *state_; }
  const std::vector<StepInput>& inputs() const noexcept { return inputs_; }
  /// Whole only when every tick from the first on was run.
  const Process& process() const noexcept { return process_; }

 private:
  Replay(Store& store, OpenedSession session, std::vector<StepInput> inputs);
  void show(bool first);
  Store* store_;
  OpenedSession session_;
  std::vector<StepInput> inputs_;
  std::optional<StepState> state_;
  Process process_;
  std::vector<Observer*> observers_;
  std::vector<std::uint32_t> shown_revision_;
  bool whole_ = true;   // every tick from the first on was run
  bool shown_ = false;
};

/// What stands in the database of a session: grade and final volume, without running it again. An interrupted one without
/// a final volume is rebuilt; one that was never graded is graded as it stands, and that is stored when `keep`.
Run<RunResult> open_result(Store& store, SessionId id, bool keep = false);

/// Rebuilds and grades, with the scenario's rubric or another one. `keep`: stores the grade (and the final volume of an
/// interrupted session). wrong_state while the session runs.
Run<RunResult> grade_session(Store& store, SessionId id, const Rubric* other_rubric, bool keep,
                             const std::optional<Actor>& grader = std::nullopt);

/// Proof of one session, in order: rows and chain (storage), each second's state hash, volume and grade bit for bit.
struct ReplayProof {
  Verification chain;
  bool same_engine = true;                      // else only the chain was checked
  int engine_version = 0;
  std::uint64_t ticks = 0, seconds_compared = 0;
  std::optional<std::uint64_t> differs_at_tick; // first stored state hash that the replay does not reach
  bool has_final_volume = false, volume_equal = false;
  bool has_grade = false, grade_equal = false;
  std::string grade_differs;                    // id of the first criterion that differs, or "score"
  std::uint64_t volume_hash = 0;                // of the replay
  /// Intact and reproduced as far as this engine can tell.
  bool holds() const noexcept;
};
Run<ReplayProof> prove_session(Store& store, SessionId id);

}  // namespace cusp
