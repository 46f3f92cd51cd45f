/// Files from station to station: README.md beside this lists what each carries and how it is read. A `watch` gets sessions of a results
/// file and accounts of an office file, 0 of 0 before they are counted; stopped, a call has changed nothing. Thread: the context's own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "storage/base/rights.h"
#include "storage/base/watch.h"
#include "storage/exchange/exchange_file.h"
#include "storage/exchange/trust.h"
#include "storage/records/context.h"

namespace cusp::storage {

struct GivenOut {
  ExchangeDescription description{};
  Hash256 key{};  // id of this station's key
  ExchangeCounts counts{};
};

/// Writes a new file, and the entry "exchange_given_out". Needs manage_station. duplicate if the file exists; a failure
/// leaves no file. read_only without the station's key. A file in the same folder whose program was killed between entry and name gets its
/// name first; duplicate, detail "finished" (where = its name): it is this one, and holds what the records held then.
/// Once the entry is being written, nothing stops it.
Stored<GivenOut> give_out(StorageContext& context, const Actor& actor, ExchangeKind kind, const std::filesystem::path& file,
                          const WorkWatch& watch = {});

enum class ReadOutcome : std::uint8_t {
  read,
  again,  // it was read before
  late,   // made before one that was already read: adds what is new, and changes nothing that is here
};
std::string_view key_of(ReadOutcome outcome) noexcept;

struct ReadIn {
  ExchangeDescription description{};
  Hash256 key{};
  ReadOutcome outcome = ReadOutcome::read;
  ExchangeCounts counts{};
  std::uint64_t grown = 0;               // of counts.sessions: they were here before, with fewer rows
  std::uint64_t waiting = 0;             // statements about sessions that are not here yet
  std::vector<std::string> conflicts{};  // numbers of accounts changed both here and in the office, which won
  std::vector<std::string> gave_way{};   // numbers that students' accounts of this station gave to the office's of the same names
  std::vector<SessionId> apart{};        // their chains here go on in another way than in the file: they stay as they are here
};

/// Reads a file whole, or changes nothing. Needs manage_station. Failures: not_exchange, cut_short, older_schema, newer_schema,
/// unknown_key, revoked_key, put_back, differs; not_allowed (where = own_file, office_file: what only the office's file may bring);
/// duplicate (where = number that somebody of another name has here); last_administrator; stopped.
Stored<ReadIn> read_in(StorageContext& context, const Actor& actor, const std::filesystem::path& file, const WorkWatch& watch = {});

/// What a file is, before it is read.
struct ExchangeLook {
  ExchangeDescription description{};
  PublicKey signer{};
  std::optional<KeyRole> role{};  // of the signer's key here; nullopt: unknown
  ExchangeCounts counts{};        // what the file carries
  std::size_t newest_read = 0;    // number of the newest file under this key that was read in; 0: none
};

/// Changes nothing. Needs manage_station. Failures: not_exchange, cut_short, older_schema, newer_schema, differs, and not_allowed
/// (where = own_file, office_file), stopped.
Stored<ExchangeLook> look_into(StorageContext& context, const Actor& actor, const std::filesystem::path& file, const WorkWatch& watch = {});

/// A file that was read in: whose, its number, and when.
struct FileReadIn {
  Hash256 key{};
  std::size_t number = 0;
  std::int64_t at_utc_us = 0;
};
/// Of all trusted stations, oldest first. Needs manage_station.
Stored<std::vector<FileReadIn>> files_read_in(StorageContext& context, const Actor& actor);

}  // namespace cusp::storage
