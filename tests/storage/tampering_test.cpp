/// One small session, every byte of every row that is stored of it changed in turn: each change is found and named.
#include <gtest/gtest.h>

#include <bit>
#include <fstream>
#include <variant>

#include "storage/records/session_tables.h"
#include "storage/records/trace_codec.h"
#include "tests/modules.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

struct Text {
  std::vector<std::byte> bytes;
};
using Value = std::variant<std::nullptr_t, std::int64_t, double, Text, std::vector<std::byte>>;

struct Cell {
  std::string table, key_column, column;  // key_column: the one that numbers rows; empty when a session has one
  std::int64_t row = 0;
  Value value;
};

class TamperingTest : public ::testing::Test {
 protected:
  void SetUp() override {
    student = make_student(*store);
    version = keep(*store);
    session = complete_session(*store, student, version);
    ASSERT_TRUE(must(verify_session(store->context(), session)).intact());
    must(db().run("PRAGMA foreign_keys = OFF"));
    must(db().run("PRAGMA ignore_check_constraints = ON"));
  }
  Database& db() { return store->database(); }

  std::vector<Cell> cells_of(const std::string& table, const std::string& session_column,
                             const std::string& key_column) {
    std::vector<Cell> cells;
    const auto columns =
        must(db().all("SELECT name FROM pragma_table_info(?1)", [](Row row) { return row.text(0); }, table));
    for (const std::string& column : columns) {
      const std::string key = key_column.empty() ? "0" : key_column;
      const auto found = must(db().all(
          "SELECT " + key + ", " + column + ", typeof(" + column + ") FROM " + table + " WHERE " + session_column +
              " = ?1 ORDER BY 1",
          [&](Row row) {
            Cell cell{table, key_column, column, row.integer(0), nullptr};
            const std::string type = row.text(2);
            if (type == "integer") cell.value = row.integer(1);
            if (type == "real") cell.value = row.real(1);
            if (type == "text") cell.value = Text{row.blob(1)};
            if (type == "blob") cell.value = row.blob(1);
            return cell;
          },
          session));
      cells.insert(cells.end(), found.begin(), found.end());
    }
    return cells;
  }

  /// Makes the change, verifies, takes it back. nullopt when SQLite itself would not have it.
  template <class Changed>
  std::optional<Verification> verified_with(const Cell& cell, const std::string& session_column, const char* as,
                                            const Changed& changed) {
    must(db().run("BEGIN"));
    const std::string where =
        " WHERE " + session_column + " = ?2" + (cell.key_column.empty() ? "" : " AND " + cell.key_column + " = ?3");
    const std::string sql = "UPDATE " + cell.table + " SET " + cell.column + " = " + as + where;
    const auto done =
        cell.key_column.empty() ? db().run(sql, changed, session) : db().run(sql, changed, session, cell.row);
    std::optional<Verification> result;
    if (done) {
      EXPECT_EQ(db().changes(), 1);
      result = must(verify_session(store->context(), session));
    }
    must(db().run("ROLLBACK"));
    return result;
  }

  void expect_named(const std::optional<Verification>& result, const Cell& cell, const std::string& what) {
    if (!result) return;
    ++changes_;
    const std::string place = cell.table + "." + cell.column + " row " + std::to_string(cell.row) + " " + what;
    ASSERT_FALSE(result->intact()) << place;
    EXPECT_EQ(result->findings.front().table, cell.table) << place;
    if (cell.column == cell.key_column) return;  // a changed row number: one missing here, one too many there
    EXPECT_EQ(result->findings.size(), 1u) << place;
    if (!cell.key_column.empty()) {
      EXPECT_EQ(result->findings.front().row, cell.row) << place;
    }
    if (cell.table == "trace_chunks") {
      EXPECT_EQ(result->findings.front().second, cell.row) << place;  // chunks of one second each
    }
  }
  void change_every_byte(const std::string& table, const std::string& session_column, const std::string& key_column) {
    const auto cells = cells_of(table, session_column, key_column);
    ASSERT_FALSE(cells.empty()) << table;
    for (const Cell& cell : cells) {
      if (std::holds_alternative<std::nullptr_t>(cell.value)) {
        expect_named(verified_with(cell, session_column, "CAST(?1 AS TEXT)", std::string("x")), cell, "null");
        expect_named(verified_with(cell, session_column, "?1", std::int64_t{1}), cell, "null");
      } else if (const auto* number = std::get_if<std::int64_t>(&cell.value)) {
        for (int byte = 0; byte < 8; ++byte) {
          const auto changed =
              static_cast<std::int64_t>(static_cast<std::uint64_t>(*number) ^ std::uint64_t{1} << (8 * byte));
          expect_named(verified_with(cell, session_column, "?1", changed), cell, "byte " + std::to_string(byte));
        }
      } else if (const auto* real = std::get_if<double>(&cell.value)) {
        for (int byte = 0; byte < 8; ++byte) {
          const auto changed =
              std::bit_cast<double>(std::bit_cast<std::uint64_t>(*real) ^ std::uint64_t{1} << (8 * byte));
          expect_named(verified_with(cell, session_column, "?1", changed), cell, "byte " + std::to_string(byte));
        }
      } else {
        const auto* text = std::get_if<Text>(&cell.value);
        const auto& bytes = text != nullptr ? text->bytes : std::get<std::vector<std::byte>>(cell.value);
        for (std::size_t i = 0; i < bytes.size(); ++i) {
          auto changed = bytes;
          changed[i] ^= std::byte{1};
          expect_named(verified_with(cell, session_column, text != nullptr ? "CAST(?1 AS TEXT)" : "?1", changed), cell,
                       "byte " + std::to_string(i));
        }
      }
    }
  }

  Folder folder;
  std::unique_ptr<Store> store = open(folder / "a.db");
  Account student;
  ScenarioVersion version;
  SessionId session;
  int changes_ = 0;
};

TEST_F(TamperingTest, one_byte_changed_in_any_row_of_a_session_is_found_and_named) {
  add_old_grade(*store, session, small_grade());
  for (const SessionTable table : kSessionTables) {
    const bool own = table == SessionTable::sessions;
    change_every_byte(std::string(name_of(table)), own ? "id" : "session", own ? "" : "row");
  }
  RecordProperty("changes", changes_);
  EXPECT_GT(changes_, 2000);
}

TEST_F(TamperingTest, one_byte_changed_in_the_chain_or_its_head_is_found_and_named) {
  change_every_byte("session_chain", "session", "position");
  change_every_byte("session_heads", "session", "");
  RecordProperty("changes", changes_);
  EXPECT_GT(changes_, 1000);
}

TEST_F(TamperingTest, the_columns_of_the_chain_are_all_the_columns_there_are) {
  for (const SessionTable table : kSessionTables) {
    const auto there =
        must(db().all("SELECT name FROM pragma_table_info(?1)", [](Row row) { return row.text(0); }, name_of(table)));
    const std::string covered = select_row(table);
    for (const std::string& column : there) {
      EXPECT_TRUE(covered.find(" " + column + ",") != std::string::npos ||
                  covered.find(" " + column + " FROM") != std::string::npos)
          << name_of(table) << "." << column;
    }
  }
}

TEST_F(TamperingTest, a_row_taken_out_is_missing) {
  add_old_grade(*store, session, small_grade());
  for (const SessionTable table : kSessionTables) {
    const bool own = table == SessionTable::sessions;
    must(db().run("BEGIN"));
    must(db().run(
        "DELETE FROM " + std::string(name_of(table)) + (own ? " WHERE id = ?1" : " WHERE session = ?1 AND row = 0"),
        session));
    const auto result = must(verify_session(store->context(), session));
    must(db().run("ROLLBACK"));
    ASSERT_FALSE(result.intact()) << name_of(table);
    EXPECT_EQ(result.findings[0].code, FindingCode::row_missing);
    EXPECT_EQ(result.findings[0].table, name_of(table));
    EXPECT_EQ(result.findings[0].row, 0);
  }
}

TEST_F(TamperingTest, a_row_slipped_in_is_one_too_many) {
  must(
      db().run("INSERT INTO grades SELECT session, 1, at, sequence, grader, 100, score_max, pass_mark, 1, critical, "
               "rubric_hash, evaluator, engine_version, device_class, calibration FROM grades WHERE session = ?1",
               session));
  const auto result = must(verify_session(store->context(), session));
  ASSERT_EQ(result.findings.size(), 1u);
  EXPECT_EQ(result.findings[0].code, FindingCode::row_added);
  EXPECT_EQ(result.findings[0].table, "grades");
  EXPECT_EQ(result.findings[0].row, 1);
}

TEST_F(TamperingTest, a_tail_cut_off_with_its_links_shows_against_the_signed_head) {
  // The grade and its event taken out cleanly, links and all.
  must(
      db().run("DELETE FROM session_chain WHERE session = ?1 AND position >= (SELECT min(position) FROM session_chain "
               "WHERE session = ?1 AND table_number = 8)",
               session));
  must(db().run("DELETE FROM grades WHERE session = ?1", session));
  must(db().run("DELETE FROM graded_criteria WHERE session = ?1", session));
  must(db().run("DELETE FROM session_events WHERE session = ?1 AND kind = 'graded'", session));
  const auto result = must(verify_session(store->context(), session));
  ASSERT_EQ(result.findings.size(), 1u);
  EXPECT_EQ(result.findings[0].code, FindingCode::row_missing);
  EXPECT_EQ(result.findings[0].table, "session_chain");
}

TEST_F(TamperingTest, a_chain_reckoned_anew_shows_for_want_of_the_stations_key) {
  must(db().run("UPDATE grades SET score = 100 WHERE session = ?1", session));
  // As a forger would: every link again, from the changed row on, and a head with a key of the forger's own.
  const Hash256 content =
      *must(db().first(select_row(SessionTable::grades), [](Row row) { return row.content_hash(); }, session, 0));
  must(db().run("UPDATE session_chain SET content = ?2 WHERE session = ?1 AND table_number = 8", session, content));
  const auto links = must(db().all(
      "SELECT position, table_number, row, second, content FROM session_chain WHERE session = ?1 ORDER BY position",
      [](Row row) { return ChainLink{row.u64(0), row.u64(1), row.u64(2), row.integer(3), row.hash(4)}; }, session));
  Hash256 link = chain_start(session.uuid);
  for (const ChainLink& entry : links) {
    link = chain_link(link, session.uuid, entry);
    must(db().run("UPDATE session_chain SET link = ?3 WHERE session = ?1 AND position = ?2", session, entry.position,
                  link));
  }
  const StationKey forged = StationKey::make();
  must(db().run("UPDATE session_heads SET link = ?2, signature = ?3 WHERE session = ?1", session, link,
                forged.sign_head(session.uuid, {links.size(), link})));
  const auto result = must(verify_session(store->context(), session));
  ASSERT_EQ(result.findings.size(), 1u);
  EXPECT_EQ(result.findings[0].code, FindingCode::head_broken);
}

TEST_F(TamperingTest, the_stations_key_and_the_scenario_are_found_changed_too) {
  const auto first_of = [&](const std::string& sql) {
    must(db().run("BEGIN"));
    must(db().run(sql));
    const auto result = must(verify_session(store->context(), session));
    must(db().run("ROLLBACK"));
    return result.intact() ? std::string("intact") : result.findings[0].table;
  };
  EXPECT_EQ(first_of("UPDATE station_keys SET public_key = zeroblob(32)"), "station_keys");
  EXPECT_EQ(first_of("UPDATE station_keys SET id = zeroblob(32)"), "station_keys");
  EXPECT_EQ(first_of("UPDATE scenario_versions SET json = json || ' '"), "scenario_versions");
  EXPECT_EQ(first_of("UPDATE scenario_versions SET content_hash = zeroblob(32)"), "scenario_versions");
  EXPECT_EQ(first_of("DELETE FROM scenario_versions"), "scenario_versions");
  // Names are nobody's business here.
  EXPECT_EQ(first_of("UPDATE people SET name = 'Somebody', number = 'else'"), "intact");
}

TEST_F(TamperingTest, a_changed_specimen_is_found) {
  const std::vector<std::byte> voxels(5000, std::byte{9});
  NewSession wanted = new_session(student, version);
  wanted.header.specimen_blob = must(store->blobs.put(voxels));
  const SessionId id = must(store->sessions.start(student.actor(), wanted)).id;
  EXPECT_TRUE(must(verify_session(store->context(), id)).intact());
  auto packed = *must(db().first("SELECT packed FROM blobs", [](Row row) { return row.blob(0); }));
  packed[packed.size() / 2] ^= std::byte{1};
  must(db().run("UPDATE blobs SET packed = ?1", packed));
  EXPECT_EQ(must(verify_session(store->context(), id)).findings.at(0).table, "blobs");
}

TEST_F(TamperingTest, a_byte_changed_in_the_file_itself_is_found_and_named) {
  auto trace = *must(db().first(
      "SELECT trace FROM trace_chunks WHERE session = ?1 AND row = 1", [](Row row) { return row.blob(0); }, session));
  must(db().run("PRAGMA wal_checkpoint(TRUNCATE)"));
  store.reset();
  std::string content;
  {
    std::ifstream in(folder / "a.db", std::ios::binary);
    content.assign(std::istreambuf_iterator<char>(in), {});
  }
  const auto at = content.find(std::string(reinterpret_cast<const char*>(trace.data()), trace.size()));
  ASSERT_NE(at, std::string::npos);
  for (std::size_t i = 0; i < trace.size(); i += 7) {
    auto changed = content;
    changed[at + i] = static_cast<char>(changed[at + i] ^ 0x40);
    std::ofstream(folder / "a.db", std::ios::binary) << changed;
    StoreOptions reading = quick();
    reading.database.access = DatabaseOptions::Access::read_only;
    const auto again = open(folder / "a.db", reading);
    const auto result = must(verify_session(again->context(), session));
    ASSERT_EQ(result.findings.size(), 1u) << i;
    EXPECT_EQ(result.findings[0].code, FindingCode::row_changed);
    EXPECT_EQ(result.findings[0].table, "trace_chunks");
    EXPECT_EQ(result.findings[0].row, 1);
    EXPECT_EQ(result.findings[0].second, 1);
  }
}

TEST_F(TamperingTest, a_changed_or_missing_line_of_the_audit_log_is_found) {
  const auto first_of = [&](const std::string& sql) {
    must(db().run("BEGIN"));
    must(db().run(sql));
    const auto result = must(verify_audit_log(store->context()));
    must(db().run("ROLLBACK"));
    return result.intact() ? ChainFinding{FindingCode::row_added, "intact"} : result.findings[0];
  };
  ASSERT_TRUE(must(verify_audit_log(store->context())).intact());
  EXPECT_EQ(first_of("UPDATE audit_log SET action = 'nothing' WHERE number = 1").row, 1);
  EXPECT_EQ(first_of("UPDATE audit_log SET link = zeroblob(32) WHERE number = 1").row, 1);
  EXPECT_EQ(first_of("DELETE FROM audit_log WHERE number = 0").code, FindingCode::row_missing);
  EXPECT_EQ(first_of("DELETE FROM audit_log WHERE number = (SELECT max(number) FROM audit_log)").table, "audit_head");
  EXPECT_EQ(first_of("DELETE FROM audit_head").table, "audit_head");
  EXPECT_EQ(first_of("UPDATE audit_head SET signature = zeroblob(64)").table, "audit_head");
}

TEST_F(TamperingTest, every_session_that_any_table_mentions_is_verified) {
  EXPECT_EQ(must(sessions_to_verify(store->context())), std::vector{session});
  must(db().run("DELETE FROM sessions"));
  EXPECT_EQ(must(sessions_to_verify(store->context())), std::vector{session});
}

TEST_F(TamperingTest, a_header_that_was_changed_or_lost_is_named) {
  const std::vector<std::byte> forged(90, std::byte{8});
  for (const char* sql : {"UPDATE blobs SET packed = ?1", "DELETE FROM blobs WHERE packed <> ?1"}) {
    must(db().run("BEGIN"));
    must(db().run(sql, pack(forged)));
    const auto result = must(verify_session(store->context(), session));
    EXPECT_EQ(code_of(store->sessions.find(session)), StorageError::corrupt);
    must(db().run("ROLLBACK"));
    ASSERT_EQ(result.findings.size(), 1u) << sql;
    EXPECT_EQ(result.findings[0].table, "blobs");
  }
}

}  // namespace
}  // namespace cusp::test
