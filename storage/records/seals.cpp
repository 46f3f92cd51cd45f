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

constexpr std::string_view columns_of(SealedTable table) noexcept {
  switch (table) {
    case SealedTable::comments:
      return "session, id, author, at, sequence, tick, text";
    case SealedTable::cohorts:
      return "id, name, created_at";
    case SealedTable::assignments:
      return "id, version, cohort, kind, opens_at, due_at, goes_allowed, author, created_at, sequence";
    case SealedTable::scenario_versions:
      return "id, scenario, number, key, title, json, content_hash, author, published_at, sequence";
  }
  return {};
}

}  // namespace

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
  constexpr std::array<std::string_view, 4> names = {"comments", "cohorts", "assignments", "scenario_versions"};
  return names[static_cast<std::size_t>(table)];
}

std::string select_sealed(SealedTable table) {
  return "SELECT " + std::string(columns_of(table)) + " FROM " + std::string(name_of(table)) + ' ';
}

Hash256 row_seal(Database& db, SealedTable table, Row row) {
  Blake2b seal;
  seal.add_text(name_of(table)).add_hash(row.content_hash());
  if (table == SealedTable::scenario_versions) {
    const auto files = db.all(
        "SELECT name, blob FROM version_files WHERE version = ?1 ORDER BY name",
        [](Row file) {
          return std::pair{file.text(0), file.hash(1)};
        },
        row.uuid(0));
    for (const auto& [name, blob] : files.value_or(std::vector<std::pair<std::string, Hash256>>{})) {
      seal.add_text(name).add_hash(blob);
    }
  }
  return seal.finish();
}

}  // namespace cusp::storage
