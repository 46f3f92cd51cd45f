/// A session's stored grades: rows of `grades`, and their criteria. Those of a grade are one row of `graded_criteria`, compressed JSON;
/// before schema 13 each was a row of `criteria`. Thread: the database's own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scenarios/grading/grade.h"
#include "storage/modules.h"
#include "storage/sqlite/database.h"

namespace cusp::storage {

struct StoredGrade {
  Grade grade;
  Hash256 rubric_hash{};   // of the rubric's canonical JSON
  int engine_version = 0;  // that made the volume
  UserId grader;           // nil = the program
  std::int64_t graded_utc_us = 0;
  int number = 0;  // 0 = the first grade of this session
};

/// What `graded_criteria` holds of a grade.
std::vector<std::byte> packed_criteria(const std::vector<CriterionGrade>& criteria);
/// bad_trace if `packed` is none.
Stored<std::vector<CriterionGrade>> criteria_from(std::span<const std::byte> packed);

/// Oldest first, each with its criteria.
Stored<std::vector<StoredGrade>> grades_of(Database& db, SessionId session);

}  // namespace cusp::storage
