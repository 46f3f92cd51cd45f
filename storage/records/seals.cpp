#include "storage/records/seals.h"

#include <sstream>
#include <utility>
#include <vector>

namespace cusp::storage {
namespace {

/// The record of a password or PIN holds a random salt: equal secrets of two users have different hashes.
std::string secret_seal(const Uuid& id, const std::string& record) {
  if (record.empty()) return "-";
  return hex(Blake2b{}.add_text("cusp secret 1").add_uuid(id).add_text(record).finish());
}

/// How many columns at the end a later migration added. A seal leaves those out that are NULL, as they are in older rows.
constexpr int added_columns(SealedTable table) noexcept {
  return table == SealedTable::assignments ? 3 : table == SealedTable::adjustments ? 1 : 0;
}

Hash256 content_of(SealedTable table, Row row) {
  int end = row.columns();
  for (int added = added_columns(table); added > 0 && row.is_null(end - 1); --added) --end;
  return row.content_hash(0, end);
}

/// The subject of the row's entries first, then every other column.
constexpr std::string_view columns_of(SealedTable table) noexcept {
  switch (table) {
    case SealedTable::comments:
      return "session, id, author, at, sequence, tick, text";
    case SealedTable::cohorts:
      return "id, name, created_at";
    case SealedTable::assignments:
      return "id, version, cohort, kind, opens_at, due_at, goes_allowed, author, created_at, sequence, device_classes, "
             "self_test_days, drawn_tooth";
    case SealedTable::scenario_versions:
      return "id, scenario, number, key, title, json, content_hash, author, published_at, sequence";
    case SealedTable::statements:
      return "id, session, station, author, at, sequence, kind, links, link, grade, criterion, points, tick, where_x_mm, "
             "where_y_mm, where_z_mm, withdraws, text_hash, key, signature";
    case SealedTable::assessments:
      return "assignment, start_code";
    case SealedTable::version_withdrawals:
      return "version, author, at, sequence";
    case SealedTable::assignment_withdrawals:
      return "assignment, author, at, sequence";
    case SealedTable::adjustments:
      return "id, assignment, student, extra_time_percent, author, at, sequence, large_text";
    case SealedTable::other_keys:
      return "id, station, key, role, changed_at";
    case SealedTable::referred:
      return "id, here";
    case SealedTable::thinned_traces:
      return "session, station, author, at, links, link, key, signature";
  }
  return {};
}

}  // namespace

std::string_view key_column(SealedTable table) noexcept {
  if (table == SealedTable::assessments || table == SealedTable::assignment_withdrawals) return "assignment";
  if (table == SealedTable::thinned_traces) return "session";
  return table == SealedTable::version_withdrawals ? "version" : "id";
}

AccountSeal account_seal(Row row) {
  const Uuid id = row.uuid(0);
  const std::string password = row.text(4), pin = row.text(5);
  Blake2b identity;
  identity.add_text("cusp person 1").add_uuid(id).add_u64(row.u64(6));
  if (!password.empty() || !pin.empty()) {
    identity.add_text(password).add_text(pin).add_text(row.text(7)).add_text(row.text(8));
  }
  return {
      row.text(1),          std::to_string(row.integer(2)), std::to_string(row.integer(3)), secret_seal(id, password),
      secret_seal(id, pin), hex(identity.finish())};
}

std::string text_of(const AccountSeal& seal) {
  std::string out;
  for (const std::string& field : seal) out += (out.empty() ? "" : " ") + field;
  return out;
}

std::optional<AccountSeal> account_seal_from(std::string_view detail) {
  std::istringstream in{std::string(detail)};
  AccountSeal seal;
  for (std::string& field : seal) {
    if (!(in >> field)) return std::nullopt;
  }
  return seal;
}

std::string_view name_of(SealedTable table) noexcept {
  constexpr std::array<std::string_view, 12> names = {"comments",   "cohorts",     "assignments",         "scenario_versions",
                                                      "statements", "assessments", "version_withdrawals", "adjustments",
                                                      "other_keys", "referred",    "thinned_traces",
                                                      "assignment_withdrawals"};
  return names[static_cast<std::size_t>(table)];
}

Stored<std::vector<RowSeal>> row_seals(Database& db, SealedTable table, const std::optional<Uuid>& id) {
  Stored<void> files_read;
  const auto add_files = [&](Blake2b& seal, const Uuid& version) {
    const auto files = db.all(
        "SELECT name, blob FROM version_files WHERE version = ?1 ORDER BY name",
        [](Row file) {
          return std::pair{file.text(0), file.hash(1)};
        },
        version);
    if (!files) {
      files_read = std::unexpected(files.error());
      return;
    }
    for (const auto& [name, blob] : *files) seal.add_text(name).add_hash(blob);
  };
  const auto seal_of = [&](Row row) {
    Blake2b seal;
    seal.add_text(name_of(table)).add_hash(content_of(table, row));
    if (table == SealedTable::scenario_versions) add_files(seal, row.uuid(0));
    return RowSeal{row.uuid(0), seal.finish()};
  };
  const std::string sql = "SELECT " + std::string(columns_of(table)) + " FROM " + std::string(name_of(table));
  auto seals = id ? db.all(sql + " WHERE " + std::string(key_column(table)) + " = ?1", seal_of, *id) : db.all(sql, seal_of);
  if (seals && !files_read) return std::unexpected(files_read.error());
  return seals;
}

}  // namespace cusp::storage
