#include <algorithm>

#include "storage/exchange/merge.h"
#include "storage/records/audit_writer.h"
#include "storage/records/sealing.h"
#include "storage/records/session_summary.h"
#include "storage/records/session_tables.h"
#include "storage/records/statement_rows.h"

namespace cusp::storage {
namespace {

void insert_version(Merge& merge, const Uuid& id) {
  // Another version may have the number here: this one then takes the next.
  merge.transaction.run(
      "INSERT INTO main.scenario_versions SELECT id, scenario, iif(EXISTS (SELECT 1 FROM main.scenario_versions o WHERE o.scenario = s.scenario "
      "AND o.number = s.number), (SELECT max(number) + 1 FROM main.scenario_versions o WHERE o.scenario = s.scenario), number), key, title, json, "
      "content_hash, author, published_at, sequence FROM source.scenario_versions s WHERE id = ?1",
      id);
  merge.transaction.run("INSERT INTO main.version_files SELECT * FROM source.version_files WHERE version = ?1", id);
  log_row(merge.context, merge.transaction, merge.actor.id, "version_sealed", SealedTable::scenario_versions, id);
  if (merge.referred.contains(id)) {
    refer(merge, id);
  } else {
    ++merge.out.counts.versions;
  }
}

struct HeadInFile {
  SessionId session;
  ChainHead head;
};

struct HeadHere {
  ChainHead head;
  Hash256 key;
};

/// Whether the chain in `links_of` holds `head`, so that the one chain continues the other.
bool holds_head(Merge& merge, const std::string& links_of, SessionId session, const ChainHead& head) {
  return merge.transaction
      .first("SELECT link = ?3 FROM " + links_of + ".session_chain WHERE session = ?1 AND position = ?2", [](Row row) { return row.flag(0); }, session,
             head.links - 1, head.link)
      .value_or(false);
}

/// Rows of the session that are not here yet, and its new head.
void add_rows(Merge& merge, SessionId session) {
  std::vector<std::pair<std::string, std::string>> tables;  // name, and the column that tells its rows apart
  for (const SessionTable table : kSessionTables) tables.emplace_back(name_of(table), "row");
  tables.front().second.clear();
  tables.emplace_back("session_chain", "position");
  for (const auto& [table, key] : tables) {
    const std::string owner = key.empty() ? "id" : "session";
    merge.transaction.run("INSERT INTO main." + table + " SELECT * FROM source." + table + " s WHERE s." + owner + " = ?1 AND NOT EXISTS (SELECT 1 FROM main." +
                              table + " m WHERE m." + owner + " = ?1" + (key.empty() ? "" : " AND m." + key + " = s." + key) + ")",
                          session);
  }
  merge.transaction.run(
      "INSERT INTO main.session_heads SELECT * FROM source.session_heads WHERE session = ?1 ON CONFLICT (session) DO UPDATE SET "
      "links = excluded.links, link = excluded.link, key = excluded.key, signature = excluded.signature",
      session);
}

/// A whole recording stays, or comes back. Without it the file's row stands for what the session's station has thinned: what
/// is here of the recording goes.
void settle_recording(Merge& merge, SessionId session) {
  const auto whole = merge.transaction.first(
      "SELECT (SELECT count(*) FROM main.session_chain WHERE session = ?1 AND table_number IN (3, 4)) = "
      "(SELECT count(*) FROM main.trace_chunks WHERE session = ?1) + (SELECT count(*) FROM main.key_states WHERE session = ?1)",
      [](Row row) { return row.flag(0); }, session);
  const auto thinned = merge.transaction.first("SELECT 1 FROM main.thinned_traces WHERE session = ?1", [](Row) { return true; }, session);
  if (!merge.ok()) return;
  if (*whole && thinned) {
    merge.transaction.run("DELETE FROM main.thinned_traces WHERE session = ?1", session);
    log_event(merge.context, merge.transaction, {.actor = merge.actor.id, .action = "trace_returned", .subject = session.uuid});
  }
  if (*whole) return;
  merge.transaction.run("DELETE FROM main.trace_chunks WHERE session = ?1", session);
  merge.transaction.run("DELETE FROM main.key_states WHERE session = ?1", session);
  if (thinned) return;
  merge.transaction.run("INSERT INTO main.thinned_traces SELECT * FROM source.thinned_traces WHERE session = ?1", session);
  log_row(merge.context, merge.transaction, merge.actor.id, "thinning_sealed", SealedTable::thinned_traces, session.uuid);
}

/// Whether the file has a recording that is thinned here.
bool returns_recording(Merge& merge, SessionId session) {
  return merge.transaction
      .first("SELECT EXISTS (SELECT 1 FROM main.thinned_traces WHERE session = ?1) AND NOT EXISTS (SELECT 1 FROM source.thinned_traces WHERE session = ?1)",
             [](Row row) { return row.flag(0); }, session)
      .value_or(false);
}

enum class SessionRows : std::uint8_t { all, further };

void add_session(Merge& merge, SessionId session, SessionRows rows) {
  const auto proof = verify_session(merge.from, session);
  if (!proof) return merge.transaction.refuse(proof.error());
  if (!proof->intact()) return merge.refuse(StorageError::differs, "sessions", session.text());
  add_rows(merge, session);
  settle_recording(merge, session);
  if (rows == SessionRows::all) add_summary(merge.transaction, session);
  const auto elapsed = merge.transaction.first("SELECT elapsed_us FROM main.metrics WHERE session = ?1 ORDER BY row DESC LIMIT 1",
                                               [](Row row) { return row.u64(0); }, session);
  follow_second(merge.transaction, session, elapsed.value_or(0));
  static_cast<void>(follow_result(merge.transaction, session));
  merge.changed.insert(session);
  log_session(merge.context, merge.transaction, merge.actor.id, session, "read_in");
  ++merge.out.counts.sessions;
  if (rows == SessionRows::further) ++merge.out.grown;
}

/// The rows of the recording, if the file has them all.
void return_recording(Merge& merge, SessionId session) {
  const auto proof = verify_session(merge.from, session);
  if (!proof) return merge.transaction.refuse(proof.error());
  if (!proof->intact()) return merge.refuse(StorageError::differs, "sessions", session.text());
  merge.transaction.run("INSERT INTO main.trace_chunks SELECT * FROM source.trace_chunks WHERE session = ?1", session);
  merge.transaction.run("INSERT INTO main.key_states SELECT * FROM source.key_states WHERE session = ?1", session);
  settle_recording(merge, session);
}

/// A station that was put back went on from its old copy and has a new key since: what is here stays. Under one key the file is refused.
void leave_apart(Merge& merge, SessionId session, const HeadHere& here) {
  if (here.key == merge.out.key) return merge.refuse(StorageError::differs, "sessions", session.text());
  merge.out.apart.push_back(session);
}

void merge_session(Merge& merge, const HeadInFile& theirs) {
  const auto station = merge.transaction.first("SELECT station FROM source.sessions WHERE id = ?1", [](Row row) { return row.uuid(0); }, theirs.session);
  if (!station || *station != merge.out.description.station) return merge.refuse(StorageError::differs, "sessions", theirs.session.text());
  const auto here = merge.transaction.first("SELECT links, link, key FROM main.session_heads WHERE session = ?1",
                                            [](Row row) { return HeadHere{{row.u64(0), row.hash(1)}, row.hash(2)}; }, theirs.session);
  if (!merge.ok()) return;
  if (!here) return add_session(merge, theirs.session, SessionRows::all);
  if (here->head.links >= theirs.head.links) {
    if (!holds_head(merge, "main", theirs.session, theirs.head)) return leave_apart(merge, theirs.session, *here);
    if (merge.ok() && returns_recording(merge, theirs.session)) return_recording(merge, theirs.session);
    return;
  }
  if (!holds_head(merge, "source", theirs.session, here->head)) return leave_apart(merge, theirs.session, *here);
  add_session(merge, theirs.session, SessionRows::further);
}

struct StatementInFile {
  Uuid id;
  SessionId session;
  std::optional<Uuid> withdraws;
};

/// The student of a statement's session, and whether the file has its text.
struct TextOf {
  UserId student;
  bool expected = false, there = false;
};

/// The text comes with its statement, unless somebody has erased it: here with the student, or there before.
void add_text(Merge& merge, const StatementInFile& statement) {
  const auto text = merge.transaction.first(
      "SELECT x.student, s.text_hash IS NOT NULL, t.statement IS NOT NULL FROM source.statements s JOIN main.sessions x ON x.id = s.session "
      "LEFT JOIN source.statement_texts t ON t.statement = s.id WHERE s.id = ?1",
      [](Row row) { return TextOf{row.id<UserId>(0), row.flag(1), row.flag(2)}; }, statement.id);
  if (!text || !text->expected) return;
  if (text->there && !is_erased(merge.transaction, text->student)) {
    merge.transaction.run("INSERT INTO main.statement_texts SELECT * FROM source.statement_texts WHERE statement = ?1", statement.id);
  } else {
    log_event(merge.context, merge.transaction, {.actor = merge.actor.id, .action = "statement_erased", .subject = statement.id});
  }
}

/// False if it is here already, waits for its session, or speaks of one that stays apart.
bool merge_statement(Merge& merge, const StatementInFile& statement) {
  if (std::ranges::find(merge.out.apart, statement.session) != merge.out.apart.end()) return false;
  const auto here = merge.taken(row_seals(merge.db(), SealedTable::statements, statement.id));
  const auto there = merge.taken(row_seals(merge.from.db, SealedTable::statements, statement.id));
  if (!merge.ok()) return false;
  if (!here.empty()) {
    if (there.empty() || here.front().seal != there.front().seal) merge.refuse(StorageError::differs, "statements", statement.id.text());
    return false;
  }
  const auto has = [&](const char* sql, const Uuid& id) { return merge.transaction.first(sql, [](Row) { return true; }, id).value_or(false); };
  const bool known = has("SELECT 1 FROM main.session_heads WHERE session = ?1", statement.session.uuid) &&
                     (!statement.withdraws || has("SELECT 1 FROM main.statements WHERE id = ?1", *statement.withdraws));
  if (!known) {
    ++merge.out.waiting;
    return false;
  }
  merge.transaction.run("INSERT INTO main.statements SELECT * FROM source.statements WHERE id = ?1", statement.id);
  add_text(merge, statement);
  log_row(merge.context, merge.transaction, merge.actor.id, "statement_sealed", SealedTable::statements, statement.id);
  ++merge.out.counts.statements;
  return true;
}

}  // namespace

void merge_versions(Merge& merge) {
  struct Version {
    Uuid id, scenario;
    Hash256 content, json;
  };
  const auto version_of = [](Row row) { return Version{row.uuid(0), row.uuid(1), row.hash(2), blake2b_256(row.bytes(3))}; };
  merge.transaction.run("INSERT INTO main.blobs SELECT * FROM source.blobs WHERE hash NOT IN (SELECT hash FROM main.blobs)");
  for (const Version& theirs : merge.taken(merge.from.db.all("SELECT id, scenario, content_hash, json FROM scenario_versions ORDER BY number", version_of))) {
    const auto here = merge.transaction.first("SELECT id, scenario, content_hash, json FROM main.scenario_versions WHERE id = ?1", version_of, theirs.id);
    if (!merge.ok()) return;
    if (!here) {
      insert_version(merge, theirs.id);
    } else if (here->scenario != theirs.scenario || here->content != theirs.content || here->json != theirs.json) {
      merge.refuse(StorageError::differs, "scenario_versions", theirs.id.text());
    } else if (!merge.referred.contains(theirs.id)) {
      arrive(merge, theirs.id);
    }
  }
}

namespace {

/// Of two withdrawals each station keeps its own; a cohort's name may be taken here.
bool may_differ(SealedTable table) {
  return table == SealedTable::version_withdrawals || table == SealedTable::assignment_withdrawals || table == SealedTable::cohorts;
}

/// Nobody can rename a cohort: if another one has its name here, the end of its id follows the name.
std::string columns_to_insert(SealedTable table) {
  if (table != SealedTable::cohorts) return "*";
  return "id, iif(name IN (SELECT name FROM main.cohorts), name || ' ' || substr(hex(id), 25), name), created_at";
}

}  // namespace

void merge_rows(Merge& merge, SealedTable table, const char* action) {
  for (const RowSeal& theirs : merge.taken(row_seals(merge.from.db, table))) {
    if (!merge.ok()) return;
    const auto here = merge.taken(row_seals(merge.db(), table, theirs.subject));
    if (!here.empty() && here.front().seal != theirs.seal && !may_differ(table)) return merge.refuse(StorageError::differs, std::string(name_of(table)), theirs.subject.text());
    const bool referred = merge.referred.contains(theirs.subject);
    if (!here.empty()) {
      if (!referred) arrive(merge, theirs.subject);
      continue;
    }
    const std::string name(name_of(table));
    merge.transaction.run("INSERT INTO main." + name + " SELECT " + columns_to_insert(table) + " FROM source." + name + " WHERE " + std::string(key_column(table)) + " = ?1", theirs.subject);
    log_row(merge.context, merge.transaction, merge.actor.id, action, table, theirs.subject);
    if (table != SealedTable::assignments) continue;
    if (referred) {
      refer(merge, theirs.subject);
    } else {
      ++merge.out.counts.assignments;
    }
  }
}

void merge_sessions(Merge& merge) {
  const auto heads = merge.taken(merge.from.db.all("SELECT session, links, link FROM session_heads ORDER BY session", [](Row row) {
    return HeadInFile{row.id<SessionId>(0), {row.u64(1), row.hash(2)}};
  }));
  merge.steps.begin(heads.size());
  for (const HeadInFile& head : heads) {
    if (!merge.goes_on()) return;
    merge_session(merge, head);
    merge.steps.add_done();
  }
  const auto comments = merge.taken(merge.from.db.all("SELECT c.id, s.student FROM comments c JOIN sessions s ON s.id = c.session",
                                                      [](Row row) { return std::pair{row.uuid(0), row.id<UserId>(1)}; }));
  for (const auto& [comment, student] : comments) {
    const auto here = merge.transaction.first("SELECT 1 FROM main.comments WHERE id = ?1", [](Row) { return true; }, comment);
    if (here || is_erased(merge.transaction, student)) continue;
    merge.transaction.run("INSERT INTO main.comments SELECT * FROM source.comments WHERE id = ?1", comment);
    log_row(merge.context, merge.transaction, merge.actor.id, "comment_sealed", SealedTable::comments, comment);
  }
}

void merge_statements(Merge& merge) {
  const auto statements = merge.taken(merge.from.db.all(
      "SELECT id, session, withdraws FROM statements WHERE station = ?1 ORDER BY sequence, id",
      [](Row row) {
        StatementInFile out{row.uuid(0), row.id<SessionId>(1), {}};
        if (!row.is_null(2)) out.withdraws = row.uuid(2);
        return out;
      },
      merge.out.description.station));
  std::set<SessionId> stated;
  for (const StatementInFile& statement : statements) {
    if (!merge.goes_on()) return;
    if (merge_statement(merge, statement)) stated.insert(statement.session);
  }
  // An older program put statements of several stations in another order: their results may differ from what it wrote.
  const auto of_several = merge.taken(merge.db().all(
      "SELECT DISTINCT m.session FROM source.statements s JOIN main.statements m INDEXED BY statements_of_session ON m.session = s.session "
      "WHERE m.station <> s.station",
      [](Row row) { return row.id<SessionId>(0); }));
  stated.insert(of_several.begin(), of_several.end());
  for (const SessionId session : stated) {
    if (follow_result(merge.transaction, session)) merge.changed.insert(session);
  }
}

}  // namespace cusp::storage
