/// What reading a file adds to the records, table by table, within one transaction. A row that differs refuses it. Within
/// storage only.
#pragma once

#include <set>

#include "storage/base/watch.h"
#include "storage/exchange/exchange.h"
#include "storage/records/seals.h"

namespace cusp::storage {

/// The file is open as `from`, and attached to the transaction's database as `source`.
struct Merge {
  StorageContext& context;
  Transaction& transaction;
  StorageContext& from;
  const Actor& actor;
  ReadIn& out;
  WorkSteps& steps;
  std::set<SessionId> changed{};  // sessions whose summaries changed; follow_graded() follows them at the end
  std::set<Uuid> referred{};  // accounts, versions and assignments that the file's records only refer to

  Database& db() { return transaction.database(); }
  bool late() const noexcept { return out.outcome == ReadOutcome::late; }
  bool ok() { return transaction.ok(); }
  /// Before each step. False after a failure; the watch may make one.
  bool goes_on() {
    if (ok() && !steps.go_on()) refuse(StorageError::stopped, from.db.file().string());
    return ok();
  }
  void refuse(StorageError code, std::string where, std::string detail = {}) {
    transaction.refuse({code, std::move(where), std::move(detail)});
  }
  /// Refuses on failure, and is then empty.
  template <class T>
  std::vector<T> taken(Stored<std::vector<T>> rows) {
    if (rows) return std::move(*rows);
    transaction.refuse(rows.error());
    return {};
  }
};

/// Accounts, then versions: what the other rows refer to.
void merge_people(Merge& merge);
void merge_versions(Merge& merge);
/// Rows that never change. `action`: of the entry about each that was not here. Of a version or assignment that both stations
/// withdrew, each keeps its own row. A cohort whose name is taken here gets another one.
void merge_rows(Merge& merge, SealedTable table, const char* action);
/// The members of the file's cohorts become those of the file, unless it is late.
void merge_members(Merge& merge);
void merge_sessions(Merge& merge);
void merge_statements(Merge& merge);

/// Within a transaction: whether this station knows the account, version or assignment by reference alone.
bool is_referred(Transaction& transaction, const Uuid& id);
void refer(Merge& merge, const Uuid& id);
void arrive(Merge& merge, const Uuid& id);
/// Whether the account was erased here.
bool is_erased(Transaction& transaction, UserId user);

}  // namespace cusp::storage
