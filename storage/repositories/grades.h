/// Grades with their criterion rows. A session may be graded again: the newest grade counts, older ones stay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "storage/records/context.h"
#include "storage/records/grade_rows.h"
#include "storage/repositories/sessions.h"
#include "storage/modules.h"
#include "storage/base/rights.h"

namespace cusp::storage {

class Grades {
 public:
  explicit Grades(StorageContext& context) : c_{context} {}
  /// Grade, criteria and the event "graded", in one transaction. wrong_state while the session runs.
  /// Without `grader` the program grades; a user as `grader` needs grade_again. `volume`: what an interrupted attempt came to; kept
  /// with the grade unless the session has one. wrong_state (where = final_volumes) if it is of another tick than the trace's last.
  /// `before`: how many grades the session had when this one was computed. wrong_state (where = graded) if it has more by now: what was
  /// stated about the newest would end.
  Stored<StoredGrade> save(SessionId session, const Grade& grade, const Hash256& rubric_hash,
                           const std::optional<Actor>& grader = std::nullopt, const FinalVolume* volume = nullptr,
                           const std::optional<std::size_t>& before = std::nullopt);
  /// nullopt if the session has no grade.
  Stored<std::optional<StoredGrade>> newest(SessionId session);
  Stored<std::vector<StoredGrade>> all(SessionId session);  // oldest first

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
