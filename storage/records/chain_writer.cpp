#include "storage/records/chain_writer.h"

namespace cusp::storage {

ChainWriter::ChainWriter(StorageContext& context, Transaction& transaction, SessionId session)
    : context_{context}, transaction_{transaction}, session_{session}, head_{0, chain_start(session.uuid)} {
  if (!context.key) transaction.refuse({StorageError::read_only, context.db.file().string()});
  const auto elsewhere = transaction.first("SELECT station <> ?2 FROM sessions WHERE id = ?1",
                                           [](Row row) { return row.flag(0); }, session, context.station);
  if (elsewhere.value_or(false)) transaction.refuse({StorageError::wrong_state, "other_station", session.text()});
  const auto head = transaction.first(
      "SELECT links, link FROM session_heads WHERE session = ?1",
      [](Row row) { return ChainHead{row.u64(0), row.hash(1)}; }, session);
  if (head) head_ = *head;
}

void ChainWriter::add(SessionTable table, std::uint64_t row, std::int64_t second) {
  const auto content = transaction_.first(select_row(table), [](Row r) { return r.content_hash(); }, session_, row);
  if (!content) return transaction_.refuse({StorageError::not_found, std::string(name_of(table))});
  const ChainLink entry{head_.links, static_cast<std::uint64_t>(table), row, second, *content};
  head_.link = chain_link(head_.link, session_.uuid, entry);
  transaction_.run(
      "INSERT INTO session_chain (session, position, table_number, row, second, content, link) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)",
      session_, entry.position, entry.table, row, second, entry.content, head_.link);
  ++head_.links;
}

void ChainWriter::finish() {
  if (!transaction_.ok()) return;
  transaction_.run(
      "INSERT INTO session_heads (session, links, link, key, signature) VALUES (?1, ?2, ?3, ?4, ?5) "
      "ON CONFLICT (session) DO UPDATE SET links = excluded.links, link = excluded.link, key = excluded.key, "
      "signature = excluded.signature",
      session_, head_.links, head_.link, context_.key->id(), context_.key->sign_head(session_.uuid, head_));
}

std::uint64_t next_row(Transaction& transaction, SessionTable table, SessionId session) {
  return transaction
      .first(
          "SELECT coalesce(max(row) + 1, 0) FROM " + std::string(name_of(table)) + " WHERE session = ?1",
          [](Row row) { return row.u64(0); }, session)
      .value_or(0);
}

}  // namespace cusp::storage
