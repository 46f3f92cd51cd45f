/// What the audit log says of each thing that it seals, gathered entry by entry. Within storage only.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "storage/repositories/audit_log.h"
#include "storage/sealing.h"
#include "storage/verify.h"

namespace cusp::storage {

/// The log's last word on something.
template <class Seal>
struct LastWord {
  Seal seal{};
  std::int64_t at_utc_us = 0;
};

struct SessionSeal {
  std::uint64_t links = 0;
  Hash256 link{};
  std::int64_t at_utc_us = 0;
};

/// Feed entries in order.
struct LogWords {
  std::optional<std::int64_t> began_utc_us;
  std::uint64_t sealed_later = 0;
  std::map<Uuid, LastWord<PersonSeal>> people;
  std::set<Uuid> accounts_created;
  std::map<Uuid, std::vector<SessionSeal>> sessions;
  std::array<std::map<Uuid, LastWord<Hash256>>, kSealedTables.size()> rows;  // but for comments, by SealedTable
  std::map<std::pair<Uuid, Hash256>, LastWord<int>> comments;                // (session, hash): how many
  std::map<std::pair<Uuid, Uuid>, LastWord<bool>> members;                   // (cohort, student): in it
  std::map<std::string, std::vector<std::int64_t>> keys;                     // name of a key: when it was added
  std::vector<ChainFinding> incidents;
  std::optional<std::int64_t> sequence;  // the last entry's
  bool sequence_fell = false;

  void take(const AuditEntry& e);

 private:
  void take_person(const AuditEntry& e);
  void take_session(const AuditEntry& e);
  void take_row(const AuditEntry& e);
};

}  // namespace cusp::storage
