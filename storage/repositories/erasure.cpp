#include "storage/repositories/erasure.h"

#include "storage/records/audit_writer.h"
#include "storage/records/sealing.h"
#include "storage/records/seals.h"
#include "storage/repositories/accounts.h"

namespace cusp::storage {
namespace {

/// Comments of older programs: their text goes, and the log names the row as it stands then.
void erase_old_comments(StorageContext& context, Transaction& transaction, const Actor& actor, UserId user) {
  if (!transaction.ok()) return;
  const auto comments = context.db.all(
      "SELECT id FROM comments WHERE text <> '' AND session IN (SELECT id FROM sessions WHERE student = ?1)",
      [](Row row) { return row.uuid(0); }, user);
  if (!comments) return transaction.refuse(comments.error());
  for (const Uuid& comment : *comments) {
    const auto before = row_seals(context.db, SealedTable::comments, comment);
    transaction.run("UPDATE comments SET text = '' WHERE id = ?1", comment);
    const auto after = row_seals(context.db, SealedTable::comments, comment);
    if (!before || !after || before->size() != 1 || after->size() != 1) continue;
    log_event(context, transaction,
              {.actor = actor.id, .action = "comment_erased", .subject = after->front().subject,
               .detail = hex(before->front().seal) + ' ' + hex(after->front().seal)});
  }
}

void erase_statement_texts(StorageContext& context, Transaction& transaction, const Actor& actor, UserId user) {
  if (!transaction.ok()) return;
  const auto statements = context.db.all(
      "SELECT t.statement FROM statement_texts t JOIN statements s ON s.id = t.statement "
      "JOIN sessions x ON x.id = s.session WHERE x.student = ?1",
      [](Row row) { return row.uuid(0); }, user);
  if (!statements) return transaction.refuse(statements.error());
  for (const Uuid& statement : *statements) {
    transaction.run("DELETE FROM statement_texts WHERE statement = ?1", statement);
    log_event(context, transaction, {.actor = actor.id, .action = "statement_erased", .subject = statement});
  }
}

}  // namespace

void require_not_erased(Transaction& transaction, UserId user) {
  const std::string erased = "SELECT 1 FROM people WHERE id = ?1 AND number = " + std::string(kErasedNumber);
  if (transaction.first(erased, [](Row) { return true; }, user)) transaction.refuse({StorageError::not_found, "people", user.text()});
}

void leave_cohorts(StorageContext& context, Transaction& transaction, const Actor& actor, UserId user) {
  if (!transaction.ok()) return;
  const auto cohorts = context.db.all("SELECT cohort FROM cohort_students WHERE student = ?1",
                                      [](Row row) { return row.uuid(0); }, user);
  if (!cohorts) return transaction.refuse(cohorts.error());
  for (const Uuid& cohort : *cohorts) {
    transaction.run("DELETE FROM cohort_students WHERE cohort = ?1 AND student = ?2", cohort, user);
    log_event(context, transaction,
              {.actor = actor.id, .action = "cohort_left", .subject = user.uuid, .detail = cohort.text()});
  }
}

void erase_texts_about(StorageContext& context, Transaction& transaction, const Actor& actor, UserId student) {
  erase_statement_texts(context, transaction, actor, student);
  erase_old_comments(context, transaction, actor, student);
}

}  // namespace cusp::storage
