/// Lists of sessions with their results, one session's details, and the best attempt before it. Lists omit guests and
/// try-outs. A student reads only own sessions; instructors and administrators read all.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "storage/records/context.h"
#include "storage/repositories/comments.h"
#include "storage/repositories/grades.h"
#include "storage/repositories/metrics.h"
#include "storage/repositories/sessions.h"
#include "storage/base/rights.h"

namespace cusp::storage {

struct HistoryRow {
  SessionId session{};
  UserId student{};
  std::string student_number, student_name;
  ScenarioId scenario;
  VersionId version{};
  int version_number = 1;
  std::string scenario_key{};  // built-in id, else empty
  LocalText title;
  SessionKind kind = SessionKind::practice;
  std::string operator_name{};  // kUserOperator, or a scripted operator
  std::string device, device_class;
  std::int64_t started_utc_us = 0;
  std::uint64_t elapsed_us = 0;  // of the stored trace
  SessionState state = SessionState::running;
  int engine_version = kEngineVersion;  // that recorded it; another version cannot replay the inputs
  int attempt = 1;                      // the student's attempts at this scenario, counted from 1
  std::optional<double> score, score_max, pass_mark;
  std::optional<bool> passed{};  // none = not graded
  std::vector<std::string> critical{};
};

struct HistoryFilter {
  std::optional<UserId> student{};
  std::optional<ScenarioId> scenario{};
  std::optional<CohortId> cohort{};
  std::optional<std::string> device_class{};
  std::optional<std::int64_t> from_utc_us{}, to_utc_us{};  // started at or after, before
  std::optional<bool> passed{};                            // graded only
  std::string search{};                                    // part of the student's name or number
  std::optional<bool> scripted{};                          // true: scripted operators only; false: users only
  int limit = -1;                                          // -1 = all
};

struct SessionDetails {
  HistoryRow row;
  Session session;
  std::vector<SessionEvent> events{};
  std::optional<StoredGrade> grade{};  // newest
  std::vector<RemovedTissue> removed{};
  std::vector<Comment> comments{};
};

/// A student's standing in one scenario.
struct ExerciseStanding {
  ScenarioId scenario;
  int attempts = 0;
  std::optional<HistoryRow> best, last;  // graded attempts; best by score, the earlier of two equal ones
};

class History {
 public:
  explicit History(StorageContext& context) : c_{context} {}

  /// Newest first. Without see_all_results the list holds the actor's own sessions only.
  Stored<std::vector<HistoryRow>> list(const Actor& actor, const HistoryFilter& filter = {});
  Stored<SessionDetails> details(const Actor& actor, SessionId session);
  /// Of the same student, scenario and device class, started before this session.
  Stored<std::optional<HistoryRow>> best_before(const Actor& actor, SessionId session);
  Stored<int> attempts(const Actor& actor, UserId student, ScenarioId scenario);
  /// Interrupted sessions of this student, newest first, without a grade and recorded by this engine version. Each can be
  /// resumed on a device of the row's class, or graded as it stands.
  Stored<std::vector<HistoryRow>> interrupted(const Actor& actor, UserId student);
  Stored<std::vector<ExerciseStanding>> standings(const Actor& actor, UserId student);

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
