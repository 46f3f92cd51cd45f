/// What repositories that write to a session must know of it first. Within storage only.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "storage/context.h"
#include "storage/repositories/sessions.h"

namespace cusp::storage {

/// How far a session's trace goes.
struct TraceEnd {
  std::uint64_t chunks = 0, tick = 0, elapsed_us = 0;
  std::int64_t second() const noexcept { return static_cast<std::int64_t>(elapsed_us / 1'000'000); }
};

std::optional<SessionKind> session_kind_from_key(std::string_view key) noexcept;
std::optional<EventKind> event_kind_from_key(std::string_view key) noexcept;

/// Refuses with not_found or, unless its state is admitted, wrong_state.
enum class Need { running, interrupted, not_running };
void require_state(Transaction& transaction, SessionId session, Need need);

TraceEnd trace_end(Transaction& transaction, SessionId session);

/// Writes the row and returns its number; the caller links it.
std::uint64_t insert_event(StorageContext& context, Transaction& transaction, SessionId session, EventKind kind,
                           const std::string& reason, const TraceEnd& end);
/// The only one of its session; the caller links row 0.
void insert_final_volume(Transaction& transaction, SessionId session, const FinalVolume& volume);

}  // namespace cusp::storage
