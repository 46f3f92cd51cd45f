#include "storage/exchange/session_copies.h"

#include <array>

#include "storage/exchange/unnamed_copies.h"

namespace cusp::storage {
namespace {

namespace fs = std::filesystem;

/// Of the attached database `source` to the new one, in an order that keeps every reference whole. ?1: the session.
constexpr std::array kCopies = {
    "INSERT OR IGNORE INTO station_keys SELECT * FROM source.station_keys WHERE id IN (SELECT key FROM source.session_heads WHERE session = ?1 "
    "UNION SELECT key FROM source.statements WHERE session = ?1 UNION SELECT key FROM source.thinned_traces WHERE session = ?1)",
    "INSERT OR IGNORE INTO people SELECT id, number, name, role, '', '', 1, guest, 0, 0, created_at FROM source.people WHERE id IN ("
    "SELECT student FROM source.sessions WHERE id = ?1 UNION SELECT grader FROM source.grades WHERE session = ?1 "
    "UNION SELECT d.author FROM source.adjustments d JOIN source.sessions s ON s.assignment = d.assignment AND s.student = d.student WHERE s.id = ?1 "
    "UNION SELECT author FROM source.statements WHERE session = ?1 UNION SELECT author FROM source.comments WHERE session = ?1 "
    "UNION SELECT a.author FROM source.assignments a JOIN source.sessions s ON s.assignment = a.id WHERE s.id = ?1 "
    "UNION SELECT v.author FROM source.scenario_versions v JOIN source.sessions s ON s.version = v.id WHERE s.id = ?1)",
    "INSERT OR IGNORE INTO cohorts SELECT * FROM source.cohorts WHERE id IN (SELECT a.cohort FROM source.assignments a "
    "JOIN source.sessions s ON s.assignment = a.id WHERE s.id = ?1)",
    "INSERT OR IGNORE INTO blobs SELECT * FROM source.blobs WHERE hash IN (SELECT specimen_blob FROM source.sessions WHERE id = ?1 "
    "UNION SELECT f.blob FROM source.version_files f JOIN source.sessions s ON s.version = f.version WHERE s.id = ?1)",
    "INSERT OR IGNORE INTO scenario_versions SELECT * FROM source.scenario_versions WHERE id = (SELECT version FROM source.sessions WHERE id = ?1)",
    "INSERT OR IGNORE INTO version_files SELECT * FROM source.version_files WHERE version = (SELECT version FROM source.sessions WHERE id = ?1)",
    "INSERT OR IGNORE INTO assignments SELECT * FROM source.assignments WHERE id = (SELECT assignment FROM source.sessions WHERE id = ?1)",
    "INSERT OR IGNORE INTO sessions SELECT * FROM source.sessions WHERE id = ?1",
    "INSERT OR IGNORE INTO adjustments SELECT d.* FROM source.adjustments d JOIN source.sessions s ON s.assignment = d.assignment AND s.student = d.student "
    "WHERE s.id = ?1",
    "INSERT OR IGNORE INTO session_events SELECT * FROM source.session_events WHERE session = ?1",
    "INSERT OR IGNORE INTO trace_chunks SELECT * FROM source.trace_chunks WHERE session = ?1",
    "INSERT OR IGNORE INTO key_states SELECT * FROM source.key_states WHERE session = ?1",
    "INSERT OR IGNORE INTO metrics SELECT * FROM source.metrics WHERE session = ?1",
    "INSERT OR IGNORE INTO removed_tissues SELECT * FROM source.removed_tissues WHERE session = ?1",
    "INSERT OR IGNORE INTO final_volumes SELECT * FROM source.final_volumes WHERE session = ?1",
    "INSERT OR IGNORE INTO grades SELECT * FROM source.grades WHERE session = ?1",
    "INSERT OR IGNORE INTO criteria SELECT * FROM source.criteria WHERE session = ?1",
    "INSERT OR IGNORE INTO graded_criteria SELECT * FROM source.graded_criteria WHERE session = ?1",
    "INSERT OR IGNORE INTO session_chain SELECT * FROM source.session_chain WHERE session = ?1",
    "INSERT OR IGNORE INTO session_heads SELECT * FROM source.session_heads WHERE session = ?1",
    "INSERT OR IGNORE INTO thinned_traces SELECT * FROM source.thinned_traces WHERE session = ?1",
    "INSERT OR IGNORE INTO comments SELECT * FROM source.comments WHERE session = ?1",
    "INSERT OR IGNORE INTO statements SELECT * FROM source.statements WHERE session = ?1 ORDER BY sequence",
    "INSERT OR IGNORE INTO statement_texts SELECT t.* FROM source.statement_texts t JOIN source.statements s ON s.id = t.statement WHERE s.session = ?1",
    "INSERT OR IGNORE INTO session_summaries SELECT * FROM source.session_summaries WHERE session = ?1",
};

/// In the older journal mode the file needs no log beside it.
Stored<void> fill_new(const fs::path& file, const fs::path& from, const OnCopy& fill, const OnCopy& finish) {
  auto to = Database::open(file, {.on_network_drive = admits_network_drive});
  if (!to) return std::unexpected(to.error());
  // What is lost before the copy is whole was never there; a stick is waited for once, and not after each of thousands of attempts.
  if (auto done = to->run("PRAGMA synchronous = OFF"); !done) return done;
  if (auto done = to->attach_source(from); !done) return done;
  if (auto done = fill(*to); !done) return done;
  to->detach_source();
  if (auto done = to->run("PRAGMA synchronous = FULL"); !done) return done;
  if (auto done = to->run("PRAGMA journal_mode = DELETE"); !done) return done;
  std::error_code error;
  // SQLite keeps its log if it could not write all of it into the database.
  if (fs::exists(file.string() + "-wal", error)) return fail(StorageError::io, file.string());
  return finish(*to);
}

}  // namespace

Stored<void> make_copy(const fs::path& file, const fs::path& from, const OnCopy& fill, const OnCopy& finish) {
  return make_named(file, [&](const fs::path& copy, const NoteName& note) {
    return fill_new(copy, from, fill, [&](Database& to) -> Stored<void> {
      if (!finish) return {};
      auto noted = note();
      return noted ? finish(to) : noted;
    });
  });
}

bool copy_session(Transaction& to, SessionId session) {
  const auto runs = to.first(
      "SELECT 1 FROM source.session_events WHERE session = ?1 AND row = (SELECT max(row) FROM source.session_events WHERE session = ?1) "
      "AND kind IN ('started', 'resumed')",
      [](Row) { return true; }, session);
  if (runs) return false;
  for (const char* copy : kCopies) to.run(copy, session);
  const auto header = to.first("SELECT header FROM source.sessions WHERE id = ?1", [](Row row) { return hash_from_hex(row.text(0)); }, session);
  if (header && *header) to.run("INSERT OR IGNORE INTO blobs SELECT * FROM source.blobs WHERE hash = ?1", **header);
  return true;
}

}  // namespace cusp::storage
