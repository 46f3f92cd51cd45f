/// Assignments: a scenario version for a cohort, with dates.
#pragma once

#include <cstdint>
#include <optional>
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
  UserId author{};
  std::int64_t created_utc_us = 0;
};

class Assignments {
 public:
  explicit Assignments(StorageContext& context) : c_{context} {}
  /// Needs assign. Sets id, author and time.
  Stored<Assignment> create(const Actor& actor, Assignment assignment);
  Stored<std::vector<Assignment>> for_student(UserId student);  // by due date, those without one last
  Stored<std::vector<Assignment>> for_cohort(CohortId cohort);

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
