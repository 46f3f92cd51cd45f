#include "storage/repositories/assignments.h"

#include <algorithm>

#include "storage/base/text_length.h"
#include "storage/records/sealing.h"
#include "storage/records/current_rights.h"
#include "storage/repositories/key_list.h"

namespace cusp::storage {
namespace {

constexpr std::size_t kMostDeviceClasses = 16;
constexpr const char* kSelectAssignments =
    "SELECT a.id, a.version, a.cohort, a.kind, a.opens_at, a.due_at, a.goes_allowed, a.author, a.created_at, a.device_classes, "
    "a.self_test_days, a.drawn_tooth, EXISTS (SELECT 1 FROM assignment_withdrawals w WHERE w.assignment = a.id) FROM assignments a ";

Assignment assignment_of(Row row) {
  Assignment a;
  a.id = row.id<AssignmentId>(0);
  a.version = row.id<VersionId>(1);
  a.cohort = row.id<CohortId>(2);
  a.kind = row.text(3) == key_of(SessionKind::assessment) ? SessionKind::assessment : SessionKind::practice;
  a.opens_utc_us = row.maybe_integer(4);
  a.due_utc_us = row.maybe_integer(5);
  if (const auto attempts = row.maybe_integer(6)) a.attempts_allowed = static_cast<int>(*attempts);
  a.author = row.id<UserId>(7);
  a.created_utc_us = row.integer(8);
  a.device_classes = split_keys(row.text(9));
  if (const auto days = row.maybe_integer(10)) a.self_test_days = static_cast<int>(*days);
  a.drawn_tooth = row.maybe_integer(11).has_value();
  a.withdrawn = row.flag(12);
  return a;
}

}  // namespace

bool admits(const std::vector<std::string>& device_classes, std::string_view device_class) {
  return device_classes.empty() || std::ranges::find(device_classes, device_class) != device_classes.end();
}

std::string candidate_number(AssignmentId assignment, UserId student) {
  // Without letters and digits that are read as others.
  constexpr std::string_view kSigns = "23456789ABCDEFGHJKMNPQRSTUVWXYZ";
  const Hash256 hash =
      Blake2b{}.add_text("cusp candidate 1").add_uuid(assignment.uuid).add_uuid(student.uuid).finish();
  std::uint64_t left = 0;
  for (std::size_t i = 0; i < sizeof left; ++i) left = left << 8 | hash[i];
  std::string number;
  for (int i = 0; i < 6; ++i) {
    if (i == 3) number += ' ';
    number += kSigns[left % kSigns.size()];
    left /= kSigns.size();
  }
  return number;
}

Stored<Assignment> Assignments::create(const Actor& actor, Assignment a, const std::string& start_code) {
  if (auto allowed = require(actor, Action::assign); !allowed) return std::unexpected(allowed.error());
  if (a.kind != SessionKind::practice && a.kind != SessionKind::assessment)
    return fail(StorageError::bad_value, "kind");
  if (a.opens_utc_us && a.due_utc_us && *a.opens_utc_us >= *a.due_utc_us) return fail(StorageError::bad_value, "due");
  const bool assessment = a.kind == SessionKind::assessment;
  const bool admitted = has_length(start_code, kLeastStartCode, kMostStartCode);
  if (assessment ? !admitted : !start_code.empty()) return fail(StorageError::bad_value, "start_code");
  if (a.device_classes.size() > kMostDeviceClasses || !std::ranges::all_of(a.device_classes, is_device_class))
    return fail(StorageError::bad_value, "device_classes");
  const int days = a.self_test_days.value_or(1);
  if (days < 1 || days > kMostSelfTestDays || (a.self_test_days && !assessment)) return fail(StorageError::bad_value, "self_test_days");
  if (a.drawn_tooth && !assessment) return fail(StorageError::bad_value, "drawn_tooth");
  std::ranges::sort(a.device_classes);
  const auto twice = std::ranges::unique(a.device_classes);
  a.device_classes.erase(twice.begin(), twice.end());
  a.id = AssignmentId::make();
  a.author = actor.id;
  a.created_utc_us = c_.clock();
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::assign);
  if (transaction.first("SELECT 1 FROM version_withdrawals WHERE version = ?1", [](Row) { return true; }, a.version)) {
    transaction.refuse({StorageError::wrong_state, "version_withdrawn"});
  }
  const std::int64_t sequence = c_.next_sequence(transaction);
  transaction.run(
      "INSERT INTO assignments (id, version, cohort, kind, opens_at, due_at, goes_allowed, author, created_at, "
      "sequence, device_classes, self_test_days, drawn_tooth) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, nullif(?11, ''), ?12, nullif(?13, 0))",
      a.id, a.version, a.cohort, key_of(a.kind), a.opens_utc_us, a.due_utc_us, a.attempts_allowed, a.author,
      a.created_utc_us, sequence, joined_keys(a.device_classes), a.self_test_days, a.drawn_tooth ? 1 : 0);
  log_row(c_, transaction, actor.id, "assigned", SealedTable::assignments, a.id.uuid);
  if (assessment) {
    transaction.run("INSERT INTO assessments (assignment, start_code) VALUES (?1, ?2)", a.id, start_code);
    log_row(c_, transaction, actor.id, "assessment_set", SealedTable::assessments, a.id.uuid);
  }
  if (auto done = commit_sealed(c_, transaction); !done) return std::unexpected(done.error());
  return a;
}

Stored<Assignment> Assignments::find(AssignmentId assignment) {
  const auto found = c_.db.first(std::string(kSelectAssignments) + "WHERE a.id = ?1", assignment_of, assignment);
  if (!found) return std::unexpected(found.error());
  if (!*found) return fail(StorageError::not_found, "assignments", assignment.text());
  return **found;
}

Stored<std::string> Assignments::start_code(const Actor& actor, AssignmentId assignment) {
  if (auto allowed = require(actor, Action::assign); !allowed) return std::unexpected(allowed.error());
  const auto code = c_.db.first("SELECT start_code FROM assessments WHERE assignment = ?1",
                                [](Row row) { return row.text(0); }, assignment);
  if (!code) return std::unexpected(code.error());
  return code->value_or(std::string());
}

Stored<void> Assignments::withdraw(const Actor& actor, AssignmentId assignment) {
  if (auto allowed = require(actor, Action::assign); !allowed) return allowed;
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::assign);
  transaction.run("INSERT INTO assignment_withdrawals (assignment, author, at, sequence) VALUES (?1, ?2, ?3, ?4)", assignment, actor.id,
                  c_.clock(), c_.next_sequence(transaction));
  log_row(c_, transaction, actor.id, "assignment_withdrawn", SealedTable::assignment_withdrawals, assignment.uuid);
  return commit_sealed(c_, transaction);
}

Stored<void> Assignments::adjust(const Actor& actor, AssignmentId assignment, UserId student, const Adjustment& adjustment) {
  const int percent = adjustment.extra_time_percent;
  if (auto allowed = require(actor, Action::assign); !allowed) return allowed;
  if (percent < 0 || percent > kMostExtraTimePercent) return fail(StorageError::bad_value, "extra_time");
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::assign);
  const auto member = transaction.first(
      "SELECT 1 FROM assignments a JOIN cohort_students m ON m.cohort = a.cohort WHERE a.id = ?1 AND m.student = ?2",
      [](Row) { return true; }, assignment, student);
  if (!member) transaction.refuse({StorageError::not_allowed, "assignment", assignment.text()});
  const Uuid id = Uuid::v7();
  const std::int64_t sequence = c_.next_sequence(transaction);
  transaction.run(
      "INSERT INTO adjustments (id, assignment, student, extra_time_percent, author, at, sequence, large_text) "
      "VALUES (?1, ?2, ?3, ?4, ?5, max(?6, coalesce((SELECT max(at) FROM adjustments INDEXED BY adjustments_of_assignment "
      "WHERE assignment = ?2 AND student = ?3), ?6)), ?7, ?8)",
      id, assignment, student, percent, actor.id, c_.clock(), sequence, adjustment.large_text ? 1 : 0);
  log_row(c_, transaction, actor.id, "adjusted", SealedTable::adjustments, id);
  return commit_sealed(c_, transaction);
}

Stored<Adjustment> Assignments::adjustment(AssignmentId assignment, UserId student) {
  const auto found = c_.db.first(
      "SELECT extra_time_percent, coalesce(large_text, 0) FROM adjustments INDEXED BY adjustments_of_assignment WHERE assignment = ?1 AND student = ?2 "
      "ORDER BY at DESC, sequence DESC, id DESC LIMIT 1",
      [](Row row) { return Adjustment{static_cast<int>(row.integer(0)), row.flag(1)}; }, assignment, student);
  if (!found) return std::unexpected(found.error());
  return found->value_or(Adjustment{});
}

Stored<int> Assignments::attempts(AssignmentId assignment, UserId student) {
  const auto count = c_.db.first(
      "SELECT count(*) FROM session_summaries INDEXED BY summaries_of_assignment WHERE assignment = ?1 AND student = ?2",
      [](Row row) { return static_cast<int>(row.integer(0)); }, assignment, student);
  if (!count) return std::unexpected(count.error());
  return count->value_or(0);
}

Stored<std::vector<Assignment>> Assignments::for_student(UserId student) {
  return c_.db.all(std::string(kSelectAssignments) +
                       "JOIN cohort_students c ON c.cohort = a.cohort WHERE c.student = ?1 AND NOT EXISTS (SELECT 1 FROM referred r "
                       "WHERE r.id = a.id AND r.here = 0) ORDER BY a.due_at IS NULL, a.due_at, a.sequence",
                   assignment_of, student);
}

Stored<std::vector<Assignment>> Assignments::for_cohort(CohortId cohort) {
  return c_.db.all(std::string(kSelectAssignments) + "WHERE a.cohort = ?1 ORDER BY a.due_at IS NULL, a.due_at, a.sequence", assignment_of,
                   cohort);
}

}  // namespace cusp::storage
