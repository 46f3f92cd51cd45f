/// Sessions: one go at a scenario. The row never changes; what happens to it are event rows. Every row of a session
/// joins its hash chain in the transaction that writes it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/haptic_port.h"
#include "engine/scene/scene.h"
#include "storage/context.h"
#include "storage/modules.h"
#include "storage/repositories/scenarios.h"
#include "storage/rights.h"

namespace cusp::storage {

enum class SessionKind : std::uint8_t {
  practice,
  assessment,
  try_it,   // a guest's: never in histories or figures
  try_out,  // an instructor's in the editor: likewise
};
std::string_view key_of(SessionKind kind) noexcept;

enum class SessionState : std::uint8_t { running, interrupted, finished, graded, closed };
std::string_view key_of(SessionState state) noexcept;

enum class EventKind : std::uint8_t {
  started,      // first event of every session
  interrupted,  // its process ended without finishing, or the recorder could not keep up
  resumed,      // goes on after an interruption
  finished,     // the student, the time limit or the script ended it
  graded,       // a grade row was written
  closed,       // nobody may resume it any more
};
std::string_view key_of(EventKind kind) noexcept;

/// What a replay needs besides the scenario and the inputs. Stored as JSON with exact numbers.
struct SessionHeader {
  int engine_version = kEngineVersion;
  std::string build{};  // version and commit of the program
  DeviceLimits device{};
  std::string calibration{};        // the device's, as it names it; empty = none
  GuardSettings guard{};            // as used: already cut to the device
  double stiffness_share = 1.0;     // of the scenario's stiffness, as used
  std::uint64_t specimen_hash = 0;  // Specimen::hash() at start
  Hash256 specimen_blob{};          // of the voxels in Blobs; zeros when none were kept
  std::string scene{};              // the caller's own account of the scene (JSON); kept as given
};

struct NewSession {
  UserId student{};
  VersionId version{};
  SessionKind kind = SessionKind::practice;
  std::optional<AssignmentId> assignment{};
  std::string hand = "person";  // "person", or the scripted hand: "expert", "novice", a file's name
  SessionHeader header{};
};

struct Session {
  SessionId id{};
  UserId student{};
  VersionId version{};
  Hash256 version_hash{};  // content hash of the version
  SessionKind kind = SessionKind::practice;
  std::optional<AssignmentId> assignment{};
  std::string hand{};
  std::int64_t started_utc_us = 0;
  SessionHeader header{};
};

struct SessionEvent {
  EventKind kind = EventKind::started;
  std::int64_t at_utc_us = 0;
  std::int64_t sequence = 0;  // the station's
  std::uint64_t tick = 0;     // last tick stored when it happened
  std::string reason{};       // code: "student", "time_limit", "script", "process_gone", "recorder_full", ...
};

/// What is left of the specimen: Volume::save_cuts() and Volume::hash().
struct FinalVolume {
  std::vector<std::byte> cuts{};
  std::uint64_t hash = 0;
  std::uint64_t tick = 0;  // after this many ticks
};

class Sessions {
 public:
  explicit Sessions(StorageContext& context) : c_{context} {}

  /// Row and started event, in one transaction. Needs drill; `student` is the actor. The kind is try_it for a guest
  /// whatever was asked. not_found for an unknown version, bad_value for a header with a number that is not finite.
  Stored<Session> start(const Actor& actor, const NewSession& session);
  /// After an interruption: this process owns it again. wrong_state unless interrupted.
  Stored<void> resume(SessionId session, const std::string& reason);
  /// wrong_state unless running.
  Stored<void> interrupt(SessionId session, const std::string& reason);
  /// The final volume and the finished event, in one transaction. wrong_state unless running.
  Stored<void> finish(SessionId session, const FinalVolume& volume, const std::string& reason);
  /// wrong_state when running.
  Stored<void> close(SessionId session, const std::string& reason);

  /// Gives every session of this station that still runs on paper, but whose process has certainly ended, its
  /// interrupted event. Their ids.
  Stored<std::vector<SessionId>> mark_interrupted();

  Stored<Session> find(SessionId session);  // not_found; corrupt when the header cannot be read
  Stored<std::vector<SessionEvent>> events(SessionId session);
  Stored<SessionState> state(SessionId session);

 private:
  Stored<void> add_event(SessionId session, EventKind kind, const std::string& reason, const FinalVolume* volume);
  StorageContext& c_;
};

/// "still what it was": from the events of a session, in order.
SessionState state_after(const std::vector<SessionEvent>& events) noexcept;

}  // namespace cusp::storage
