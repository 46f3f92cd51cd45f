/// Checks and rows that all repositories share when they write to a session. Within storage only.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "storage/records/context.h"
#include "storage/repositories/sessions.h"

namespace cusp::storage {

/// End of a session's stored trace.
struct TraceEnd {
  std::uint64_t chunks = 0, tick = 0, elapsed_us = 0;
  std::int64_t second() const noexcept { return static_cast<std::int64_t>(elapsed_us / 1'000'000); }
};

std::optional<SessionKind> session_kind_from_key(std::string_view key) noexcept;
std::optional<SessionState> session_state_from_key(std::string_view key) noexcept;
std::optional<EventKind> event_kind_from_key(std::string_view key) noexcept;

enum class Need { running, interrupted, not_running };
/// Refuses with not_found, or with wrong_state if the session is in another state.
void require_state(Transaction& transaction, SessionId session, Need need);

/// A thinned recording ends where metrics and final volume do.
TraceEnd trace_end(Transaction& transaction, SessionId session);
/// The SQL for that; ?1 session: chunks, tick, elapsed_us.
inline constexpr const char* kSelectThinnedEnd =
    "SELECT (SELECT count(*) FROM metrics m WHERE m.session = ?1), v.tick, "
    "coalesce((SELECT elapsed_us FROM metrics m WHERE m.session = ?1 ORDER BY row DESC LIMIT 1), 0) "
    "FROM thinned_traces t JOIN final_volumes v ON v.session = t.session WHERE t.session = ?1";

/// Inserts the row and returns its number. The caller links it.
std::uint64_t insert_event(StorageContext& context, Transaction& transaction, SessionId session, EventKind kind,
                           const std::string& reason, const TraceEnd& end);
bool keeps_volume(Transaction& transaction, SessionId session);
/// Inserts the session's only volume, as row 0. The caller links it.
void insert_final_volume(Transaction& transaction, SessionId session, const FinalVolume& volume);

}  // namespace cusp::storage
