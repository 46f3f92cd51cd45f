/// Adds a session's fresh rows to its chain and signs the new head, all within the transaction that wrote the rows.
#pragma once

#include <cstdint>

#include "storage/context.h"
#include "storage/session_tables.h"

namespace cusp::storage {

class ChainWriter {
 public:
  /// Picks up the chain where it stands; a session without one begins it.
  ChainWriter(StorageContext& context, Transaction& transaction, SessionId session);
  /// Reads the row back and links its hash. Pre: the row was written in this transaction.
  void add(SessionTable table, std::uint64_t row, std::int64_t second);
  /// Signs and stores the head. Once, last.
  void finish();

 private:
  StorageContext& context_;
  Transaction& transaction_;
  SessionId session_;
  std::uint64_t links_ = 0;
  Hash256 link_{};
};

/// The row number that a session's next row in this table gets.
std::uint64_t next_row(Transaction& transaction, SessionTable table, SessionId session);

}  // namespace cusp::storage
