#include "storage/records/audit_writer.h"

#include <optional>

namespace cusp::storage {
namespace {

bool holds(StorageContext& context, Transaction& transaction, const SignedHead& head) {
  std::optional<Hash256> key = context.key->public_key;
  if (context.key->id() != head.key) {
    key = transaction.first(
        kSelectOwnKey, [](Row row) { return row.hash(0); }, head.key);
  }
  return key && key_id(*key) == head.key && head_signature_holds(*key, context.station, head.head, head.signature);
}

}  // namespace

AuditWriter::AuditWriter(StorageContext& context, Transaction& transaction)
    : context_{context}, transaction_{transaction}, head_{0, chain_start(context.station)} {
  if (!context.key) transaction.refuse({StorageError::read_only, context.db.file().string()});
  const auto head =
      transaction.first("SELECT entries, link, key, signature FROM audit_head WHERE one = 1", [](Row row) {
        return SignedHead{{row.u64(0), row.hash(1)}, row.hash(2), signature_of(row.bytes(3))};
      });
  const auto last =
      transaction.first("SELECT number + 1, link FROM audit_log WHERE number = (SELECT max(number) FROM audit_log)", [](Row row) {
        return ChainHead{row.u64(0), row.hash(1)};
      });
  if (!transaction.ok() || (!head && !last)) return;
  // A head that holds counts deleted entries too: their numbers stay unused, and the gap shows.
  const bool good = head && (!last || last->links <= head->head.links) && holds(context, transaction, *head);
  if (good) {
    head_ = head->head;
    return;
  }
  if (last) head_ = *last;
  context.incident = "log_damaged";
  add({.action = "log_damaged", .subject = context.station});
}

void AuditWriter::add(const AuditEvent& event) {
  if (!transaction_.ok()) return;
  const std::int64_t sequence = context_.next_sequence(transaction_);
  transaction_.run(
      "INSERT INTO audit_log (number, at, sequence, actor, action, subject, detail, link) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, zeroblob(32))",
      head_.links, context_.clock(), sequence, event.actor, event.action, event.subject, event.detail);
  const auto content = transaction_.first(
      "SELECT number, at, sequence, actor, action, subject, detail FROM audit_log WHERE number = ?1",
      [](Row row) { return row.content_hash(); }, head_.links);
  if (!content) return;
  head_.link = chain_link(head_.link, context_.station, {head_.links, 0, head_.links, -1, *content});
  transaction_.run("UPDATE audit_log SET link = ?2 WHERE number = ?1", head_.links, head_.link);
  ++head_.links;
}

void AuditWriter::finish() {
  if (!transaction_.ok()) return;
  transaction_.run(
      "INSERT INTO audit_head (one, entries, link, key, signature) VALUES (1, ?1, ?2, ?3, ?4) "
      "ON CONFLICT (one) DO UPDATE SET entries = excluded.entries, link = excluded.link, key = excluded.key, "
      "signature = excluded.signature",
      head_.links, head_.link, context_.key->id(), context_.key->sign_head(context_.station, head_));
}

void log_event(StorageContext& context, Transaction& transaction, const AuditEvent& event) {
  AuditWriter log(context, transaction);
  log.add(event);
  log.finish();
}

}  // namespace cusp::storage
