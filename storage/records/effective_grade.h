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
  std::optional<SignedStatement> confirmation{};  // made after each change of the result, of the result that counts
  std::optional<SignedStatement> release{};       // that nobody has withdrawn
  /// A failed result that nobody has confirmed.
  bool needs_confirmation() const noexcept { return !grade.passed && !confirmation; }
  /// A release is out of force while the result needs a confirmation, also if an override lowered it after the release.
  bool release_waits() const noexcept { return release && needs_confirmation(); }
};

/// nullopt without a grade. Overrides of older grades do not count. `statements`: all of the session, oldest first.
std::optional<EffectiveGrade> effective_grade(const std::vector<StoredGrade>& grades,
                                              const std::vector<SignedStatement>& statements);

/// Of what a result shows beside its score: pass, critical events, points of each criterion. A confirmation keeps it, so that a change
/// that its examiner had not read ends it on every station.
Hash256 shown_hash(const Grade& grade);

/// The release that nobody has withdrawn. It may wait: EffectiveGrade::release_waits().
std::optional<SignedStatement> release_of(const std::vector<SignedStatement>& statements);

}  // namespace cusp::storage
