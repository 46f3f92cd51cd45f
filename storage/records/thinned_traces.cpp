#include "storage/records/thinned_traces.h"

#include <string>

namespace cusp::storage {
namespace {

/// Every column that the signature covers.
constexpr std::string_view kSignedOfThinned = "session, station, author, at, links, link, key";
constexpr int kThinnedColumns = 7;

Hash256 thinned_message(const Hash256& content) {
  return Blake2b{}.add_text("cusp thinned trace 1").add_hash(content).finish();
}

struct SignedRow {
  Hash256 content, key;
  Signature signature;
  bool right_station = false, right_head = false;
};

/// The head is a link of the chain, and no row of the recording follows it.
constexpr std::string_view kHeadHolds =
    "EXISTS (SELECT 1 FROM session_chain c WHERE c.session = t.session AND c.position = t.links - 1 AND c.link = t.link) "
    "AND NOT EXISTS (SELECT 1 FROM session_chain c WHERE c.session = t.session AND c.position >= t.links "
    "AND c.table_number IN (3, 4))";

Stored<std::optional<SignedRow>> signed_row(Database& db, SessionId session) {
  return db.first("SELECT " + std::string(kSignedOfThinned) +
                      ", signature, station IS (SELECT s.station FROM sessions s WHERE s.id = t.session), " +
                      std::string(kHeadHolds) + " FROM thinned_traces t WHERE session = ?1",
                  [](Row row) {
                    return SignedRow{row.content_hash(0, kThinnedColumns), row.hash(6), signature_of(row.bytes(7)),
                                     row.flag(8), row.flag(9)};
                  },
                  session);
}

}  // namespace

Stored<std::optional<std::int64_t>> thinned_at(Database& db, SessionId session) {
  return db.first("SELECT at FROM thinned_traces WHERE session = ?1", [](Row row) { return row.integer(0); }, session);
}

StorageFailure thinned_failure(std::int64_t at_utc_us) {
  return {StorageError::wrong_state, "thinned", std::to_string(at_utc_us)};
}

void insert_thinned_trace(StorageContext& context, Transaction& transaction, UserId author, SessionId session) {
  if (!transaction.ok()) return;
  if (!context.key) return transaction.refuse({StorageError::read_only, context.db.file().string()});
  transaction.run(
      "INSERT INTO thinned_traces (session, station, author, at, links, link, key, signature) "
      "SELECT ?1, ?2, ?3, ?4, links, link, ?5, zeroblob(64) FROM session_heads WHERE session = ?1",
      session, context.station, author, context.clock(), context.key->id());
  const auto content =
      transaction.first("SELECT " + std::string(kSignedOfThinned) + " FROM thinned_traces WHERE session = ?1",
                        [](Row row) { return row.content_hash(); }, session);
  if (!content) return transaction.refuse({StorageError::not_found, "sessions", session.text()});
  const Signature signature = context.key->sign(thinned_message(*content));
  transaction.run("UPDATE thinned_traces SET signature = ?2 WHERE session = ?1", session,
                  std::as_bytes(std::span(signature)));
}

Stored<std::optional<FindingCode>> check_thinned_trace(Database& db, SessionId session) {
  std::optional<FindingCode> out;
  const auto row = signed_row(db, session);
  if (!row) return std::unexpected(row.error());
  if (!*row) return out;
  const auto key = db.first("SELECT public_key FROM station_keys WHERE id = ?1", [](Row r) { return r.hash(0); },
                            (*row)->key);
  if (!key) return std::unexpected(key.error());
  const bool known = key->has_value() && key_id(**key) == (*row)->key;
  if (!known) {
    out = FindingCode::key_changed;
  } else if (!signature_holds(**key, thinned_message((*row)->content), (*row)->signature) || !(*row)->right_station ||
             !(*row)->right_head) {
    out = FindingCode::row_changed;
  }
  return out;
}

}  // namespace cusp::storage
