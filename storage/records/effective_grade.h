/// What counts of a session's result: its newest grade and the statements about it. The one rule that lists, reports,
/// figures and exports share. Pure.
#pragma once

#include <optional>
#include <vector>

#include "storage/records/grade_rows.h"
#include "storage/records/statement_rows.h"

namespace cusp::storage {

struct EffectiveGrade {
  StoredGrade stored;                        // the newest, as it was written
  Grade grade;                               // points, score, critical events and pass as they count
  std::vector<SignedStatement> overrides{};  // in force, of this grade; the newest one of each criterion
  std::optional<SignedStatement> confirmation{};  // made after the last change of the result
  /// A failed result that nobody has confirmed is not released.
  bool needs_confirmation() const noexcept { return !grade.passed && !confirmation; }
};

/// nullopt without a grade. Overrides of older grades do not count. `statements`: all of the session, oldest first.
std::optional<EffectiveGrade> effective_grade(const std::vector<StoredGrade>& grades,
                                              const std::vector<SignedStatement>& statements);

/// A release in force.
std::optional<SignedStatement> release_of(const std::vector<SignedStatement>& statements);

}  // namespace cusp::storage
