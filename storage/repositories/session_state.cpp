#include "storage/repositories/session_state.h"

#include <array>

#include "storage/records/chain_writer.h"
#include "storage/base/process.h"
#include "storage/records/trace_codec.h"

namespace cusp::storage {

std::string_view key_of(SessionKind kind) noexcept {
  constexpr std::array<std::string_view, 4> keys = {"practice", "assessment", "try_it", "try_out"};
  return keys[static_cast<std::size_t>(kind)];
}
std::string_view key_of(SessionState state) noexcept {
  constexpr std::array<std::string_view, 5> keys = {"running", "interrupted", "finished", "graded", "closed"};
  return keys[static_cast<std::size_t>(state)];
}
std::string_view key_of(EventKind kind) noexcept {
  constexpr std::array<std::string_view, 6> keys = {"started",  "interrupted", "resumed",
                                                    "finished", "graded",      "closed"};
  return keys[static_cast<std::size_t>(kind)];
}

std::optional<SessionKind> session_kind_from_key(std::string_view key) noexcept {
  for (const auto kind : {SessionKind::practice, SessionKind::assessment, SessionKind::try_it, SessionKind::try_out}) {
    if (key_of(kind) == key) return kind;
  }
  return std::nullopt;
}
std::optional<SessionState> session_state_from_key(std::string_view key) noexcept {
  for (const auto state : {SessionState::running, SessionState::interrupted, SessionState::finished, SessionState::graded,
                           SessionState::closed}) {
    if (key_of(state) == key) return state;
  }
  return std::nullopt;
}
std::optional<EventKind> event_kind_from_key(std::string_view key) noexcept {
  for (const auto kind : {EventKind::started, EventKind::interrupted, EventKind::resumed, EventKind::finished,
                          EventKind::graded, EventKind::closed}) {
    if (key_of(kind) == key) return kind;
  }
  return std::nullopt;
}

SessionState state_after(const std::vector<SessionEvent>& events) noexcept {
  SessionState state = SessionState::running;
  for (const SessionEvent& event : events) {
    switch (event.kind) {
      case EventKind::started:
      case EventKind::resumed:
        state = SessionState::running;
        break;
      case EventKind::interrupted:
        state = SessionState::interrupted;
        break;
      case EventKind::finished:
        state = SessionState::finished;
        break;
      case EventKind::graded:
        state = SessionState::graded;
        break;
      case EventKind::closed:
        if (state != SessionState::graded) state = SessionState::closed;
        break;
    }
  }
  return state;
}

void require_state(Transaction& transaction, SessionId session, Need need) {
  const auto last = transaction.first(
      "SELECT kind FROM session_events WHERE session = ?1 ORDER BY row DESC LIMIT 1",
      [](Row row) { return event_kind_from_key(row.text(0)); }, session);
  if (!last) return transaction.refuse({StorageError::not_found, "sessions", session.text()});
  const bool running = *last == EventKind::started || *last == EventKind::resumed;
  const bool good = need == Need::running       ? running
                    : need == Need::interrupted ? *last == EventKind::interrupted
                                                : !running;
  if (!good) transaction.refuse({StorageError::wrong_state, "session_events", session.text()});
}

TraceEnd trace_end(Transaction& transaction, SessionId session) {
  const auto end_of = [](Row row) { return TraceEnd{row.u64(0), row.u64(1), row.u64(2)}; };
  const auto end = transaction.first(
      "SELECT row + 1, first_tick + inputs - 1, elapsed_us FROM trace_chunks WHERE session = ?1 "
      "ORDER BY row DESC LIMIT 1",
      end_of, session);
  if (end) return *end;
  return transaction.first(kSelectThinnedEnd, end_of, session).value_or(TraceEnd{});
}

std::uint64_t insert_event(StorageContext& context, Transaction& transaction, SessionId session, EventKind kind,
                           const std::string& reason, const TraceEnd& end) {
  const std::uint64_t row = next_row(transaction, SessionTable::session_events, session);
  const std::int64_t sequence = context.next_sequence(transaction);
  const bool owns = kind == EventKind::started || kind == EventKind::resumed;
  if (owns && !context.mark) context.mark = std::make_shared<const ProcessMark>(context.lock_file());
  transaction.run(
      "INSERT INTO session_events (session, row, kind, at, sequence, tick, reason, process) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8)",
      session, row, key_of(kind), context.clock(), sequence, end.tick, reason, owns ? context.mark->text() : std::string{});
  return row;
}

bool keeps_volume(Transaction& transaction, SessionId session) {
  return transaction.first("SELECT 1 FROM final_volumes WHERE session = ?1", [](Row) { return true; }, session).value_or(false);
}

void insert_final_volume(Transaction& transaction, SessionId session, const FinalVolume& volume) {
  transaction.run("INSERT INTO final_volumes (session, row, tick, volume_hash, cuts) VALUES (?1, 0, ?2, ?3, ?4)",
                  session, volume.tick, volume.hash, pack(volume.cuts));
}

}  // namespace cusp::storage
