#include "storage/repositories/audit_log.h"

#include <utility>

namespace cusp {

void AuditLog::add(StorageContext& context, Transaction& transaction, UserId actor, std::string_view action,
                   Uuid subject, std::string_view detail) {
  if (!context.key) return transaction.refuse({StorageError::read_only, context.db.file().string()});
  const auto head = transaction.first("SELECT entries, link FROM audit_head",
                                      [](Row row) { return std::pair{row.u64(0), row.hash(1)}; });
  const std::uint64_t number = head ? head->first : 0;
  const Hash256 before = head ? head->second : chain_start(context.station);
  const std::int64_t sequence = context.next_sequence(transaction);
  transaction.run(
      "INSERT INTO audit_log (number, at, sequence, actor, action, subject, detail, link) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, zeroblob(32))",
      number, context.clock(), sequence, actor, action, subject, detail);
  const auto content = transaction.first(
      "SELECT number, at, sequence, actor, action, subject, detail FROM audit_log WHERE number = ?1",
      [](Row row) { return row.content_hash(); }, number);
  if (!content) return;
  const Hash256 link = chain_link(before, context.station, {number, 0, number, -1, *content});
  transaction.run("UPDATE audit_log SET link = ?2 WHERE number = ?1", number, link);
  transaction.run(
      "INSERT INTO audit_head (one, entries, link, key, signature) VALUES (1, ?1, ?2, ?3, ?4) "
      "ON CONFLICT (one) DO UPDATE SET entries = excluded.entries, link = excluded.link, key = excluded.key, "
      "signature = excluded.signature",
      number + 1, link, context.key->id(), context.key->sign_head(context.station, number + 1, link));
}

Stored<void> AuditLog::add(UserId actor, std::string_view action, Uuid subject, std::string_view detail) {
  Transaction transaction(c_.db);
  add(c_, transaction, actor, action, subject, detail);
  return transaction.commit();
}

Stored<std::vector<AuditEntry>> AuditLog::list(const Actor& actor, int limit, std::int64_t before_number) {
  if (auto allowed = require(actor, Action::see_audit_log); !allowed) return std::unexpected(allowed.error());
  return c_.db.all(
      "SELECT number, at, sequence, actor, action, subject, detail FROM audit_log WHERE number < ?1 "
      "ORDER BY number DESC LIMIT ?2",
      [](Row row) {
        return AuditEntry{row.integer(0), row.integer(1), row.integer(2), row.id<UserId>(3),
                          row.text(4),    row.uuid(5),    row.text(6)};
      },
      before_number, limit);
}

}  // namespace cusp
