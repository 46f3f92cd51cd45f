/// Adds a session's new rows to its chain and signs the new head, within the transaction that wrote the rows.
#pragma once

#include <cstdint>

#include "storage/records/context.h"
#include "storage/records/session_tables.h"

namespace cusp::storage {

class ChainWriter {
 public:
  /// Continues the session's chain from its head, or begins one. Refuses the session of another station: its chain would fork.
  ChainWriter(StorageContext& context, Transaction& transaction, SessionId session);
  /// Reads the row back and links its hash. Pre: this transaction wrote the row.
  void add(SessionTable table, std::uint64_t row, std::int64_t second);
  /// Signs and stores the head. Once, last.
  void finish();

 private:
  StorageContext& context_;
  Transaction& transaction_;
  SessionId session_;
  ChainHead head_;
};

/// The number of the session's next row in this table.
std::uint64_t next_row(Transaction& transaction, SessionTable table, SessionId session);

}  // namespace cusp::storage
