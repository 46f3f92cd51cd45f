/// A school of many sessions, written as rows without the calls that would make them: seconds for fifty thousand.
#pragma once

#include <vector>

#include "tests/storage/sample.h"

namespace cusp::test {

/// Two thousand students in cohorts of a hundred, twelve exercises, three years. Of ten sessions two are not graded and
/// three are of the second device class. Sessions have header, events, head, and a grade with two criteria; no trace.
struct ManySessions {
  static constexpr int kStudents = 2000, kCohorts = 20, kExercises = 12;
  Account admin;
  std::vector<Account> students;
  std::vector<CohortId> cohorts;
  std::vector<ScenarioVersion> versions;
  SessionId first;
};

/// Writes `sessions` of them and their summaries. Pre: the store is empty.
ManySessions write_many(Store& store, int sessions);

}  // namespace cusp::test
