/// The tables whose rows a session's chain covers. Writer and verifier read a row through the same columns, so a row's
/// hash means the same to both. A column that a later schema adds gets a new entry, never a place in an old one.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace cusp::storage {

/// Numbers stand in the chain: never renumbered.
enum class SessionTable : std::uint64_t {
  sessions = 1,
  session_events = 2,
  trace_chunks = 3,
  key_states = 4,
  metrics = 5,
  removed_tissues = 6,
  final_volumes = 7,
  grades = 8,
  criteria = 9,
};
inline constexpr std::array kSessionTables = {
    SessionTable::sessions,      SessionTable::session_events, SessionTable::trace_chunks,
    SessionTable::key_states,    SessionTable::metrics,        SessionTable::removed_tissues,
    SessionTable::final_volumes, SessionTable::grades,         SessionTable::criteria,
};

std::string_view name_of(SessionTable table) noexcept;
/// ?1 session, ?2 row: that row's columns.
std::string select_row(SessionTable table);
/// ?1 session: its row number first, then the same columns, for every row in order.
std::string select_rows(SessionTable table);

}  // namespace cusp::storage
