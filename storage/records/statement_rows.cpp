#include "storage/records/statement_rows.h"

#include <sodium.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "storage/base/sodium.h"

namespace cusp::storage {
namespace {

constexpr std::array<std::string_view, 7> kKinds = {"comment", "override_points", "override_critical", "confirmation",
                                                    "release", "withdrawal",      "self_assessment"};

/// Every column that the signature covers, then key and signature.
constexpr std::string_view kSigned =
    "id, session, station, author, at, sequence, kind, links, link, grade, criterion, points, tick, where_x_mm, "
    "where_y_mm, where_z_mm, withdraws, text_hash";
constexpr int kSignedColumns = 18;

std::optional<StatementKind> kind_from_key(std::string_view key) noexcept {
  const auto found = std::ranges::find(kKinds, key);
  if (found == kKinds.end()) return std::nullopt;
  return static_cast<StatementKind>(found - kKinds.begin());
}

Hash256 text_hash(const Hash256& salt, std::string_view text) {
  return Blake2b{}.add_text("cusp statement text 1").add_hash(salt).add_text(text).finish();
}

Hash256 message_of(const Hash256& content) { return Blake2b{}.add_text("cusp statement 1").add_hash(content).finish(); }

std::string select_signed() { return "SELECT " + std::string(kSigned) + " FROM statements WHERE id = ?1"; }

struct Read {
  SignedStatement statement;
  std::optional<StatementKind> kind;
};

Read read_statement(Row row) {
  Read out;
  SignedStatement& s = out.statement;
  s.id = row.uuid(0);
  s.session = row.id<SessionId>(1);
  s.author = row.id<UserId>(2);
  s.at_utc_us = row.integer(3);
  s.sequence = row.integer(4);
  out.kind = kind_from_key(row.text(5));
  s.kind = out.kind.value_or(StatementKind::comment);
  if (!row.is_null(6)) s.grade = static_cast<int>(row.integer(6));
  if (out.kind == StatementKind::confirmation) {
    s.shown = hash_from_hex(row.text(7));
  } else {
    s.criterion = row.text(7);
  }
  s.points = row.maybe_real(8);
  if (!row.is_null(9)) s.tick = row.u64(9);
  if (!row.is_null(10) && !row.is_null(11) && !row.is_null(12)) s.place_mm = Vec3(row.real(10), row.real(11), row.real(12));
  if (!row.is_null(13)) s.withdraws = row.uuid(13);
  if (!row.is_null(14)) s.text = row.text(14);
  s.station = row.uuid(15);
  return out;
}

/// Numbers of two stations tell nothing of their order, and a clock that was set back nothing of one station's. `statements`: by sequence.
void put_in_order(std::vector<SignedStatement>& statements) {
  struct Placed {
    std::int64_t at_utc_us = 0;
    SignedStatement statement;
  };
  std::map<Uuid, std::int64_t> latest;
  std::vector<Placed> placed;
  for (SignedStatement& s : statements) {
    std::int64_t& at = latest.try_emplace(s.station, s.at_utc_us).first->second;
    at = std::max(at, s.at_utc_us);
    placed.push_back({at, std::move(s)});
  }
  std::ranges::sort(placed, {}, [](const Placed& p) { return std::tuple(p.at_utc_us, p.statement.sequence, p.statement.id); });
  for (std::size_t i = 0; i < placed.size(); ++i) statements[i] = std::move(placed[i].statement);
}

/// The clock of this station may be behind that of another whose statements were read in.
std::int64_t time_of_next(StorageContext& context, Transaction& transaction, SessionId session) {
  const std::int64_t now = context.clock();
  return std::max(now, transaction
                           .first("SELECT coalesce(max(at), ?2) FROM statements INDEXED BY statements_of_session WHERE session = ?1",
                                  [](Row row) { return row.integer(0); }, session, now)
                           .value_or(now));
}

/// Inserts the columns that the signature covers. A confirmation is of no criterion: its column holds the hash of what was shown.
void insert_unsigned(Transaction& transaction, const StorageContext& context, const SignedStatement& s,
                     const std::optional<Hash256>& hash) {
  std::optional<double> x, y, z;
  if (s.place_mm) {
    x = s.place_mm->x;
    y = s.place_mm->y;
    z = s.place_mm->z;
  }
  std::optional<Uuid> withdraws;
  if (!s.withdraws.is_nil()) withdraws = s.withdraws;
  transaction.run(
      "INSERT INTO statements (id, session, station, author, at, sequence, kind, links, link, grade, criterion, points, "
      "tick, where_x_mm, where_y_mm, where_z_mm, withdraws, text_hash, key, signature) "
      "SELECT ?1, ?2, ?3, ?4, ?5, ?6, ?7, links, link, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16, ?17, zeroblob(64) "
      "FROM session_heads WHERE session = ?2",
      s.id, s.session, context.station, s.author, s.at_utc_us, s.sequence, key_of(s.kind), s.grade, s.shown ? hex(*s.shown) : s.criterion,
      s.points, s.tick, x, y, z, withdraws, hash, context.key->id());
}

}  // namespace

std::string_view key_of(StatementKind kind) noexcept { return kKinds[static_cast<std::size_t>(kind)]; }

Stored<std::vector<SignedStatement>> statements_of(Database& db, SessionId session) {
  const auto rows = db.all(
      "SELECT s.id, s.session, s.author, s.at, s.sequence, s.kind, s.grade, s.criterion, s.points, s.tick, s.where_x_mm, "
      "s.where_y_mm, s.where_z_mm, s.withdraws, t.text, s.station FROM statements s INDEXED BY statements_of_session "
      "LEFT JOIN statement_texts t ON t.statement = s.id WHERE s.session = ?1 ORDER BY s.sequence",
      read_statement, session);
  if (!rows) return std::unexpected(rows.error());
  std::vector<SignedStatement> statements;
  for (const Read& row : *rows) {
    if (row.kind) statements.push_back(row.statement);
  }
  put_in_order(statements);
  return statements;
}

std::vector<SignedStatement> in_force(const std::vector<SignedStatement>& statements) {
  std::vector<SignedStatement> out;
  for (const SignedStatement& s : statements) {
    if (s.kind == StatementKind::withdrawal) continue;
    const bool withdrawn = std::ranges::any_of(
        statements, [&](const SignedStatement& w) { return w.kind == StatementKind::withdrawal && w.withdraws == s.id; });
    if (!withdrawn) out.push_back(s);
  }
  return out;
}

void insert_statement(StorageContext& context, Transaction& transaction, SignedStatement& statement) {
  if (!transaction.ok()) return;
  if (!context.key) return transaction.refuse({StorageError::read_only, context.db.file().string()});
  ready_sodium();
  statement.id = Uuid::v7();
  statement.station = context.station;
  statement.at_utc_us = time_of_next(context, transaction, statement.session);
  statement.sequence = context.next_sequence(transaction);
  Hash256 salt{};
  std::optional<Hash256> hash;
  if (!statement.text.empty()) {
    randombytes_buf(salt.data(), salt.size());
    hash = text_hash(salt, statement.text);
  }
  insert_unsigned(transaction, context, statement, hash);
  const auto content = transaction.first(select_signed(), [](Row row) { return row.content_hash(); }, statement.id);
  // A session without a chain has no head, so that nothing was inserted.
  if (!content) return transaction.refuse({StorageError::not_found, "sessions", statement.session.text()});
  const Signature signature = context.key->sign(message_of(*content));
  transaction.run("UPDATE statements SET signature = ?2 WHERE id = ?1", statement.id,
                  std::as_bytes(std::span(signature)));
  if (hash) {
    transaction.run("INSERT INTO statement_texts (statement, salt, text) VALUES (?1, ?2, ?3)", statement.id, salt,
                    statement.text);
  }
}

Stored<std::vector<ChainFinding>> check_statements(Database& db) {
  std::vector<ChainFinding> out;
  const auto find = [&](FindingCode code, std::string table, const Uuid& session, std::string what = {}) {
    out.push_back({code, std::move(table), -1, -1, session, std::move(what), 0});
  };
  struct Signed {
    Uuid id, session;
    Hash256 content, key;
    Signature signature;
  };
  const auto rows = db.all("SELECT " + std::string(kSigned) + ", key, signature FROM statements", [](Row row) {
    return Signed{row.uuid(0), row.uuid(1), row.content_hash(0, kSignedColumns), row.hash(kSignedColumns),
                  signature_of(row.bytes(kSignedColumns + 1))};
  });
  if (!rows) return std::unexpected(rows.error());
  for (const Signed& s : *rows) {
    const auto key = db.first("SELECT public_key FROM station_keys WHERE id = ?1",
                              [](Row row) { return row.hash(0); }, s.key);
    if (!key) return std::unexpected(key.error());
    const bool known = key->has_value() && key_id(**key) == s.key;
    if (!known) {
      find(FindingCode::key_changed, "statements", s.session, hex(s.key));
    } else if (!signature_holds(**key, message_of(s.content), s.signature)) {
      find(FindingCode::row_changed, "statements", s.session, s.id.text());
    }
  }
  const auto texts = db.all(
      "SELECT s.session, s.text_hash, t.salt, t.text, coalesce(s.id, t.statement) FROM statements s "
      "FULL JOIN statement_texts t ON t.statement = s.id",
      [&](Row row) {
        const bool expected = !row.is_null(1), there = !row.is_null(2);
        const Uuid session = row.is_null(0) ? Uuid{} : row.uuid(0);
        if (expected && !there) find(FindingCode::row_missing, "statement_texts", session, row.uuid(4).text());
        if (!expected && there) find(FindingCode::row_added, "statement_texts", session, row.uuid(4).text());
        if (expected && there && text_hash(row.hash(2), row.text(3)) != row.hash(1)) {
          find(FindingCode::row_changed, "statement_texts", session, row.uuid(4).text());
        }
        return true;
      });
  if (!texts) return std::unexpected(texts.error());
  return out;
}

}  // namespace cusp::storage
