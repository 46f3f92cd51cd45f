#include "storage/repositories/cohorts.h"

#include "storage/base/text_length.h"
#include "storage/records/audit_writer.h"
#include "storage/records/sealing.h"
#include "storage/records/current_rights.h"
#include "storage/repositories/erasure.h"

namespace cusp::storage {
namespace {

Cohort cohort_of(Row row) { return {row.id<CohortId>(0), row.text(1), static_cast<int>(row.integer(2))}; }

}  // namespace

Stored<Cohort> Cohorts::create(const Actor& actor, const std::string& name) {
  if (auto allowed = require(actor, Action::manage_cohorts); !allowed) return std::unexpected(allowed.error());
  if (!has_length(name, 1, kMostCohortName)) return fail(StorageError::bad_value, "name");
  const CohortId id = CohortId::make();
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::manage_cohorts);
  transaction.run("INSERT INTO cohorts (id, name, created_at) VALUES (?1, ?2, ?3)", id, name, c_.clock());
  log_row(c_, transaction, actor.id, "cohort_created", SealedTable::cohorts, id.uuid);
  if (auto done = commit_sealed(c_, transaction); !done) {
    if (done.error().code == StorageError::duplicate) done.error().where = name;
    return std::unexpected(done.error());
  }
  return Cohort{id, name, 0};
}

Stored<void> Cohorts::add(const Actor& actor, CohortId cohort, UserId student) { return add_all(actor, cohort, {&student, 1}); }

Stored<void> Cohorts::add_all(const Actor& actor, CohortId cohort, std::span<const UserId> students) {
  if (auto allowed = require(actor, Action::manage_cohorts); !allowed) return allowed;
  if (students.empty()) return {};
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::manage_cohorts);
  AuditWriter log(c_, transaction);
  for (const UserId& student : students) {
    require_not_erased(transaction, student);
    transaction.run("INSERT INTO cohort_students (cohort, student) VALUES (?1, ?2) ON CONFLICT DO NOTHING", cohort, student);
    // Who was in the cohort has not joined it now.
    if (!transaction.ok() || c_.db.changes() == 0) continue;
    log.add({.actor = actor.id, .action = "cohort_joined", .subject = student.uuid, .detail = cohort.text()});
  }
  log.finish();
  return commit_sealed(c_, transaction);
}

Stored<void> Cohorts::remove(const Actor& actor, CohortId cohort, UserId student) {
  if (auto allowed = require(actor, Action::manage_cohorts); !allowed) return allowed;
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::manage_cohorts);
  transaction.run("DELETE FROM cohort_students WHERE cohort = ?1 AND student = ?2", cohort, student);
  if (transaction.ok() && c_.db.changes() == 0) transaction.refuse({StorageError::not_found, "cohort_students"});
  log_event(c_, transaction,
            {.actor = actor.id, .action = "cohort_left", .subject = student.uuid, .detail = cohort.text()});
  return commit_sealed(c_, transaction);
}

Stored<std::vector<Cohort>> Cohorts::list() {
  return c_.db.all(
      "SELECT id, name, (SELECT count(*) FROM cohort_students WHERE cohort = cohorts.id) FROM cohorts ORDER BY name",
      cohort_of);
}

Stored<Cohort> Cohorts::find_name(const std::string& name) {
  auto found = c_.db.first(
      "SELECT id, name, (SELECT count(*) FROM cohort_students WHERE cohort = cohorts.id) FROM cohorts WHERE name = ?1",
      cohort_of, name);
  if (!found) return std::unexpected(found.error());
  if (!*found) return fail(StorageError::not_found, name);
  return std::move(**found);
}

Stored<std::vector<UserId>> Cohorts::students(CohortId cohort) {
  return c_.db.all(
      "SELECT student FROM cohort_students WHERE cohort = ?1", [](Row row) { return row.id<UserId>(0); }, cohort);
}

}  // namespace cusp::storage
