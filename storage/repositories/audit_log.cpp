#include "storage/repositories/audit_log.h"

#include <tuple>
#include <utility>

#include "storage/chain_check.h"
#include "storage/sealing.h"

namespace cusp::storage {

namespace {

struct AuditHead {
  std::uint64_t entries = 0;
  Hash256 link{}, key{};
  Signature signature{};
};

bool holds(StorageContext& context, Transaction& transaction, const AuditHead& head) {
  std::optional<Hash256> key = context.key->public_key;
  if (context.key->id() != head.key) {
    key = transaction.first(
        "SELECT public_key FROM station_keys WHERE id = ?1", [](Row row) { return row.hash(0); }, head.key);
  }
  return key && key_id(*key) == head.key &&
         head_signature_holds(*key, context.station, head.entries, head.link, head.signature);
}

}  // namespace

AuditWriter::AuditWriter(StorageContext& context, Transaction& transaction)
    : context_{context}, transaction_{transaction}, link_{chain_start(context.station)} {
  if (!context.key) transaction.refuse({StorageError::read_only, context.db.file().string()});
  const auto head =
      transaction.first("SELECT entries, link, key, signature FROM audit_head WHERE one = 1", [](Row row) {
        return AuditHead{row.u64(0), row.hash(1), row.hash(2), signature_of(row.bytes(3))};
      });
  const auto last =
      transaction.first("SELECT number + 1, link FROM audit_log ORDER BY number DESC LIMIT 1", [](Row row) {
        return std::pair{row.u64(0), row.hash(1)};
      });
  if (!transaction.ok() || (!head && !last)) return;
  // Entries that are missing before a head that holds stay a gap in the numbers.
  const bool good = head && (!last || last->first <= head->entries) && holds(context, transaction, *head);
  if (good) {
    entries_ = head->entries;
    link_ = head->link;
    return;
  }
  if (last) std::tie(entries_, link_) = *last;
  context.incident = "log_damaged";
  add(UserId{}, *context.incident, context.station);
}

void AuditWriter::add(UserId actor, std::string_view action, Uuid subject, std::string_view detail) {
  if (!transaction_.ok()) return;
  const std::int64_t sequence = context_.next_sequence(transaction_);
  transaction_.run(
      "INSERT INTO audit_log (number, at, sequence, actor, action, subject, detail, link) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, zeroblob(32))",
      entries_, context_.clock(), sequence, actor, action, subject, detail);
  const auto content = transaction_.first(
      "SELECT number, at, sequence, actor, action, subject, detail FROM audit_log WHERE number = ?1",
      [](Row row) { return row.content_hash(); }, entries_);
  if (!content) return;
  link_ = chain_link(link_, context_.station, {entries_, 0, entries_, -1, *content});
  transaction_.run("UPDATE audit_log SET link = ?2 WHERE number = ?1", entries_, link_);
  ++entries_;
}

void AuditWriter::finish() {
  if (!transaction_.ok()) return;
  transaction_.run(
      "INSERT INTO audit_head (one, entries, link, key, signature) VALUES (1, ?1, ?2, ?3, ?4) "
      "ON CONFLICT (one) DO UPDATE SET entries = excluded.entries, link = excluded.link, key = excluded.key, "
      "signature = excluded.signature",
      entries_, link_, context_.key->id(), context_.key->sign_head(context_.station, entries_, link_));
}

void AuditLog::add(StorageContext& context, Transaction& transaction, UserId actor, std::string_view action,
                   Uuid subject, std::string_view detail) {
  AuditWriter log(context, transaction);
  log.add(actor, action, subject, detail);
  log.finish();
}

Stored<void> AuditLog::add(UserId actor, std::string_view action, Uuid subject, std::string_view detail) {
  Transaction transaction(c_.db);
  add(c_, transaction, actor, action, subject, detail);
  return commit_sealed(c_, transaction);
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

}  // namespace cusp::storage
