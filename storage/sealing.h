/// Seals: the audit log holds, beside who did what, a hash of what stands there afterwards. So a row that is deleted,
/// added or changed behind the program's back differs from the log's last word on it, and the log cannot be cut without
/// the rollback counter showing it. Names never enter the log: only hashes that a random secret of the row salts.
///
/// | entry | subject | detail ends in |
/// |---|---|---|
/// | session_sealed | session | event, entries of its chain, last link |
/// | account_created, account_renamed, role_changed, ..., person_sealed | person | six words of person_seal() |
/// | commented, comment_sealed | session | hash of the comment's row |
/// | cohort_created, cohort_sealed; assigned, assignment_sealed; version_published, version_kept, version_sealed | row
/// | hash of the row | | sealing_began | station | how many rows were there before: they are sealed as they stood then
/// | | rolled_back, counter_missing, counter_broken, log_damaged | station | an incident, kept for good |
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "storage/context.h"

namespace cusp::storage {

/// Columns of `people` that person_seal() takes, in its order: put "WHERE id = ?1" behind.
inline constexpr const char* kSealedPeople =
    "SELECT id, role, disabled, guest, password, pin, created_at, number, name FROM people ";
/// role, disabled, guest, password, PIN, number and name. A secret is the hash of its record, "-" when there is none.
/// Number and name enter a hash that the password's or PIN's own random salt protects; without either they stay out.
using PersonSeal = std::array<std::string, 6>;
inline constexpr std::array<std::string_view, 6> kPersonSealWords = {"role",     "disabled", "guest",
                                                                     "password", "PIN",      "number or name"};
PersonSeal person_seal(Row row);
std::string text_of(const PersonSeal& seal);
/// nullopt for a detail of before sealing began.
std::optional<PersonSeal> person_seal_from(std::string_view detail);

/// Rows sealed by one hash. Numbers are not stored.
enum class SealedTable : std::uint8_t { comments, cohorts, assignments, scenario_versions };
inline constexpr std::array kSealedTables = {SealedTable::comments, SealedTable::cohorts, SealedTable::assignments,
                                             SealedTable::scenario_versions};
std::string_view name_of(SealedTable table) noexcept;
/// Subject of its entries first, then every column: put "WHERE id = ?1" behind.
std::string select_sealed(SealedTable table);
/// Pre: the row comes of select_sealed(). A version is sealed with its files.
Hash256 row_seal(Database& db, SealedTable table, Row row);

/// Entries with a seal, within the transaction that wrote the row.
void log_person(StorageContext& context, Transaction& transaction, UserId actor, std::string_view action, UserId who);
void log_row(StorageContext& context, Transaction& transaction, UserId actor, std::string_view action,
             SealedTable table, const Uuid& id);
/// After ChainWriter::finish(). `event` is a key of EventKind.
void log_session(StorageContext& context, Transaction& transaction, UserId actor, SessionId session,
                 std::string_view event);

/// Commits, then brings the counter up to the log. What keeps the counter from being written is no failure of the
/// transaction: it stays in context.counter_failure, and the next commit catches up.
Stored<void> commit_sealed(StorageContext& context, Transaction& transaction);

/// At each opening for writing: seals what was there before, once; looks at the counter, and puts what it shows into
/// the log and into context.incident.
Stored<void> begin_sealing(StorageContext& context);
/// The same question without writing; for a file that is opened read-only.
void look_at_counter(StorageContext& context);

}  // namespace cusp::storage
