/// Assignments: a scenario version for a cohort, with dates; an assessment also has a start code.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/records/context.h"
#include "storage/repositories/sessions.h"
#include "storage/base/rights.h"

namespace cusp::storage {

struct Assignment {
  AssignmentId id{};
  VersionId version{};
  CohortId cohort{};
  SessionKind kind = SessionKind::practice;  // or assessment
  std::optional<std::int64_t> opens_utc_us{}, due_utc_us{};
  std::optional<int> attempts_allowed{};  // none = unlimited
  std::vector<std::string> device_classes{};  // DeviceLimits::device_class of the devices admitted; none = every device
  std::optional<int> self_test_days{};  // of an assessment: the device passed its newest self-test at most so many days before; none = not asked
  bool drawn_tooth = false;  // of an assessment: each candidate has a tooth of his own; the session keeps its exercise
  UserId author{};
  std::int64_t created_utc_us = 0;
  bool withdrawn = false;  // admits no further attempt
};

inline constexpr int kMostSelfTestDays = 365;
inline constexpr int kMostExtraTimePercent = 400;
/// What a student has in an assignment that the others have not.
struct Adjustment {
  int extra_time_percent = 0;  // of the exercise's time limit
  bool large_text = false;
  friend bool operator==(const Adjustment&, const Adjustment&) = default;
};
inline constexpr std::size_t kLeastStartCode = 4, kMostStartCode = 32;  // characters

bool admits(const std::vector<std::string>& device_classes, std::string_view device_class);

/// Stands for the student's name in an assessment: six letters and digits, "K7F 3QD", always the same.
std::string candidate_number(AssignmentId assignment, UserId student);

class Assignments {
 public:
  explicit Assignments(StorageContext& context) : c_{context} {}
  /// Needs assign. Sets id, author and time, and puts the device classes in order. `start_code`: what the invigilator says when an assessment begins; of an
  /// assessment alone. bad_value (where = start_code, kind, due, device_classes: a class is a-z, 0-9 and -; self_test_days: 1 to kMostSelfTestDays; drawn_tooth).
  /// wrong_state (where = version_withdrawn): no student would find it; assignments from before its withdrawal stay.
  Stored<Assignment> create(const Actor& actor, Assignment assignment, const std::string& start_code = {});
  Stored<Assignment> find(AssignmentId assignment);  // not_found
  /// Needs assign. Empty for a practice.
  Stored<std::string> start_code(const Actor& actor, AssignmentId assignment);
  /// No further attempt begins; those that were begun, with their results, stay and can be continued. Needs assign. duplicate if it
  /// is withdrawn.
  Stored<void> withdraw(const Actor& actor, AssignmentId assignment);
  /// Takes the place of the student's adjustment, for attempts that begin afterwards. Needs assign. not_allowed
  /// (where = assignment) for one who is not in its cohort, bad_value (where = extra_time) outside 0 to kMostExtraTimePercent. Numbers of
  /// two stations tell nothing of their order: the latest time counts, and a new one is not before those that are known here.
  Stored<void> adjust(const Actor& actor, AssignmentId assignment, UserId student, const Adjustment& adjustment);
  Stored<Adjustment> adjustment(AssignmentId assignment, UserId student);
  /// Attempts that the student has begun.
  Stored<int> attempts(AssignmentId assignment, UserId student);
  Stored<std::vector<Assignment>> for_student(UserId student);  // by due date, those without one last
  Stored<std::vector<Assignment>> for_cohort(CohortId cohort);

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
