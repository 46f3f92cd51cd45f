/// Seals: hashes of what stands in a row. The audit log keeps them, so that a row which SQL deletes, adds or changes
/// differs from its newest seal. Names never enter the log, only hashes that a random secret of the row salts.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/sqlite/database.h"

namespace cusp::storage {

/// Columns of the table `people` that account_seal() reads, in its order. A caller appends "WHERE id = ?1".
inline constexpr const char* kSelectSealedAccounts =
    "SELECT id, role, disabled, guest, password, pin, created_at, number, name FROM people ";
/// Role, disabled, guest, password, PIN, number and name. A secret is the hash of its record, "-" if there is none.
/// Number and name enter one hash with the password's or PIN's own random salt; without either they stay out.
using AccountSeal = std::array<std::string, 6>;
inline constexpr std::array<std::string_view, 6> kAccountSealFields = {"role",     "disabled", "guest",
                                                                       "password", "PIN",      "number or name"};
AccountSeal account_seal(Row row);
std::string text_of(const AccountSeal& seal);
/// nullopt for the detail of an entry from before sealing began.
std::optional<AccountSeal> account_seal_from(std::string_view detail);

/// Rows sealed by one hash. The numbers are not stored.
enum class SealedTable : std::uint8_t {
  comments,
  cohorts,
  assignments,
  scenario_versions,
  statements,
  assessments,
  version_withdrawals,
  adjustments,
  other_keys,
  referred,
  thinned_traces,
  assignment_withdrawals,
};
inline constexpr std::array kSealedTables = {SealedTable::comments,    SealedTable::cohorts,
                                             SealedTable::assignments, SealedTable::scenario_versions,
                                             SealedTable::statements,  SealedTable::assessments,
                                             SealedTable::version_withdrawals, SealedTable::adjustments,
                                             SealedTable::other_keys,  SealedTable::referred,
                                             SealedTable::thinned_traces, SealedTable::assignment_withdrawals};
std::string_view name_of(SealedTable table) noexcept;
/// The column that names one row.
std::string_view key_column(SealedTable table) noexcept;
struct RowSeal {
  Uuid subject;  // of the row's entries in the audit log
  Hash256 seal;
};
/// The seal of each row, or of the row `id` alone: none if it is not there. The seal of a version covers its files.
Stored<std::vector<RowSeal>> row_seals(Database& db, SealedTable table, const std::optional<Uuid>& id = {});

}  // namespace cusp::storage
