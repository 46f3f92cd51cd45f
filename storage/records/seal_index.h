/// The newest seal of everything that the audit log seals, gathered entry by entry. Within storage only.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "storage/records/audit_writer.h"
#include "storage/records/seals.h"
#include "storage/records/verify.h"

namespace cusp::storage {

/// The newest seal of one thing.
template <class Seal>
struct LastSeal {
  Seal seal{};
  std::int64_t at_utc_us = 0;
};

struct SessionSeal {
  ChainHead head;
  std::int64_t at_utc_us = 0;
};

/// Call add() for each entry, in order.
struct SealIndex {
  std::optional<std::int64_t> began_utc_us;
  std::uint64_t sealed_later = 0;  // rows from before sealing began
  std::map<Uuid, LastSeal<AccountSeal>> accounts;
  std::set<Uuid> accounts_created;
  std::set<Uuid> statements_erased;  // whose text is gone by an administrator's act
  std::map<Uuid, std::vector<SessionSeal>> sessions;
  std::array<std::map<Uuid, LastSeal<Hash256>>, kSealedTables.size()> rows;  // by SealedTable; without comments
  std::map<std::pair<Uuid, Hash256>, LastSeal<int>> comments;                // (session, hash): how many
  std::map<std::pair<Uuid, Uuid>, LastSeal<bool>> members;                   // (cohort, student): is a member
  std::map<std::string, std::vector<std::int64_t>> keys;                     // key id: when it was added
  std::vector<ChainFinding> incidents;
  std::optional<std::int64_t> sequence;  // of the last entry
  bool sequence_fell = false;

  void add(const AuditEntry& e);

 private:
  void add_account(const AuditEntry& e);
  void add_session(const AuditEntry& e);
  void add_row(const AuditEntry& e);
};

}  // namespace cusp::storage
