#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "storage/sqlite/migrate.h"
#include "tests/modules.h"
#include "tests/source_dir.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  EXPECT_TRUE(in) << file;
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

TEST(Migrations, the_numbered_files_are_all_embedded_as_they_stand) {
  const fs::path folder = source_dir() / "storage/sqlite/migrations";
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder)) files += entry.path().extension() == ".sql";
  ASSERT_EQ(built_in_migrations().size(), files);
  for (std::size_t i = 0; i < files; ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "%04zu.sql", i + 1);
    EXPECT_EQ(std::string(built_in_migrations()[i]), text_of(folder / name));
  }
}

TEST(Migrations, one_that_has_landed_is_never_edited) {
  // b2sum -l 256 storage/sqlite/migrations/NNNN.sql; a new file gets a new line here.
  const std::vector<std::string> landed = {
      "5bc9b29552351ccadbf5db0df66e71ce5641bfdff7d464e0fa6a0f107f679bb8",
      "26f3b4caca55e8ba31c22c1e2f2a339d175cd8bbe99228d1bc5efccacfa4080a",
      "365e375f6daed67f12b7338078080b6448a808a7160286fc235b34565a7c0aba",
      "0fe5e8b5e27d3c189cbbc105fa3a8e79bb954068e72afc91322f97693a64e864",
      "83320ef7b617fa98e1de76ba1feb572597ec9cb3ad3016235fee61f88070e722",
      "9411cc300440b281a92c077793ee99451894cae72f32d8f279b5316c18c71ed9",
      "485e469f6f77d6ac237a03acc0c07be5a3076236cb75b3c0f6163877cc761841",
      "d8bb514890d9c9024b7a3c5b22b8753132b3cc60e6aedcf4e13f347f6e0ca363",
      "0411b8f137ffe94e2a5c44630e29349cc449cdeb83aa04ce0027596d90c0eb8c",
      "5dc47524cb7ee80974a4db6a7c58bc47112c6970f6fa812aecde53f8bb40541c",
      "7a2ecdc9062cea0403ad0da32c44510064b621f28cbff05c0eba9248f5a2f4a1",
      "77321b2ba2641bdb671ddfcc498c89871c3a14b34845b20157236e2b67727305",
      "1142289534135523c7c5426070c548ce7d6e930ef7aa5d1fff7fec53904b0392",
      "4540a38c5952ea826ce7c2ccbf7b7d2b0189c7ccbdae3ec900c1551fa4733cb3",
      "9912c09a9c5470b22951b807eefd4c7d6541f25f1c3db7f88051fbe73794f2d7",
      "936d98617f472c8627609629c39c92e79101c6cfa24b4ea6b9fdb668eea5b881",
      "b85c5f24e4270b0ad30671e520e869aa63cec47b66b512b091bc65c0cb0299ad",
      "43562222d168702726954e5e7f21ac054a547b30c10ca332a796046594aae7b1",
  };
  ASSERT_EQ(built_in_migrations().size(), landed.size());
  for (std::size_t i = 0; i < landed.size(); ++i)
    EXPECT_EQ(hex(blake2b_256(built_in_migrations()[i])), landed[i]) << i + 1;
}

TEST(Migrations, one_that_fails_half_way_changes_nothing) {
  const Folder folder;
  auto db = must(Database::open(folder / "a.db"));
  const int before = db.schema_version();
  std::vector<std::string_view> more(built_in_migrations().begin(), built_in_migrations().end());
  more.push_back("CREATE TABLE half (a INTEGER) STRICT; INSERT INTO half VALUES (1); INSERT INTO nowhere VALUES (1);");
  EXPECT_FALSE(migrate(db, more));
  EXPECT_EQ(db.schema_version(), before);
  EXPECT_EQ(
      *must(db.first("SELECT count(*) FROM sqlite_schema WHERE name = 'half'", [](Row row) { return row.integer(0); })),
      0);
  EXPECT_FALSE(db.in_transaction());
}

TEST(Migrations, a_further_one_is_run_once) {
  const Folder folder;
  auto db = must(Database::open(folder / "a.db"));
  std::vector<std::string_view> more(built_in_migrations().begin(), built_in_migrations().end());
  more.push_back("CREATE TABLE added (a INTEGER) STRICT;");
  must(migrate(db, more));
  must(migrate(db, more));
  EXPECT_EQ(db.schema_version(), static_cast<int>(more.size()));
  EXPECT_EQ(code_of(migrate(db)), StorageError::newer_schema);
}

/// What a program of schema 1 had written, row by row: later schemas must still read it.
TEST(Migrations, a_file_of_schema_1_opens_and_holds_what_it_held) {
  const Folder folder;
  {
    auto db = must(Database::open(folder / "a.db", {.migrations = built_in_migrations().first(1)}));
    must(db.script(text_of(source_dir() / "tests/storage/fixtures/schema-0001.sql")));
  }
  const auto store = open(folder / "a.db");
  EXPECT_EQ(store->database().schema_version(), static_cast<int>(built_in_migrations().size()));
  EXPECT_EQ(must(store->database().integrity_check()), "");

  const Account student = must(store->accounts.sign_in_with_pin("20267314", "314159"));
  EXPECT_EQ(student.name, "Lena Brandt");
  const auto rows = must(store->history.list(student.actor()));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].title.at("de"), "Gerader Kanal");
  EXPECT_EQ(rows[0].started_utc_us, kNow);
  EXPECT_EQ(rows[0].score, 81.5);
  EXPECT_EQ(rows[0].state, SessionState::graded);
  const Actor everybodys{UserId{}, Role::administrator};
  EXPECT_EQ(must(store->history.figures(everybodys)).median_score, 81.5);
  const SessionId session = rows[0].session;
  EXPECT_EQ(must(store->traces.inputs(session)).size(), 36u);
  EXPECT_EQ(must(store->traces.inputs(session, 0)), second_from(1).inputs);
  EXPECT_EQ(must(store->traces.final_volume(session))->cuts, volume_after(36).cuts);
  EXPECT_EQ(must(store->grades.newest(session))->grade.criteria.at(1).reason_args.at("limit"), 2.0);
  EXPECT_TRUE(must(verify_session(store->context(), session)).intact());
  EXPECT_TRUE(must(verify_audit_log(store->context())).intact());
  EXPECT_TRUE(must(verify_store(store->context())).intact());
}

TEST(Migrations, a_file_of_schema_1_opened_for_reading_shows_the_same_and_stays_as_it_is) {
  const Folder folder;
  const fs::path file = folder / "a.db";
  {
    auto db = must(Database::open(file, {.migrations = built_in_migrations().first(1)}));
    must(db.script(text_of(source_dir() / "tests/storage/fixtures/schema-0001.sql")));
  }
  const std::string before = text_of(file);
  StoreOptions reading = quick();
  reading.database.access = DatabaseOptions::Access::read_only;
  {
    const auto store = open(file, reading);
    const Account student = must(store->accounts.find_number("20267314"));
    const auto rows = must(store->history.list(student.actor()));
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].score, 81.5);
    EXPECT_TRUE(must(verify_session(store->context(), rows[0].session)).intact());
    EXPECT_EQ(code_of(store->database().run("DELETE FROM session_summaries")), StorageError::read_only);
  }
  EXPECT_EQ(text_of(file), before);
}

/// What stands in the tables of assignments, as the program of schema 7 sealed it.
TEST(Migrations, an_assessment_of_schema_7_admits_every_device_in_the_usual_text_and_its_seals_hold) {
  const Folder folder;
  {
    auto db = must(Database::open(folder / "a.db", {.migrations = built_in_migrations().first(7)}));
    must(db.script(text_of(source_dir() / "tests/storage/fixtures/schema-0007.sql")));
  }
  const auto store = open(folder / "a.db");
  const auto changed = [&] {
    std::vector<std::string> tables;
    for (const ChainFinding& finding : must(verify_store(store->context())).findings)
      if (finding.code != FindingCode::counter_missing) tables.push_back(finding.table);
    return tables;
  };
  EXPECT_EQ(changed(), std::vector<std::string>{});
  const Account student = must(store->accounts.find_number("20267314"));
  const auto assigned = must(store->assignments.for_student(student.id));
  ASSERT_EQ(assigned.size(), 2u);
  for (const Assignment& a : assigned) EXPECT_TRUE(a.device_classes.empty() && !a.self_test_days && !a.drawn_tooth);
  EXPECT_EQ(must(store->assignments.adjustment(assigned[1].id, student.id)), (Adjustment{.extra_time_percent = 25}));
  must(store->database().run("UPDATE assignments SET device_classes = 'falcon' WHERE kind = 'practice'"));
  must(store->database().run("UPDATE adjustments SET large_text = 1"));
  EXPECT_EQ(changed(), (std::vector<std::string>{"assignments", "adjustments"}));
  must(store->database().run("UPDATE assignments SET device_classes = NULL, self_test_days = 7 WHERE kind = 'practice'"));
  EXPECT_EQ(changed(), (std::vector<std::string>{"assignments", "adjustments"}));
  must(store->database().run("UPDATE assignments SET self_test_days = NULL, drawn_tooth = 1 WHERE kind = 'practice'"));
  EXPECT_EQ(changed(), (std::vector<std::string>{"assignments", "adjustments"}));
}

/// A graded attempt with an override and a comment, as the program of schema 11 wrote and signed them.
TEST(Migrations, an_attempt_of_schema_11_holds_its_statements_and_takes_an_own_assessment) {
  const Folder folder;
  {
    auto db = must(Database::open(folder / "a.db", {.migrations = built_in_migrations().first(11)}));
    must(db.script(text_of(source_dir() / "tests/storage/fixtures/schema-0011.sql")));
  }
  const auto store = open(folder / "a.db");
  const auto whole = [&] {
    std::string out;
    for (const ChainFinding& f : must(verify_store(store->context())).findings)
      if (f.code != FindingCode::counter_missing) out += std::string(key_of(f.code)) + ' ' + f.table + ' ' + f.what + '\n';
    return out;
  };
  EXPECT_EQ(whole(), "");
  const Account student = must(store->accounts.find_number("20267314"));
  const auto rows = must(store->history.list(student.actor()));
  ASSERT_EQ(rows.size(), 1u);
  const SessionId session = rows[0].session;
  EXPECT_EQ(rows[0].score, 70);
  const Actor everybodys{UserId{}, Role::administrator};
  const auto statements = must(store->statements.of(everybodys, session));
  ASSERT_EQ(statements.size(), 2u);
  EXPECT_EQ(statements[0].text, "The block was worn.");
  EXPECT_EQ(statements[1].text, "Well done.");
  EXPECT_EQ(must(store->sessions.find(session)).header.guard.limit_n, 3.3);
  must(store->statements.assess_own(student.actor(), session, {{{"target_removed", OwnRating::met}}}));
  EXPECT_EQ(whole(), "");
  EXPECT_EQ(code_of(store->database().run("INSERT INTO statement_texts VALUES (zeroblob(16), zeroblob(32), '')")), StorageError::not_found)
      << "references are enforced again";
}

/// A graded attempt with a comment, header and criteria packed, as the program of schema 14 wrote and sealed them.
TEST(Migrations, an_attempt_of_schema_14_holds_and_its_seals_are_listed_and_compared) {
  const Folder folder;
  {
    auto db = must(Database::open(folder / "a.db", {.migrations = built_in_migrations().first(14)}));
    must(db.script(text_of(source_dir() / "tests/storage/fixtures/schema-0014.sql")));
  }
  const auto store = open(folder / "a.db");
  EXPECT_EQ(must(store->database().integrity_check()), "");
  const auto changed = [&] {
    std::string out;
    for (const ChainFinding& f : must(verify_store(store->context())).findings)
      if (f.code != FindingCode::counter_missing) out += std::string(key_of(f.code)) + ' ' + f.table + '\n';
    return out;
  };
  EXPECT_EQ(changed(), "");
  const Account student = must(store->accounts.find_number("20267314"));
  const auto rows = must(store->history.list(student.actor()));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].score, 68);
  EXPECT_EQ(must(store->sessions.find(rows[0].session)).header.guard.limit_n, 3.3);
  EXPECT_EQ(must(store->grades.newest(rows[0].session))->grade.criteria.at(1).reason_args.at("limit"), 2.0);
  const Actor everybodys{UserId{}, Role::administrator};
  const auto seals = [&](const AuditFilter& filter) {
    std::string out;
    for (const AuditEntry& e : must(store->audit.list(everybodys, 10, INT64_MAX, filter))) out += e.detail.substr(0, e.detail.rfind(' ')) + '\n';
    return out;
  };
  EXPECT_EQ(seals({.actions = {"session_sealed"}}), "graded 17\nfinished 14\nstarted 2\n");
  EXPECT_EQ(seals({.actions = {"session_sealed"}, .person = student.id}), "started 2\n");
  must(store->database().run("UPDATE audit_log SET detail = replace(detail, 'finished 14', 'finished 13')"));
  EXPECT_EQ(changed(), "row_changed audit_log\n");
}

TEST(Migrations, a_statement_whose_session_is_gone_stops_no_migration_and_is_named_afterwards) {
  const Folder folder;
  {
    auto db = must(Database::open(folder / "a.db", {.migrations = built_in_migrations().first(11)}));
    must(db.script(text_of(source_dir() / "tests/storage/fixtures/schema-0011.sql")));
    must(db.run("PRAGMA foreign_keys = OFF"));
    must(db.run("DELETE FROM sessions"));
  }
  const auto store = open(folder / "a.db");
  std::vector<std::string> tables;
  for (const ChainFinding& f : must(verify_store(store->context())).findings) tables.push_back(f.table);
  EXPECT_NE(std::ranges::find(tables, "sessions"), tables.end());
  EXPECT_EQ(*must(store->database().first("SELECT count(*) FROM statements", [](Row row) { return row.integer(0); })), 2);
}

TEST(Migrations, a_statement_of_no_kind_stops_no_migration_and_is_named_afterwards) {
  const Folder folder;
  {
    auto db = must(Database::open(folder / "a.db", {.migrations = built_in_migrations().first(11)}));
    must(db.script(text_of(source_dir() / "tests/storage/fixtures/schema-0011.sql")));
    must(db.run("PRAGMA ignore_check_constraints = ON"));
    must(db.run("UPDATE statements SET kind = 'shout' WHERE kind = 'comment'"));
  }
  const auto store = open(folder / "a.db");
  std::vector<std::string> tables;
  for (const ChainFinding& f : must(verify_store(store->context())).findings) tables.push_back(f.table);
  EXPECT_NE(std::ranges::find(tables, "statements"), tables.end());
  EXPECT_FALSE(store->database().run("UPDATE statements SET kind = 'shout'")) << "checks are enforced again";
}

}  // namespace
}  // namespace cusp::test
