#include "tests/storage/tamperings.h"

#include <algorithm>
#include <fstream>
#include <map>

#include "storage/records/session_tables.h"
#include "storage/records/trace_codec.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names(Database& db, const std::string& sql, const std::string& table = {}) {
  return must(db.all(
      sql, [](Row row) { return row.text(0); }, table));
}
std::vector<std::string> tables(Database& db) {
  return must(
      db.all("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name", [](Row row) { return row.text(0); }));
}
std::string joined(const std::vector<std::string>& some) {
  std::string out;
  for (const std::string& s : some) out += (out.empty() ? "" : ", ") + s;
  return out;
}
std::vector<std::string> key_columns(Database& db, const std::string& table) {
  return names(db, "SELECT name FROM pragma_table_info(?1) WHERE pk > 0 ORDER BY pk", table);
}

/// Whose row it is, as the verifier would name it.
Uuid owner_of(Database& db, const std::string& table, const std::string& row) {
  static const std::map<std::string, std::string> columns = {{"people", "id"},
                                                             {"cohorts", "id"},
                                                             {"cohort_students", "cohort"},
                                                             {"scenario_versions", "id"},
                                                             {"comments", "session"},
                                                             {"version_files", "version"},
                                                             {"assignments", "id"},
                                                             {"statements", "id"},
                                                             {"assessments", "assignment"},
                                                             {"version_withdrawals", "version"},
                                                             {"assignment_withdrawals", "assignment"},
                                                             {"adjustments", "id"},
                                                             {"sessions", "id"},
                                                             {"thinned_traces", "session"}};
  const auto special = columns.find(table);
  std::string column = special == columns.end() ? "" : special->second;
  for (const std::string& name : key_columns(db, table)) {
    if (name == "session") column = name;
  }
  if (column.empty()) return {};
  return must(db.first("SELECT " + column + " FROM " + table + " WHERE " + row, [](Row r) { return r.uuid(0); }))
      .value_or(Uuid{});
}
std::vector<std::string> named_as(const std::string& table) {
  if (table == "version_files") return {"scenario_versions", "blobs"};
  if (table == "audit_head") return {"audit_log"};
  return {};
}

void run_all(Database& db, const std::vector<std::string>& statements) {
  for (const std::string& sql : statements) must(db.run(sql));
}
enum class Comments : std::uint8_t { keep, remove };

void delete_session(Database& db, SessionId id, Comments comments) {
  for (const std::string& table : tables(db)) {
    if (table == "comments" && comments == Comments::keep) continue;
    for (const std::string& column : names(db, "SELECT name FROM pragma_table_info(?1)", table)) {
      if (column == "session" || (table == "sessions" && column == "id")) {
        must(db.run("DELETE FROM " + table + " WHERE " + column + " = ?1", id));
      }
    }
  }
}

}  // namespace

/// "(key) = (SELECT key ... one row)": the same row whenever it is asked, until it is changed.
std::string Tamperer::one_row(Database& db, const std::string& table) {
  const auto rows = must(db.first("SELECT count(*) FROM " + table, [](Row row) { return row.u64(0); }));
  const std::string keys = joined(key_columns(db, table));
  return "(" + keys + ") = (SELECT " + keys + " FROM " + table + " ORDER BY " + keys + " LIMIT 1 OFFSET " +
         std::to_string(draw(*rows)) + ")";
}

std::optional<Tampering> Tamperer::change(Database& db, const std::string& table) {
  const auto columns = names(db, "SELECT name FROM pragma_table_info(?1)", table);
  const std::string column = one_of(columns), row = one_row(db, table);
  Tampering t{table, "change", column, owner_of(db, table, row), named_as(table)};
  const bool open_account = table == "people" && t.owner == school_.open_account.uuid;
  if (open_account && (column == "number" || column == "name")) t.kind = "change open account";
  const auto is_key = key_columns(db, table);
  if (std::ranges::find(is_key, column) != is_key.end()) t.owner = {};
  const auto old = must(db.first(
      "SELECT typeof(" + column + "), " + column + ", (SELECT type FROM pragma_table_info(?1) WHERE name = ?2) FROM " +
          table + " WHERE " + row,
      [](Row r) {
        return std::tuple{r.text(0), r.blob(1), r.text(2)};
      },
      table, column));
  if (!old) return std::nullopt;
  const auto& [type, bytes, declared] = *old;
  const std::string set = "UPDATE " + table + " SET " + column + " = ";
  Stored<void> done;
  if (type == "integer" || type == "real") {
    done = db.run(set + column + " + " + std::to_string(1 + draw(9)) + " WHERE " + row);
  } else if (type == "text") {
    done = db.run(set + column + " || 'x' WHERE " + row);
  } else if (type == "blob" && !bytes.empty()) {
    auto changed = bytes;
    changed[draw(changed.size())] ^= static_cast<std::byte>(1 << draw(8));
    done = db.run(set + "?1 WHERE " + row, changed);
  } else {
    const char* value = declared == "TEXT" ? "'x'" : declared == "BLOB" ? "x'00'" : "1";
    done = db.run(set + value + " WHERE " + row);
  }
  if (!done || db.changes() != 1) return std::nullopt;
  return t;
}

std::optional<Tampering> Tamperer::remove(Database& db, const std::string& table) {
  const std::string row = one_row(db, table);
  Tampering t{table, "delete", "", owner_of(db, table, row), named_as(table)};
  if (table == "blobs") {
    const auto used =
        must(db.first("SELECT hash IN (SELECT specimen_blob FROM sessions UNION SELECT blob FROM "
                      "version_files) OR lower(hex(hash)) IN (SELECT header FROM sessions) FROM blobs WHERE " +
                          row,
                      [](Row r) { return r.flag(0); }));
    if (!used.value_or(true)) t.kind = "delete unnamed";
  }
  if (!db.run("DELETE FROM " + table + " WHERE " + row) || db.changes() != 1) return std::nullopt;
  return t;
}

/// A copy of a row under a key of its own, as a forger would slip one in.
std::optional<Tampering> Tamperer::insert(Database& db, const std::string& table) {
  const std::string row = one_row(db, table);
  const auto columns = names(db, "SELECT name FROM pragma_table_info(?1)", table);
  const auto keys = key_columns(db, table);
  std::string values;
  for (const std::string& column : columns) {
    const bool fresh = column == keys.back() || column == "number" || (table == "cohorts" && column == "name") ||
                       (table == "other_keys" && column == "key");
    const auto type = must(
        db.first("SELECT typeof(" + column + ") FROM " + table + " WHERE " + row, [](Row r) { return r.text(0); }));
    std::string value = column;
    if (fresh && *type == "integer") value = column + " + 1000";
    if (fresh && *type == "text") value = column + " || '-2'";
    if (fresh && *type == "blob") value = "CAST(x'7f' || substr(" + column + ", 2) AS BLOB)";
    values += (values.empty() ? "" : ", ") + value;
  }
  Tampering t{table, "insert", "", {}, named_as(table)};
  if (!db.run("INSERT INTO " + table + " SELECT " + values + " FROM " + table + " WHERE " + row)) return std::nullopt;
  return db.changes() == 1 ? std::optional{t} : std::nullopt;
}

Tamperer::Act Tamperer::on_account(std::string kind, std::string set, std::string where) {
  return [=, this](Database& db) -> std::optional<Tampering> {
    const auto who = must(db.all("SELECT id FROM people WHERE guest = 0 AND (password <> '' OR pin <> '') AND " + where,
                                 [](Row row) { return row.uuid(0); }));
    const Uuid id = one_of(who);
    must(db.run("UPDATE people SET " + set + " WHERE id = ?1", id));
    return Tampering{"people", kind, "", id, {}};
  };
}
Tamperer::Act Tamperer::on_counter(std::string kind, DatabaseFile file, std::function<void(const fs::path&)> act) {
  return [=, this](Database&) -> std::optional<Tampering> {
    after_closing_ = [=, this] {
      if (file == DatabaseFile::older) fs::copy_file(school_.old(), school_.trial(), fs::copy_options::overwrite_existing);
      act(school_.trial().string() + ".key-counter");
    };
    return Tampering{"counter", kind, "", {}, {"audit_log"}};
  };
}

std::vector<Tamperer::Act> Tamperer::session_acts() {
  const auto whole = [this](Comments comments) {
    return [this, comments](Database& db) -> std::optional<Tampering> {
      const SessionId id = one_of(school_.sessions);
      delete_session(db, id, comments);
      return Tampering{"sessions", "delete whole session", "", id.uuid, {}};
    };
  };
  const auto back = [this](Database& db) -> std::optional<Tampering> {
    attach_old(db);
    const SessionId id = one_of(school_.in_old);
    delete_session(db, id, Comments::keep);
    for (const SessionTable table : kSessionTables) {
      const std::string name(name_of(table)), key = table == SessionTable::sessions ? "id" : "session";
      must(db.run("INSERT INTO main." + name + " SELECT * FROM old." + name + " WHERE " + key + " = ?1", id));
    }
    for (const char* name : {"session_chain", "session_heads"}) {
      must(db.run(std::string("INSERT INTO main.") + name + " SELECT * FROM old." + name + " WHERE session = ?1", id));
    }
    return Tampering{"sessions", "old rows, old head", "", id.uuid, {"session_chain"}};
  };
  return {
      whole(Comments::remove),
      whole(Comments::keep),
      back,
  };
}

std::vector<Tamperer::Act> Tamperer::log_acts() {
  const auto log = [this](std::string kind, std::vector<std::string> sql) {
    return [=, this](Database& db) -> std::optional<Tampering> {
      attach_old(db);
      run_all(db, sql);
      return Tampering{"audit_log", kind, "", {}, {"audit_head"}};
    };
  };
  return {
      log("log and head deleted", {"DELETE FROM audit_log", "DELETE FROM audit_head"}),
      log("log, head and keys deleted",
          {"DELETE FROM audit_log", "DELETE FROM audit_head", "DELETE FROM station_keys"}),
      log("tail cut", {"DELETE FROM audit_log WHERE number > 20"}),
      log("old log, old head", {"DELETE FROM audit_log", "INSERT INTO main.audit_log SELECT * FROM old.audit_log",
                                "UPDATE main.audit_head SET (entries, link, key, signature) = "
                                "(SELECT entries, link, key, signature FROM old.audit_head)"}),
      log("old head", {"UPDATE main.audit_head SET (entries, link, key, signature) = "
                       "(SELECT entries, link, key, signature FROM old.audit_head)"}),
  };
}

std::vector<Tamperer::Act> Tamperer::forged_acts() {
  const auto forged = [this](Database& db) -> std::optional<Tampering> {
    const StationKey key = StationKey::make();
    const SessionId id = one_of(school_.in_old);
    must(db.run("INSERT INTO station_keys VALUES (?1, ?2, 1)", key.id(), key.public_key));
    const auto head = *must(db.first(
        "SELECT links, link FROM session_heads WHERE session = ?1",
        [](Row row) {
          return std::pair{row.u64(0), row.hash(1)};
        },
        id));
    must(db.run("UPDATE session_heads SET key = ?2, signature = ?3 WHERE session = ?1", id, key.id(),
                key.sign_head(id.uuid, {head.first, head.second})));
    return Tampering{"station_keys", "forged key", "", {}, {}};
  };
  const auto schema = [](std::string sql, std::string kind) {
    return [=](Database& db) -> std::optional<Tampering> {
      must(db.run(sql));
      return Tampering{"sqlite_schema", kind, "", {}, {}};
    };
  };
  const auto unnamed_blob = [](Database& db) -> std::optional<Tampering> {
    const std::vector<std::byte> bytes(90, std::byte{8});
    must(db.run("INSERT INTO blobs VALUES (?1, ?2)", blake2b_256(bytes), pack(bytes)));
    return Tampering{"blobs", "insert unnamed", "", {}, {}};
  };
  return {
      forged,
      unnamed_blob,
      schema("CREATE TRIGGER good AFTER INSERT ON grades BEGIN UPDATE grades SET score = 100; END", "trigger"),
      schema("CREATE VIEW good AS SELECT * FROM grades", "view"),
  };
}

std::vector<Tamperer::Act> Tamperer::account_acts() {
  return {
      on_account("role set", "role = 'administrator', pin = ''", "role = 'student'"),
      on_account("role set", "role = 'student'", "role <> 'student'"),
      on_account("password emptied", "password = ''", "password <> ''"),
      on_account("PIN emptied", "pin = ''", "pin <> ''"),
      on_account("password of another", "password = (SELECT password FROM people WHERE number = 'admin')",
                "number <> 'admin'"),
      on_account("disabled", "disabled = 1", "role = 'student'"),
      on_account("made a guest", "guest = 1", "role = 'student'"),
      on_account("renamed", "number = number || '0', name = 'Somebody'", "role = 'student'"),
  };
}

/// A recording emptied without the program: alone, with a row of its forger, with the row of another attempt; and one that
/// was thinned, which is slipped in again without its row.
std::vector<Tamperer::Act> Tamperer::thinning_acts() {
  const auto emptied = [this](std::string kind, std::function<void(Database&, SessionId)> more) {
    return [=, this](Database& db) -> std::optional<Tampering> {
      const SessionId id = one_of(school_.in_old);
      must(db.run("DELETE FROM trace_chunks WHERE session = ?1", id));
      must(db.run("DELETE FROM key_states WHERE session = ?1", id));
      more(db, id);
      return Tampering{"trace_chunks", kind, "", id.uuid, {"thinned_traces"}};
    };
  };
  const auto forged = [](Database& db, SessionId id) {
    const StationKey key = StationKey::make();
    must(db.run("INSERT INTO station_keys VALUES (?1, ?2, 1)", key.id(), key.public_key));
    const Signature signature = key.sign(blake2b_256(std::string_view{"thinned"}));
    must(db.run("INSERT INTO thinned_traces SELECT h.session, (SELECT id FROM station), zeroblob(16), 1, h.links, h.link, ?2, ?3 "
                "FROM session_heads h WHERE h.session = ?1",
                id, key.id(), std::as_bytes(std::span(signature))));
  };
  const auto swapped = [](Database& db, SessionId id) { must(db.run("UPDATE thinned_traces SET session = ?1", id)); };
  const auto slipped_in = [](Database& db) -> std::optional<Tampering> {
    const auto id = *must(db.first("SELECT session FROM thinned_traces", [](Row row) { return row.id<SessionId>(0); }));
    must(db.run("INSERT INTO trace_chunks SELECT ?1, row, first_tick, inputs, elapsed_us, state_hash, trace FROM trace_chunks "
                "WHERE session = (SELECT session FROM trace_chunks LIMIT 1)",
                id));
    return Tampering{"thinned_traces", "recording slipped in", "", id.uuid, {}};
  };
  return {
      emptied("emptied", [](Database&, SessionId) {}),
      emptied("emptied, forged row", forged),
      emptied("emptied, row of another", swapped),
      slipped_in,
  };
}

std::vector<Tamperer::Act> Tamperer::counter_acts() {
  const auto put_old_counter = [this](const fs::path& counter) {
    fs::copy_file(school_.old().string() + ".key-counter", counter, fs::copy_options::overwrite_existing);
  };
  const auto leave = [](const fs::path&) {};
  const auto drop = [](const fs::path& counter) { fs::remove(counter); };
  const auto spoil = [](const fs::path& counter) { std::ofstream(counter) << "cusp-counter-1\nnothing"; };
  return {
      on_counter("older file", DatabaseFile::older, leave),
      on_counter("older file, no counter", DatabaseFile::older, drop),
      on_counter("no counter", DatabaseFile::newest, drop),
      on_counter("counter spoiled", DatabaseFile::newest, spoil),
      on_counter("older counter", DatabaseFile::newest, put_old_counter),
      on_counter("older file with its counter", DatabaseFile::older, put_old_counter),
  };
}

std::vector<Tamperer::Act> Tamperer::acts() {
  std::vector<Act> out;
  auto db = must(Database::open(school_.now(), {.access = DatabaseOptions::Access::existing}));
  for (const std::string& table : tables(db)) {
    out.push_back([=, this](Database& d) { return change(d, table); });
    out.push_back([=, this](Database& d) { return remove(d, table); });
    out.push_back([=, this](Database& d) { return insert(d, table); });
  }
  must(db.run("PRAGMA wal_checkpoint(TRUNCATE)"));
  for (auto more : {&Tamperer::session_acts, &Tamperer::log_acts, &Tamperer::forged_acts, &Tamperer::account_acts, &Tamperer::thinning_acts,
                    &Tamperer::counter_acts}) {
    for (Act& act : (this->*more)()) out.push_back(std::move(act));
  }
  return out;
}

/// Opens the file as a stranger, tampers, closes. Draws again where SQLite would not have it.
Tampering Tamperer::tamper(const Act& act) {
  while (true) {
    copy_school(school_.now(), school_.trial());
    after_closing_ = nullptr;
    std::optional<Tampering> done;
    {
      auto db = must(Database::open(school_.trial(), {.access = DatabaseOptions::Access::existing}));
      run_all(db, {"PRAGMA foreign_keys = OFF", "PRAGMA ignore_check_constraints = ON"});
      done = act(db);
      must(db.run("PRAGMA wal_checkpoint(TRUNCATE)"));
    }
    if (after_closing_) after_closing_();
    if (done) return *done;
  }
}

}  // namespace cusp::test
