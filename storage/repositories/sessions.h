/// Sessions: one attempt at a scenario. A session's row never changes; events are rows of their own. Every row of a session
/// joins its hash chain in the transaction that writes it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/haptic_port.h"
#include "engine/scene/scene.h"
#include "storage/records/context.h"
#include "storage/modules.h"
#include "storage/repositories/scenarios.h"
#include "storage/base/rights.h"

namespace cusp::storage {

enum class SessionKind : std::uint8_t {
  practice,
  assessment,
  try_it,   // a guest's; not in histories or figures
  try_out,  // an instructor's, in the editor; not in histories or figures
};
std::string_view key_of(SessionKind kind) noexcept;

enum class SessionState : std::uint8_t { running, interrupted, finished, graded, closed };
std::string_view key_of(SessionState state) noexcept;

enum class EventKind : std::uint8_t {
  started,      // first event of every session
  interrupted,  // its process ended without finishing, or the recorder could not keep up
  resumed,      // continues after an interruption
  finished,     // the student, the time limit or the script ended it
  graded,       // a grade row was written
  closed,       // cannot be resumed any more
};
std::string_view key_of(EventKind kind) noexcept;

/// What a replay needs besides the scenario and the inputs. Stored as JSON with exact numbers.
struct SessionHeader {
  int engine_version = kEngineVersion;
  std::string build{};  // version and commit of the program
  DeviceLimits device{};
  std::string calibration{};        // name of the device's calibration; empty = none
  GuardSettings guard{};            // as used, limited to the device
  double stiffness_share = 1.0;     // of the scenario's stiffness, as used
  std::uint64_t specimen_hash = 0;  // Specimen::hash() at start
  Hash256 specimen_blob{};          // of the voxels in Blobs; zeros = none stored
  std::string scene{};              // the caller's JSON of the scene; stored as given
  std::string exercise{};           // canonical JSON of the exercise as it was fitted to a drawn tooth; empty: the version's
  int extra_time_percent = 0;       // beyond the scenario's time limit; start() sets it
  bool large_text = false;          // start() sets it
};

/// The operator of a session that a user drilled; the column is called `hand`.
inline constexpr std::string_view kUserOperator = "person";

struct NewSession {
  UserId student{};
  VersionId version{};
  SessionKind kind = SessionKind::practice;
  std::optional<AssignmentId> assignment{};  // an assessment has one
  std::string start_code{};                  // as the student typed it, for an assessment
  std::string operator_name{kUserOperator};  // or a scripted operator: "expert", "novice", a file's name
  SessionHeader header{};
};

struct Session {
  SessionId id{};
  UserId student{};
  VersionId version{};
  Hash256 version_hash{};  // content hash of the version
  SessionKind kind = SessionKind::practice;
  std::optional<AssignmentId> assignment{};
  std::string operator_name{};
  std::int64_t started_utc_us = 0;
  SessionHeader header{};
};

struct SessionEvent {
  EventKind kind = EventKind::started;
  std::int64_t at_utc_us = 0;
  std::int64_t sequence = 0;  // the station's
  std::uint64_t tick = 0;     // last stored tick
  std::string reason{};       // code: "student", "time_limit", "script", "process_gone", "recorder_full", ...
};

/// The specimen at the end: Volume::save_cuts() and Volume::hash().
struct FinalVolume {
  std::vector<std::byte> cuts{};
  std::uint64_t hash = 0;
  std::uint64_t tick = 0;  // after this many ticks
};

class Sessions {
 public:
  explicit Sessions(StorageContext& context) : c_{context} {}

  /// Row and event "started", in one transaction. Needs drill; `student` is the actor. A guest's session is always try_it.
  /// disabled (where = actor), not_found for an unknown version, bad_value for a header with a number that is not finite, or with an exercise
  /// where the assignment draws no tooth (where = exercise), or without one where it does.
  /// With an assignment kind and adjustment are the assignment's; not_allowed (where = assignment: not this student's or of another
  /// version; start_code), wrong_state (where = not_open, past_due, attempts_used),
  /// other_device and self_test_due by the header's device class.
  Stored<Session> start(const Actor& actor, const NewSession& session);
  /// What start() would say of an assignment's students, dates, attempts, start code, devices and their self-tests. Writes nothing.
  Stored<void> admit(const Actor& actor, const NewSession& session);
  /// This process then owns the session. wrong_state unless interrupted, (where = volume_kept) if an older program has kept its volume:
  /// a session has one, so it could not be finished. disabled (where = actor) if its student's account was switched off.
  Stored<void> resume(SessionId session, const std::string& reason);
  /// wrong_state unless running.
  Stored<void> interrupt(SessionId session, const std::string& reason);
  /// The final volume and the event "finished", in one transaction. wrong_state unless running.
  Stored<void> finish(SessionId session, const FinalVolume& volume, const std::string& reason);
  /// wrong_state while running.
  Stored<void> close(SessionId session, const std::string& reason);

  /// Adds the event "interrupted" to this station's running sessions whose process has certainly ended; returns their ids.
  Stored<std::vector<SessionId>> mark_interrupted();

  Stored<Session> find(SessionId session);  // not_found; corrupt if the header cannot be read
  Stored<std::vector<SessionEvent>> events(SessionId session);
  Stored<SessionState> state(SessionId session);

 private:
  Stored<void> add_event(SessionId session, EventKind kind, const std::string& reason, const FinalVolume* volume);
  StorageContext& c_;
};

/// The state after the session's events, in order.
SessionState state_after(const std::vector<SessionEvent>& events) noexcept;

}  // namespace cusp::storage
