/// Grades with their criterion rows. A session may be graded again: the newest grade counts, older ones stay.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "storage/records/context.h"
#include "storage/records/grade_rows.h"
#include "storage/modules.h"
#include "storage/base/rights.h"

namespace cusp::storage {

class Grades {
 public:
  explicit Grades(StorageContext& context) : c_{context} {}
  /// Grade, criteria and the event "graded", in one transaction. wrong_state while the session runs.
  /// Without `grader` the program grades; a user as `grader` needs grade_again.
  Stored<StoredGrade> save(SessionId session, const Grade& grade, const Hash256& rubric_hash,
                           const std::optional<Actor>& grader = std::nullopt);
  /// nullopt if the session has no grade.
  Stored<std::optional<StoredGrade>> newest(SessionId session);
  Stored<std::vector<StoredGrade>> all(SessionId session);  // oldest first

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
