/// Thinned recordings: one signed row of `thinned_traces` stands for the session's rows of `trace_chunks` and `key_states`.
/// The chain still names those rows, so the row signs the chain's head. Within storage only; the database's thread.
#pragma once

#include <cstdint>
#include <optional>

#include "storage/records/context.h"
#include "storage/records/session_tables.h"
#include "storage/records/verify.h"

namespace cusp::storage {

/// Whether thinning empties the table.
constexpr bool is_thinned(SessionTable table) noexcept {
  return table == SessionTable::trace_chunks || table == SessionTable::key_states;
}

/// When the session's recording was thinned; nullopt: it was not.
Stored<std::optional<std::int64_t>> thinned_at(Database& db, SessionId session);
/// What every reader of the recording answers then: wrong_state, where = thinned, detail: UTC µs.
StorageFailure thinned_failure(std::int64_t at_utc_us);

/// Writes and signs the row, with the head of the session's chain as it stands.
void insert_thinned_trace(StorageContext& context, Transaction& transaction, UserId author, SessionId session);

/// Station, key, signature and head of the session's row. nullopt: it holds, or there is none.
Stored<std::optional<FindingCode>> check_thinned_trace(Database& db, SessionId session);

}  // namespace cusp::storage
