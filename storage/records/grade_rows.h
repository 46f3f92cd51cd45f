/// A session's stored grades: rows of `grades` and `criteria`. Thread: the database's own.
#pragma once

#include <cstdint>
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

/// Oldest first, each with its criteria.
Stored<std::vector<StoredGrade>> grades_of(Database& db, SessionId session);

}  // namespace cusp::storage
