/// The tables whose rows a session's chain covers. Writer and verifier select the same columns of a row, so that both
/// compute the same hash. A column of a later schema gets a new entry here, never a place in an old one.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace cusp::storage {

/// The chain stores these numbers: they never change.
enum class SessionTable : std::uint64_t {
  sessions = 1,
  session_events = 2,
  trace_chunks = 3,
  key_states = 4,
  metrics = 5,
  removed_tissues = 6,
  final_volumes = 7,
  grades = 8,
  criteria = 9,          // of grades before schema 13
  graded_criteria = 10,  // of later ones: a row has the number of its grade
};
inline constexpr std::array kSessionTables = {
    SessionTable::sessions,      SessionTable::session_events, SessionTable::trace_chunks,
    SessionTable::key_states,    SessionTable::metrics,        SessionTable::removed_tissues,
    SessionTable::final_volumes, SessionTable::grades,         SessionTable::criteria,
    SessionTable::graded_criteria,
};

std::string_view name_of(SessionTable table) noexcept;
/// SQL for the columns of one row; ?1 session, ?2 row.
std::string select_row(SessionTable table);
/// SQL for every row in order: its number first, then the same columns; ?1 session.
std::string select_rows(SessionTable table);

}  // namespace cusp::storage
