#include "storage/repositories/assignments.h"

#include "storage/records/sealing.h"

namespace cusp::storage {
namespace {

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
  return a;
}

}  // namespace

Stored<Assignment> Assignments::create(const Actor& actor, Assignment a) {
  if (auto allowed = require(actor, Action::assign); !allowed) return std::unexpected(allowed.error());
  if (a.kind != SessionKind::practice && a.kind != SessionKind::assessment)
    return fail(StorageError::bad_value, "kind");
  if (a.opens_utc_us && a.due_utc_us && *a.opens_utc_us >= *a.due_utc_us) return fail(StorageError::bad_value, "due");
  a.id = AssignmentId::make();
  a.author = actor.id;
  a.created_utc_us = c_.clock();
  Transaction transaction(c_.db);
  const std::int64_t sequence = c_.next_sequence(transaction);
  transaction.run(
      "INSERT INTO assignments (id, version, cohort, kind, opens_at, due_at, goes_allowed, author, created_at, "
      "sequence) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10)",
      a.id, a.version, a.cohort, key_of(a.kind), a.opens_utc_us, a.due_utc_us, a.attempts_allowed, a.author,
      a.created_utc_us, sequence);
  log_row(c_, transaction, actor.id, "assigned", SealedTable::assignments, a.id.uuid);
  if (auto done = commit_sealed(c_, transaction); !done) return std::unexpected(done.error());
  return a;
}

Stored<std::vector<Assignment>> Assignments::for_student(UserId student) {
  return c_.db.all(
      "SELECT a.id, a.version, a.cohort, a.kind, a.opens_at, a.due_at, a.goes_allowed, a.author, a.created_at "
      "FROM assignments a JOIN cohort_students c ON c.cohort = a.cohort WHERE c.student = ?1 "
      "ORDER BY a.due_at IS NULL, a.due_at, a.sequence",
      assignment_of, student);
}

Stored<std::vector<Assignment>> Assignments::for_cohort(CohortId cohort) {
  return c_.db.all(
      "SELECT id, version, cohort, kind, opens_at, due_at, goes_allowed, author, created_at FROM assignments "
      "WHERE cohort = ?1 ORDER BY due_at IS NULL, due_at, sequence",
      assignment_of, cohort);
}

}  // namespace cusp::storage
