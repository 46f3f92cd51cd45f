/// A file from station to station: a database of the same schema, with a signed description of what its tables hold.
/// Within storage only; exchange.h is what others call.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "storage/base/watch.h"
#include "storage/exchange/signed_text.h"
#include "storage/sqlite/database.h"

namespace cusp::storage {

enum class ExchangeKind : std::uint8_t {
  results,  // sessions and statements of the station that gives it out
  office,   // accounts, cohorts, assignments, versions, and statements of the office
};
std::string_view key_of(ExchangeKind kind) noexcept;

struct ExchangeDescription {
  Uuid station{};
  ExchangeKind kind = ExchangeKind::results;
  UserId maker{};
  std::int64_t made_utc_us = 0;
  ChainHead log{};                 // of the station's audit log
  std::vector<Hash256> earlier{};  // of the descriptions of all files given out under this key before, oldest first
  std::vector<PackFile> tables{};  // content of each table
  std::size_t number() const noexcept { return earlier.size() + 1; }
};

/// Rows that a file carries, or that reading it added or changed.
struct ExchangeCounts {
  std::uint64_t sessions = 0, statements = 0, accounts = 0, versions = 0, assignments = 0;
  bool none() const noexcept { return sessions + statements + accounts + versions + assignments == 0; }
};
/// What the file carries; rows that it only refers to do not count.
Stored<ExchangeCounts> counts_of(Database& file);

/// Of a description's text: what later files name this one by.
Hash256 description_hash(const SignedText& text);
SignedText sign_exchange(const StationKey& key, const ExchangeDescription& description);
/// Writes the signed description into the file, as the last thing.
Stored<void> add_description(Database& file, const SignedText& text);

/// Opens a file of another station to read from. cut_short before anything is read; its schema may be older: check_schema() follows.
Stored<Database> open_exchange(const std::filesystem::path& file);

struct CheckedExchange {
  ExchangeDescription description{};
  Hash256 hash{};  // description_hash
  std::array<std::uint8_t, 32> public_key{};
};
/// not_exchange if the database holds no description or its signature does not hold.
Stored<CheckedExchange> read_description(Database& file);

/// Damage of the file is no damage of the records: corrupt becomes not_exchange.
StorageFailure failure_in_file(StorageFailure failure, const std::filesystem::path& file);
/// older_schema for a file of an older program: tables that a later migration changes differ from what was signed. not_exchange for
/// a table, column or index that the records lack: SQL is built from these names.
/// The file is attached to `records` for a moment, to compare both schemas.
Stored<void> check_schema(Database& records, const std::filesystem::path& file);
/// Schema and every table against the signed list once more, in the transaction that reads them: the file may have been changed or
/// replaced since. Pre: it is attached to `records`. Failures: older_schema, not_exchange, stopped.
Stored<void> check_attached(Database& records, const std::filesystem::path& file, const ExchangeDescription& description, WorkSteps& steps);
/// Name and content of each table but the description's, by name. A step for each session whose recording is read: recordings are most of
/// a file. not_exchange for a file with views or triggers; stopped between two tables.
Stored<std::vector<PackFile>> table_hashes(Database& file, WorkSteps& steps);
/// Structure, every table against the signed list, every blob, every statement. Failures: not_exchange, differs, stopped; not_allowed
/// (where = office_file) for a results file that brings more than it refers to.
Stored<void> check_content(Database& file, const ExchangeDescription& description, WorkSteps& steps);

}  // namespace cusp::storage
