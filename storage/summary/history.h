/// Lists of sessions with their results, page by page; figures over them; one session's details. All but the details come
/// from the summaries (storage/records/session_summary.h) by an index. Lists omit guests and try-outs. A student reads
/// only own sessions; instructors and administrators read all.
#pragma once

#include <cstdint>
#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "storage/records/context.h"
#include "storage/records/effective_grade.h"
#include "storage/records/self_assessment.h"
#include "storage/repositories/comments.h"
#include "storage/repositories/grades.h"
#include "storage/repositories/metrics.h"
#include "storage/repositories/sessions.h"
#include "storage/base/rights.h"
#include "storage/summary/figures.h"

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
  std::int64_t sequence = 0;     // the station's: orders sessions of one moment
  std::uint64_t elapsed_us = 0;  // of the stored trace
  SessionState state = SessionState::running;
  int engine_version = kEngineVersion;  // that recorded it; another version cannot replay the inputs
  int attempt = 1;                      // the student's attempts at this scenario, counted from 1
  std::optional<double> score, score_max, pass_mark;  // as they count (storage/records/effective_grade.h)
  std::optional<bool> passed{};                       // none = not graded
  std::vector<std::string> critical{};
  std::optional<AssignmentId> assignment{};
  /// False: an assessment whose result is withheld. Who may see own results alone then reads no score.
  bool released = true;
};

/// Role of the account that drilled, as it is now.
enum class DrilledBy : std::uint8_t { students, staff };

struct HistoryFilter {
  std::optional<UserId> student{};
  std::optional<ScenarioId> scenario{};
  std::optional<int> version_number{};  // of the scenario
  std::optional<CohortId> cohort{};
  std::optional<DrilledBy> drilled_by{};
  std::optional<SessionKind> kind{};  // practice or assessment
  std::optional<std::string> device_class{};
  std::optional<std::int64_t> from_utc_us{}, to_utc_us{};  // started at or after, before
  std::optional<bool> passed{};                            // graded only
  std::string search{};                                    // part of the student's name or number
  std::optional<bool> scripted{};                          // true: scripted operators only; false: users only
  bool released_alone = false;                             // without withheld results
  int limit = -1;                                          // of list(); -1 = all
};

/// A row's place in a list. Of two keys the smaller one is the older session.
struct HistoryKey {
  std::int64_t started_utc_us = 0, sequence = 0;
  SessionId session{};
  friend auto operator<=>(const HistoryKey&, const HistoryKey&) = default;
};

struct HistoryPage {
  std::vector<HistoryRow> rows{};     // newest first
  std::optional<HistoryKey> after{};  // where the next page begins; none: this is the last one
};

/// A scenario with listed sessions; the title of its newest version.
struct PractisedScenario {
  ScenarioId scenario;
  LocalText title;
};

struct SessionDetails {
  HistoryRow row;
  Session session;
  std::vector<SessionEvent> events{};
  std::optional<EffectiveGrade> grade{};  // none without a grade, or while it is withheld from the actor
  std::vector<RemovedTissue> removed{};   // none while the result is withheld from the actor
  std::vector<Comment> comments{};        // likewise
};

/// A student's standing in one scenario, by what the student drilled: scripted operators do not count.
struct ExerciseStanding {
  ScenarioId scenario;
  int attempts = 0;
  std::optional<HistoryRow> best, last;  // graded attempts; best by score, the earlier of two equal ones
  bool passed = false;  // in any of them: the best may have failed by a critical event
};

/// A graded attempt that its student has rated.
struct RatedAttempt {
  SessionId session{};
  std::int64_t started_utc_us = 0;
  int attempt = 1;
  RatedPoints points;  // none of the criteria is rated: 0 of them
};

/// What the newest attempts that fit a filter say of one criterion.
struct CriterionFigures {
  std::string id;
  int attempts = 0;       // in which it could bring points: measured, or of a target that was left out
  int full = 0;           // of them with all its points
  double mean_share = 0;  // of its points, 0 to 1
};
inline constexpr int kMostByCriterion = 500;  // sessions that by_criterion() reads at most

struct NewestComment {
  Comment comment;
  std::int64_t started_utc_us = 0;  // of its session
};

class History {
 public:
  explicit History(StorageContext& context) : c_{context} {}

  /// At most `limit` sessions that started before `after`; from the newest one without it. Without see_all_results lists,
  /// figures and scenarios are of the actor's own sessions; not_allowed for another student.
  Stored<HistoryPage> page(const Actor& actor, const HistoryFilter& filter, const std::optional<HistoryKey>& after,
                           int limit);
  /// All pages, or filter.limit rows of them. Newest first.
  Stored<std::vector<HistoryRow>> list(const Actor& actor, const HistoryFilter& filter = {});
  /// How many list() would give.
  Stored<std::size_t> count(const Actor& actor, const HistoryFilter& filter);
  /// Of the graded sessions that fit.
  Stored<Figures> figures(const Actor& actor, const HistoryFilter& filter = {});
  /// Of the graded ones among the newest kMostByCriterion sessions that fit, with the points that count; the hardest criterion first.
  Stored<std::vector<CriterionFigures>> by_criterion(const Actor& actor, const HistoryFilter& filter);
  Stored<std::vector<PractisedScenario>> scenarios(const Actor& actor, const std::optional<UserId>& student = {});
  /// Of all listed sessions. Needs see_all_results.
  Stored<std::vector<std::string>> device_classes(const Actor& actor);
  Stored<SessionDetails> details(const Actor& actor, SessionId session);
  /// Of the same student, scenario and device class, started before this session.
  Stored<std::optional<HistoryRow>> best_before(const Actor& actor, SessionId session);
  Stored<int> attempts(const Actor& actor, UserId student, ScenarioId scenario);
  /// not_allowed (where = withheld) while the session's result is withheld from the actor; else as require_reading(). A session
  /// without a summary counts as released.
  Stored<void> may_read_result(const Actor& actor, SessionId session);
  /// The attempts of an assignment as of one moment, by student, oldest first; without see_all_results the actor's own.
  Stored<std::vector<HistoryRow>> of_assignment(const Actor& actor, AssignmentId assignment);
  /// Interrupted sessions of this student on this station, newest first, without a grade and recorded by this engine version. Each can be
  /// graded as it stands, and resumed on a device of the row's class unless it keeps a volume.
  Stored<std::vector<HistoryRow>> interrupted(const Actor& actor, UserId student);
  /// Whether the attempt has ended here, by this engine version, and has no grade: its program ended between the two. False for whoever may
  /// not grade it: its student may, and who has grade_again.
  Stored<bool> lacks_grade(const Actor& actor, SessionId session);
  Stored<std::vector<ExerciseStanding>> standings(const Actor& actor, UserId student);
  /// The student's graded attempts at a scenario with one device class that have an own assessment which was not skipped, each once, by
  /// its first own assessment; oldest first.
  Stored<std::vector<RatedAttempt>> rated_attempts(const Actor& actor, UserId student, ScenarioId scenario, const std::string& device_class);
  /// Of the newest listed session that has one.
  Stored<std::optional<NewestComment>> newest_comment(const Actor& actor, UserId student);

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
