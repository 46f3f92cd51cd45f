/// A school of many sessions. A few are drilled through the product's calls; the others are copies of their rows, with a chain,
/// a signed head, seals in the audit log and summaries of their own.
#pragma once

#include <vector>

#include "tests/storage/sample.h"

namespace cusp::test {

/// Two thousand students in cohorts of a hundred, twelve exercises, three years, an assessment that the first cohort sat. Of ten sessions two are not graded and
/// three are of the second device class. A grade has ten criteria. Every session has one recorded second, a thousandth of them
/// twenty.
struct ManySessions {
  static constexpr int kStudents = 2000, kCohorts = 20, kExercises = 12, kTemplates = 10, kSecondsOfTraced = 20;
  Account admin;
  std::vector<Account> students;
  std::vector<CohortId> cohorts;
  std::vector<ScenarioVersion> versions;
  std::vector<SessionId> templates;  // by the product's calls: the first seven of the device class "pointer", the others "falcon"
  std::vector<SessionId> copies;     // of `templates`, the oldest first
  AssignmentId assessment;           // by the product's calls: one attempt of every student of the first cohort; nil below 10,000
  int listed = 0, graded = 0;        // of all
  SessionId first;                   // of templates
};

enum class CopiedRows : std::uint8_t {
  all,
  of_pages,  // without chain, head and seals in the audit log: three times as fast
};
/// An exercise as it is published: its canonical text and the hash of its content.
struct PublishedExercise {
  Scenario scenario;
  std::string json;
  Hash256 content_hash{};
};
/// Writes `sessions` copies, and the sessions through the product's calls. Pre: the store is new, its clock stands at kNow.
/// `exercises`: kExercises of them; none: small ones without a readable text.
ManySessions write_many(Store& store, int sessions, CopiedRows rows = CopiedRows::of_pages, const std::vector<PublishedExercise>& exercises = {});

/// What differs between two sessions.
struct Drilled {
  const Account& student;
  const ScenarioVersion& version;
  const char* device_class = "pointer";
  std::uint32_t input_us = 83'334;  // of each of the second's twelve inputs
  int seconds = 1;
  double score = 81.5;
  std::optional<AssignmentId> assignment{};
};
/// Ten criteria, whose figures have the length of measured ones.
Grade grade_of_ten(double score);
/// Started, drilled, finished and graded through the product's calls.
SessionId drill(Store& store, const Drilled& drilled);
/// As copy `i`.
Drilled as_copy(const ManySessions& m, int i);
/// Whether copy `i` is graded.
constexpr bool is_graded(int i) noexcept { return i % 5 != 4; }

}  // namespace cusp::test
