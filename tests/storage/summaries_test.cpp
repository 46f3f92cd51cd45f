/// session_summaries follows the records: through every operation, a migration and a rebuild, and each column that differs
/// is named.
#include <gtest/gtest.h>

#include <map>

#include "storage/records/packed_attempts.h"
#include "storage/records/session_summary.h"
#include "tests/storage/school.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// The differences as "session kind column", one a line; empty if summaries and records agree.
std::string differences(Database& db) {
  std::string out;
  must(compare_summaries(db, [&](const SummaryDifference& d) {
    constexpr const char* kinds[] = {" missing ", " added ", " column "};
    out += d.session.text() + kinds[static_cast<int>(d.kind)] + std::string(d.column) + "\n";
  }));
  return out;
}

/// Rows of packed_attempts that are missing, added and changed, one letter each.
std::string packed_differences(Database& db) {
  std::string out;
  must(compare_packed(db, [&](const PackedDifference& d) { out += "mac"[static_cast<int>(d.kind)]; }));
  return out;
}

std::vector<PackedAttempt> packed(Database& db) {
  std::vector<PackedAttempt> out;
  must(db.all("SELECT attempts FROM packed_attempts ORDER BY scenario, device_class, period", [&](Row row) {
    unpack_attempts(row.bytes(0), [&](const PackedAttempt& a) { out.push_back(a); });
    return 0;
  }));
  return out;
}

std::vector<std::string> summaries(Database& db) {
  return must(db.all("SELECT * FROM session_summaries ORDER BY session",
                     [](Row row) { return row.uuid(0).text() + hex(row.content_hash()); }));
}

std::string state_of(Database& db, SessionId session) {
  return must(db.first(
                  "SELECT state || ' ' || elapsed_us || ' ' || coalesce(score, '-') || ' ' || coalesce(passed, '-') "
                  "FROM session_summaries WHERE session = ?1",
                  [](Row row) { return row.text(0); }, session))
      .value_or("none");
}

struct Summaries : ::testing::Test {
  Folder folder;
  std::shared_ptr<std::int64_t> now = std::make_shared<std::int64_t>(kNow);
  std::unique_ptr<Store> store = open(folder / "a.db", quick(now));
  Account lena = make_student(*store);
  ScenarioVersion version = keep(*store);
  Database& db() { return store->database(); }
  std::vector<int> attempts() {
    return must(db().all("SELECT attempt FROM session_summaries ORDER BY sequence",
                         [](Row row) { return static_cast<int>(row.integer(0)); }));
  }
};

TEST_F(Summaries, follow_each_row_that_is_written) {
  const Actor instructor = make_instructor(*store).actor();
  const SessionId id = must(store->sessions.start(lena.actor(), new_session(lena, version))).id;
  const auto is = [&](const char* state) {
    EXPECT_EQ(state_of(db(), id), state);
    EXPECT_EQ(differences(db()), "") << state;
    EXPECT_EQ(packed_differences(db()), "") << state;
  };
  is("running 0 - -");
  must(store->traces.append(id, second_from(1)));
  is("running 1000008 - -");
  must(store->sessions.interrupt(id, "recorder_full"));
  is("interrupted 1000008 - -");
  must(store->sessions.resume(id, "student"));
  is("running 1000008 - -");
  must(store->traces.append(id, second_from(13)));
  must(store->sessions.finish(id, volume_after(24), "student"));
  is("finished 2000016 - -");
  must(store->grades.save(id, small_grade(45, false), {}));
  is("graded 2000016 45.0 0");
  must(store->grades.save(id, small_grade(72, true), {}, instructor));
  is("graded 2000016 72.0 1");
  must(store->sessions.close(id, "done"));
  is("graded 2000016 72.0 1");
}

TEST_F(Summaries, an_ungraded_session_that_is_closed_is_closed) {
  const SessionId id = must(store->sessions.start(lena.actor(), new_session(lena, version))).id;
  must(store->sessions.interrupt(id, "recorder_full"));
  must(store->sessions.close(id, "left"));
  EXPECT_EQ(state_of(db(), id), "closed 0 - -");
  EXPECT_EQ(differences(db()), "");
}

TEST_F(Summaries, attempts_are_counted_by_start_also_after_the_clock_was_set_back) {
  for (int i = 0; i < 2; ++i, *now += 60'000'000) complete_session(*store, lena, version);
  *now -= 90'000'000;
  complete_session(*store, lena, version);
  EXPECT_EQ(attempts(), (std::vector{1, 3, 2}));
  EXPECT_EQ(differences(db()), "");
  EXPECT_EQ(packed_differences(db()), "");
}

TEST_F(Summaries, attempts_of_guests_and_try_outs_are_counted_apart) {
  const Account instructor = make_instructor(*store), guest = make_guest(*store);
  complete_session(*store, guest, version);
  NewSession out = new_session(instructor, version);
  out.kind = SessionKind::try_out;
  must(store->sessions.start(instructor.actor(), out));
  complete_session(*store, instructor, version);
  EXPECT_EQ(attempts(), (std::vector{1, 1, 1}));
  EXPECT_EQ(differences(db()), "");
}

TEST_F(Summaries, a_rebuild_is_refused_to_whom_another_window_switched_off_since_signing_in) {
  const Actor admin = make_administrator(*store).actor();
  const Actor second = must(store->accounts.create(admin, {.number = "second", .name = "Omar Haddad", .role = Role::administrator, .password = "battery staple"})).actor();
  complete_session(*store, lena, version, 90);
  must(db().run("UPDATE session_summaries SET score = 100"));
  const auto before = summaries(db());
  must(open(folder / "a.db")->accounts.disable(second, admin.id));
  EXPECT_EQ(code_of(rebuild_summaries(store->context(), admin)), StorageError::disabled);
  EXPECT_EQ(summaries(db()), before);
}

TEST_F(Summaries, a_rebuild_needs_its_right_and_writes_the_same_rows) {
  const Actor admin = make_administrator(*store).actor();
  complete_session(*store, lena, version, 40, false);
  complete_session(*store, lena, version, 90);
  const auto before = summaries(db());
  EXPECT_EQ(code_of(rebuild_summaries(store->context(), lena.actor())), StorageError::not_allowed);
  must(db().run("UPDATE session_summaries SET score = 100"));
  EXPECT_NE(summaries(db()), before);
  EXPECT_EQ(must(rebuild_summaries(store->context(), admin)), 2u);
  EXPECT_EQ(summaries(db()), before);
  EXPECT_EQ(must(rebuild_summaries(store->context(), admin)), 0u);
  EXPECT_TRUE(must(verify_store(store->context())).intact());
}

TEST_F(Summaries, each_column_that_differs_is_named_with_its_session) {
  make_administrator(*store);
  const SessionId id = complete_session(*store, lena, version);
  complete_session(*store, lena, version);
  must(db().run("PRAGMA foreign_keys = OFF"));
  const auto columns = must(db().all("SELECT name, type FROM pragma_table_info('session_summaries') WHERE pk = 0",
                                     [](Row row) { return std::pair{row.text(0), row.text(1)}; }));
  ASSERT_EQ(columns.size(), 22u);
  for (const auto& [column, type] : columns) {
    must(db().run("BEGIN"));
    const std::string other = type == "TEXT" ? " || 'x'" : type == "BLOB" ? "" : " + 1";
    must(db().run("UPDATE session_summaries SET " + column + " = " + (type == "BLOB" ? "zeroblob(16)" : column + other) +
                      " WHERE session = ?1",
                  id));
    EXPECT_EQ(differences(db()), id.text() + " column " + column + "\n");
    must(db().run("ROLLBACK"));
  }
  must(db().run("UPDATE session_summaries SET passed = NULL WHERE session = ?1", id));
  const auto findings = must(verify_store(store->context())).findings;
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].code, FindingCode::summary_differs);
  EXPECT_EQ(findings[0].table, "session_summaries");
  EXPECT_EQ(findings[0].owner, id.uuid);
  EXPECT_EQ(findings[0].what, "passed");
}

TEST_F(Summaries, one_too_few_and_one_too_many_are_named) {
  const SessionId id = complete_session(*store, lena, version);
  const SessionId other = SessionId::make();
  must(db().run("PRAGMA foreign_keys = OFF"));
  must(db().run("UPDATE session_summaries SET session = ?2 WHERE session = ?1", id, other));
  EXPECT_EQ(differences(db()), id.text() + " missing \n" + other.text() + " added \n");
}

TEST_F(Summaries, a_packed_attempt_holds_what_figures_count) {
  const Actor instructor = make_instructor(*store).actor();
  const SessionId id = complete_session(*store, lena, version, 45, false);
  must(store->grades.save(id, small_grade(72.25, true), {}, instructor));
  ASSERT_EQ(packed(db()).size(), 1u);
  const PackedAttempt a = packed(db()).front();
  EXPECT_EQ(a.started_utc_us, kNow);
  EXPECT_EQ(a.student, lena.id.uuid);
  EXPECT_EQ(a.score, 72.25);
  EXPECT_EQ(a.pass_mark, 70);
  EXPECT_EQ(a.elapsed_us(), 3'000'024u);
  EXPECT_EQ(a.attempt(), 1);
  EXPECT_EQ(a.version_number(), 1);
  EXPECT_TRUE(a.has(PackedAttempt::kPassed) && a.has(PackedAttempt::kReleased) && !a.has(PackedAttempt::kScripted) && !a.has(PackedAttempt::kAssessment));
}

TEST_F(Summaries, packed_attempts_of_guests_and_of_ungraded_sessions_there_are_none) {
  complete_session(*store, make_guest(*store), version);
  must(store->sessions.start(lena.actor(), new_session(lena, version)));
  EXPECT_TRUE(packed(db()).empty());
  EXPECT_EQ(packed_differences(db()), "");
}

TEST_F(Summaries, packed_attempts_that_differ_are_named_and_made_anew) {
  const Actor admin = make_administrator(*store).actor();
  complete_session(*store, lena, version);
  const auto before = packed(db()).front();
  // A score of 100 in byte 24.
  must(db().run("UPDATE packed_attempts SET attempts = CAST(substr(attempts, 1, 24) || x'0000000000005940' || substr(attempts, 33) AS BLOB)"));
  EXPECT_EQ(packed(db()).front().score, 100);
  EXPECT_EQ(must(store->history.figures(admin)).median_score, 100.0);
  const auto findings = must(verify_store(store->context())).findings;
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].code, FindingCode::summary_differs);
  EXPECT_EQ(findings[0].table, "packed_attempts");
  EXPECT_EQ(findings[0].owner, version.scenario.uuid);
  EXPECT_EQ(must(rebuild_summaries(store->context(), admin)), 1u);
  EXPECT_EQ(packed(db()).front().score, before.score);

  must(db().run("UPDATE packed_attempts SET period = period + 1"));
  EXPECT_EQ(packed_differences(db()), "ma");
  must(db().run("DELETE FROM packed_attempts"));
  EXPECT_EQ(packed_differences(db()), "m");
}

/// A school whose rows stand in a file of schema 1, as an older program would have left them.
TEST(SummariesOfSchema1, the_migration_fills_them_as_the_program_writes_them) {
  const School school(SchoolTables::of_schema_1);
  const Folder folder;
  {
    auto db = must(Database::open(folder / "a.db", {.migrations = built_in_migrations().first(1)}));
    must(db.run("PRAGMA foreign_keys = OFF"));
    const auto tables = must(db.all("SELECT name FROM sqlite_schema WHERE type = 'table'", [](Row row) { return row.text(0); }));
    must(db.run("ATTACH ?1 AS now", school.now().string()));
    for (const std::string& table : tables) {
      const auto columns = must(db.first("SELECT group_concat(name, ', ') FROM pragma_table_info(?1, 'main')", [](Row row) { return row.text(0); }, table));
      must(db.run("INSERT INTO main." + table + " SELECT " + columns.value() + " FROM now." + table));
    }
  }
  for (const char* part : {".key", ".key-counter"}) fs::copy_file(school.now().string() + part, (folder / "a.db").string() + part);
  auto now = must(Database::open(school.now()));
  auto migrated = must(Database::open(folder / "a.db"));
  ASSERT_EQ(summaries(now).size(), school.sessions.size());
  EXPECT_EQ(summaries(migrated), summaries(now));
  EXPECT_EQ(differences(migrated), "");
  EXPECT_GT(packed(now).size(), 2u);
  EXPECT_EQ(packed(migrated).size(), packed(now).size());
  EXPECT_EQ(packed_differences(migrated), "");
  // Schema 1 has no table for these rows, which today's program wrote.
  must(migrated.run("ATTACH ?1 AS now", school.now().string()));
  must(migrated.run("INSERT INTO main.graded_criteria SELECT * FROM now.graded_criteria"));
  EXPECT_TRUE(must(verify_store(open(folder / "a.db")->context())).intact());
}

}  // namespace
}  // namespace cusp::test
