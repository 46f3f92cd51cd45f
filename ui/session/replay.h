/// Old sessions: open their results, rebuild any moment of them, grade them, and prove that nothing was changed.
/// Thread: the store's. Rebuilding takes a few seconds for a long session.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "scenarios/metrics/process.h"
#include "storage/store.h"
#include "storage/records/verify.h"
#include "ui/modules.h"
#include "ui/session/exercise_session.h"

namespace cusp::ui {

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
  bool same_engine = true;           // else inputs cannot be replayed, only stored results open
};

/// The exercise that a session is of: its version's, or what its header says that was fitted to a drawn tooth. scenario.
Outcome<Scenario> exercise_of(const Session& session, const ScenarioVersion& version);

/// storage, scenario, specimen_changed or scene.
Outcome<OpenedSession> open_session(Store& store, SessionId id);

/// Where a jump may begin.
enum class ReplayFrom : std::uint8_t {
  nearest,        // at the nearest key state that can be trusted; process() then lacks what was before
  whole_process,  // at one that brings process() along
  first_tick,     // nothing but the inputs is believed: for grades and proofs
};
struct ReplayJump {
  ReplayFrom from = ReplayFrom::nearest;
  bool keep = false;                         // key states that are missing on the way go to the store's cache
  std::function<bool(double share)> watch{};  // some times a second, 0 to 1 of this jump; false stops it
};

/// A session being replayed. Starts before the first tick. A key state is believed only if its hash is the one that the
/// chained second that ends there has; any other is passed over. To fill the cache in the background: a second Replay, on
/// a thread and a Store of its own, to the end with `first_tick` and `keep`.
class Replay {
 public:
  /// other_engine; storage when the trace cannot be read.
  static Outcome<Replay> open(Store& store, OpenedSession session);

  /// Computes to just after `tick` (at most the last): forward from where it stands, or from a key state when that is less
  /// work. False: `watch` stopped it, and it stands at state().
  Outcome<bool> to(std::uint64_t tick, const ReplayJump& jump = {});
  void add(Observer& observer) { observers_.push_back(&observer); }  // sees the state after each to()

  const OpenedSession& session() const noexcept { return session_; }
  const StepState& state() const noexcept { return *state_; }
  const std::vector<StepInput>& inputs() const noexcept { return inputs_; }
  /// Of every tick from the first on, unless a jump began at the nearest key state.
  const Process& process() const noexcept { return process_; }
  /// Ticks that to() has computed since open(): what jumps cost, without a clock.
  std::uint64_t ticks_computed() const noexcept { return ticks_computed_; }

 private:
  /// The end of a recorded second.
  struct Mark {
    std::uint64_t state_hash = 0;
    bool key = false;     // the first end of a second after another five: where a key state is kept
    bool stored = false;  // there is a row of an older program
    bool cached = false;  // as far as is known: others fill and empty the cache too
  };
  Replay(Store& store, OpenedSession session, std::vector<StepInput> inputs);
  Outcome<void> read_marks();
  void look_into_cache();
  std::optional<KeyState> key_state_at(std::uint64_t tick, Mark& mark);
  bool restore_nearest(std::uint64_t target, std::uint64_t after, ReplayFrom from);
  void keep_key_state(Mark& mark);
  bool run(std::uint64_t target, const ReplayJump& jump);
  void begin_anew();
  /// Which bricks the observers hear of: the cut ones that changed, or every cut one after a jump.
  enum class Shown : std::uint8_t { changed, all };
  void show(Shown bricks);

  Store* store_;
  OpenedSession session_;
  std::vector<StepInput> inputs_;
  std::map<std::uint64_t, Mark> marks_;  // by tick
  std::optional<StepState> state_;
  Process process_;
  std::vector<Observer*> observers_;
  std::vector<std::uint32_t> shown_revision_;
  std::uint64_t ticks_computed_ = 0;
  bool whole_ = true;          // process_ is of every tick from the first on
  bool computed_ = true;       // and every one of them was computed here
  bool cache_refuses_ = false;
  bool shown_ = false;
};

/// What a grading leaves in the database. `grade`: the grade, and the final volume of an interrupted session.
enum class Keep : std::uint8_t { nothing, grade };

/// What stands in the database of a session: grade and final volume, without computing it again. An interrupted one without
/// a final volume is rebuilt; one that was never graded is graded as it stands.
Outcome<SessionResult> open_result(Store& store, SessionId id, Keep keep = Keep::nothing);

/// Rebuilds and grades, with the scenario's rubric or another one. wrong_state while the session is running.
Outcome<SessionResult> grade_session(Store& store, SessionId id, const Rubric* other_rubric, Keep keep,
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
  /// Intact and reproduced as far as this engine can compute.
  bool holds() const noexcept;
};
Outcome<ReplayProof> prove_session(Store& store, SessionId id);

}  // namespace cusp::ui
