/// Files from station to station: what each carries, whose is read, and what a bad one does.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/storage/failing_vfs.h"
#include "tests/storage/two_stations.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

struct ExchangeTest : TwoStations {
  Actor instructor = make_instructor(*office).actor();
  Account lena = make_student(*office);
  ScenarioVersion version = keep(*office);

  void SetUp() override { trust_each_other(); }
  StorageError refused_at_office(const fs::path& file) { return code_of(read_in(office->context(), chief, file)); }
  static void copy_station(const fs::path& from, const fs::path& to) {
    for (const char* part : {"", ".key", ".key-counter"}) fs::copy_file(from.string() + part, to.string() + part, fs::copy_options::overwrite_existing);
  }
  static std::string bytes(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(ExchangeTest, results_arrive_with_chain_grade_and_statements_and_verify_under_the_key_of_their_station) {
  const Account omar = make_student(*station, "20260002", "Omar Haddad");
  const SessionId session = attempt(omar, 62);
  const Account examiner = make_instructor(*station, "haas");
  const SelfAssessment own{{{"target_removed", OwnRating::partly}}};
  must(station->statements.assess_own(omar.actor(), session, own));
  must(station->statements.override_points(examiner.actor(), session, "target_removed", 20, "The block was worn."));
  const ReadIn read = at_office(results());
  EXPECT_EQ(read.outcome, ReadOutcome::read);
  EXPECT_EQ(read.counts.sessions, 1u);
  EXPECT_EQ(read.counts.statements, 2u);
  EXPECT_EQ(must(office->statements.self_assessment(chief, session)), own);
  EXPECT_TRUE(must(verify_session(office->context(), session)).intact());
  EXPECT_EQ(whole(*office), "");
  const auto here = must(station->history.details(keeper, session)), there = must(office->history.details(chief, session));
  EXPECT_EQ(there.row.score, here.row.score);
  EXPECT_EQ(must(office->traces.inputs(session)).size(), must(station->traces.inputs(session)).size());
  EXPECT_EQ(must(office->accounts.find(omar.id)).name, "Omar Haddad");
  EXPECT_FALSE(office->accounts.sign_in("20260002", "battery staple")) << "an account without a secret of its own signs nobody in";
}

TEST_F(ExchangeTest, an_office_file_brings_accounts_that_sign_in_and_assignments_that_admit) {
  const CohortId cohort = must(office->cohorts.create(chief, "Year 2")).id;
  must(office->cohorts.add(chief, cohort, lena.id));
  Assignment exam{.version = version.id, .cohort = cohort, .kind = SessionKind::assessment, .device_classes = {"pointer"}, .self_test_days = 7, .drawn_tooth = true};
  exam = must(office->assignments.create(instructor, exam, "4711"));
  must(office->assignments.adjust(instructor, exam.id, lena.id, {.extra_time_percent = 25, .large_text = true}));
  const fs::path file = office_file();
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write) << "it has hashed secrets";
  at_station(file);
  EXPECT_EQ(must(station->accounts.sign_in_with_pin(lena.number, "314159")).id, lena.id);
  NewSession wanted = new_session(lena, version);
  wanted.assignment = exam.id;
  wanted.start_code = "4711";
  wanted.header.exercise = "{\"specimen\": {\"seed\": 17}}";
  NewSession elsewhere = wanted;
  elsewhere.header.device.device_class = "falcon";
  EXPECT_EQ(code_of(station->sessions.start(lena.actor(), elsewhere)), StorageError::other_device);
  EXPECT_EQ(code_of(station->sessions.start(lena.actor(), wanted)), StorageError::self_test_due);
  must(station->device_tests.add({UserId::make(), Role::administrator}, {.device_class = "pointer", .device = "Mouse"}));
  const Session session = must(station->sessions.start(lena.actor(), wanted));
  EXPECT_EQ(session.header.extra_time_percent, 25);
  EXPECT_TRUE(session.header.large_text);
  EXPECT_EQ(whole(*station), "");
}

TEST_F(ExchangeTest, a_version_that_only_attempts_of_another_station_name_stays_out_of_the_library) {
  const auto other = keep(*station, small_scenario(), "{\"id\":2}");
  ASSERT_EQ(other.number, version.number) << "each station counts for itself";
  const SessionId session = complete_session(*station, make_student(*station, "2", "Omar"), other);
  at_office(results());
  EXPECT_TRUE(must(verify_session(office->context(), session)).intact());
  EXPECT_EQ(must(office->scenarios.version(other.id)).number, 2);
  const auto library = must(office->scenarios.library());
  ASSERT_EQ(library.size(), 1u);
  EXPECT_EQ(library.front().id, version.id);
}

TEST_F(ExchangeTest, an_assignment_that_only_attempts_of_another_station_name_admits_nobody) {
  const CohortId cohort = must(office->cohorts.create(chief, "Year 2")).id;
  must(office->cohorts.add(chief, cohort, lena.id));
  at_station(office_file());
  const Assignment exam = must(office->assignments.create(instructor, {.version = version.id, .cohort = cohort, .kind = SessionKind::assessment}, "4711"));
  NewSession wanted = new_session(lena, version);
  wanted.assignment = exam.id;
  wanted.start_code = "4711";
  const SessionId session = must(office->sessions.start(lena.actor(), wanted)).id;
  must(office->traces.append(session, second_from(1)));
  must(office->sessions.finish(session, volume_after(12), "student"));
  const fs::path file = next_file();
  must(give_out(office->context(), chief, ExchangeKind::results, file));
  at_station(file);
  EXPECT_TRUE(must(station->assignments.for_student(lena.id)).empty());
  wanted.start_code.clear();
  EXPECT_EQ(code_of(station->sessions.start(lena.actor(), wanted)), StorageError::not_allowed) << "its start code has not arrived";
  at_station(office_file());
  wanted.start_code = "4711";
  must(station->sessions.start(lena.actor(), wanted));
  EXPECT_EQ(whole(*station), "");
}

TEST_F(ExchangeTest, a_file_is_read_twice_without_harm) {
  attempt(make_student(*station, "2", "Omar"));
  const fs::path file = results();
  at_office(file);
  const auto before = shared_records(*office);
  const auto entries = must(verify_store(office->context())).entries;
  const ReadIn again = at_office(file);
  EXPECT_EQ(again.outcome, ReadOutcome::again);
  EXPECT_TRUE(again.counts.none());
  EXPECT_EQ(shared_records(*office), before);
  EXPECT_EQ(must(verify_store(office->context())).entries, entries) << "nothing was added to the log";
}

TEST_F(ExchangeTest, a_late_file_is_named_and_undoes_nothing) {
  const fs::path first = office_file();
  must(office->accounts.rename(chief, lena.id, lena.number, "Lena Meier"));
  const fs::path second = office_file();
  at_station(second);
  EXPECT_EQ(at_station(first).outcome, ReadOutcome::late);
  EXPECT_EQ(must(station->accounts.find(lena.id)).name, "Lena Meier");
}

TEST_F(ExchangeTest, a_session_that_grew_continues_and_an_older_copy_of_it_changes_nothing) {
  const Account omar = make_student(*station, "2", "Omar");
  const SessionId session = must(station->sessions.start(omar.actor(), new_session(omar, keep(*station)))).id;
  must(station->traces.append(session, second_from(1)));
  must(station->sessions.finish(session, volume_after(12), "student"));
  const fs::path ungraded = results();
  must(station->grades.save(session, small_grade(77), {}));
  const fs::path graded = results();
  EXPECT_EQ(at_office(ungraded).grown, 0u);
  EXPECT_EQ(must(office->sessions.state(session)), SessionState::finished);
  const ReadIn read = at_office(graded);
  EXPECT_EQ(read.counts.sessions, 1u);
  EXPECT_EQ(read.grown, 1u);
  EXPECT_EQ(must(office->history.details(chief, session)).row.score, 77);
  EXPECT_TRUE(at_office(ungraded).counts.none());
  EXPECT_EQ(must(office->sessions.state(session)), SessionState::graded);
  EXPECT_EQ(whole(*office), "");
}

TEST_F(ExchangeTest, the_session_of_another_station_takes_statements_and_no_further_rows) {
  const SessionId session = attempt(make_student(*station, "2", "Omar"));
  at_office(results());
  must(office->statements.comment(instructor, session, "Well done."));
  const auto graded = office->grades.save(session, small_grade(1), {}, instructor);
  EXPECT_EQ(code_of(graded), StorageError::wrong_state);
  EXPECT_EQ(code_of(office->sessions.close(session, "student")), StorageError::wrong_state);
  EXPECT_EQ(at_station(office_file()).counts.statements, 1u);
  EXPECT_EQ(must(station->statements.of(keeper, session)).front().text, "Well done.");
}

TEST_F(ExchangeTest, an_unknown_or_revoked_key_is_refused_and_named) {
  attempt(make_student(*station, "2", "Omar"));
  const fs::path file = results();
  const auto stranger = open(folder / "stranger.db");
  const Actor other = make_administrator(*stranger, "x").actor();
  const auto unknown = read_in(stranger->context(), other, file);
  ASSERT_EQ(code_of(unknown), StorageError::unknown_key);
  EXPECT_EQ(unknown.error().where, station->context().station.text());
  EXPECT_EQ(unknown.error().detail, hex(station->context().key->id()));
  must(revoke(office->context(), chief, station->context().key->id()));
  EXPECT_EQ(refused_at_office(file), StorageError::revoked_key);
  EXPECT_EQ(must(sessions_to_verify(office->context())).size(), 0u);
  must(trust(office->context(), chief, key_of_station(*station), KeyRole::station));
  at_office(file);
  EXPECT_EQ(whole(*office), "");
}

TEST_F(ExchangeTest, accounts_come_from_the_office_alone) {
  const fs::path file = next_file();
  must(give_out(station->context(), keeper, ExchangeKind::office, file));
  const auto done = read_in(office->context(), chief, file);
  EXPECT_EQ(code_of(done), StorageError::not_allowed);
  EXPECT_EQ(done.error().where, "office_file");
}

TEST_F(ExchangeTest, only_an_administrator_gives_out_reads_in_and_trusts) {
  const fs::path file = results();
  for (const Role role : {Role::student, Role::instructor}) {
    const Actor other{instructor.id, role};
    EXPECT_EQ(code_of(give_out(office->context(), other, ExchangeKind::office, next_file())), StorageError::not_allowed);
    EXPECT_EQ(code_of(read_in(office->context(), other, file)), StorageError::not_allowed);
    EXPECT_EQ(code_of(trust(office->context(), other, key_of_station(*station), KeyRole::office)), StorageError::not_allowed);
    EXPECT_EQ(code_of(revoke(office->context(), other, station->context().key->id())), StorageError::not_allowed);
    EXPECT_EQ(code_of(other_keys(office->context(), other)), StorageError::not_allowed);
    EXPECT_EQ(code_of(own_key(office->context(), other)), StorageError::not_allowed);
    EXPECT_EQ(code_of(look_into(office->context(), other, file)), StorageError::not_allowed);
    EXPECT_EQ(code_of(files_read_in(office->context(), other)), StorageError::not_allowed);
  }
}

TEST_F(ExchangeTest, who_was_switched_off_at_another_window_gives_out_and_reads_in_nothing) {
  const Actor second = must(office->accounts.create(chief, {.number = "b", .name = "B", .role = Role::administrator, .password = "correct horse"})).actor();
  complete_session(*station, make_student(*station, "2", "Omar"), keep(*station), 81.5);
  const fs::path file = results(), away = next_file();
  must(office->accounts.disable(second, chief.id));
  const auto before = shared_records(*office);
  EXPECT_EQ(refused_at_office(file), StorageError::disabled);
  EXPECT_EQ(code_of(give_out(office->context(), chief, ExchangeKind::office, away)), StorageError::disabled);
  EXPECT_FALSE(fs::exists(away));
  EXPECT_EQ(shared_records(*office), before);
  must(read_in(office->context(), second, file));
}

TEST_F(ExchangeTest, a_station_neither_trusts_itself_nor_reads_its_own_file) {
  EXPECT_EQ(code_of(trust(station->context(), keeper, key_of_station(*station), KeyRole::station)), StorageError::not_allowed);
  EXPECT_EQ(code_of(read_in(station->context(), keeper, results())), StorageError::not_allowed);
}

TEST_F(ExchangeTest, a_number_that_somebody_else_has_here_refuses_the_office_file_whole) {
  make_student(*station, lena.number, "Somebody else");
  const auto before = shared_records(*station);
  const auto done = read_in(station->context(), keeper, office_file());
  ASSERT_EQ(code_of(done), StorageError::duplicate);
  EXPECT_EQ(done.error().where, lena.number);
  EXPECT_EQ(done.error().detail, "number");
  EXPECT_EQ(shared_records(*station), before);
}

TEST_F(ExchangeTest, the_office_wins_where_both_changed_an_account_and_the_account_is_named) {
  at_station(office_file());
  must(station->accounts.set_pin(keeper, lena.id, "271828"));
  EXPECT_TRUE(at_station(office_file()).conflicts.empty());
  must(station->accounts.sign_in_with_pin(lena.number, "271828"));
  must(office->accounts.rename(chief, lena.id, lena.number, "Lena Meier"));
  const ReadIn read = at_station(office_file());
  ASSERT_EQ(read.conflicts, std::vector<std::string>{lena.number});
  must(station->accounts.sign_in_with_pin(lena.number, "314159"));
  EXPECT_EQ(whole(*station), "");
}

TEST_F(ExchangeTest, who_is_erased_at_the_office_is_erased_at_each_station_and_stays_so) {
  at_station(office_file());
  const SessionId session = attempt(lena);
  must(station->statements.comment(Actor{must(station->accounts.find_number("okafor")).id, Role::instructor}, session, "Lena, well done."));
  const fs::path with_text = results();
  must(office->accounts.erase(chief, lena.id));
  at_office(with_text);
  EXPECT_EQ(must(office->statements.of(chief, session)).front().text, "");
  at_station(office_file());
  EXPECT_EQ(must(station->accounts.find(lena.id)).name, "–");
  EXPECT_EQ(must(station->statements.of(keeper, session)).front().text, "");
  EXPECT_EQ(whole(*station), "");
  EXPECT_EQ(whole(*office), "");
}

TEST_F(ExchangeTest, what_is_no_exchange_file_is_refused) {
  const fs::path file = results();
  const std::string good = bytes(file);
  const fs::path other = next_file();
  const auto refused = [&](const std::string& content) {
    std::ofstream(other, std::ios::binary) << content;
    return refused_at_office(other);
  };
  EXPECT_EQ(refused(""), StorageError::not_a_database);
  EXPECT_EQ(refused("hello"), StorageError::not_a_database);
  EXPECT_FALSE(read_in(office->context(), chief, folder / "none"));
  refused(good.substr(0, good.size() / 2));
  EXPECT_EQ(refused_at_office(folder / "station.db"), StorageError::not_exchange) << "a station's own database";
  {
    auto newer = must(Database::open(file));
    must(newer.run("PRAGMA user_version = 999"));
  }
  EXPECT_EQ(refused_at_office(file), StorageError::newer_schema);
}

TEST_F(ExchangeTest, rows_that_sql_changed_in_a_file_are_refused) {
  attempt(make_student(*station, "2", "Omar"));
  const std::string good = bytes(results());
  const fs::path other = next_file();
  for (const char* sql : {"UPDATE grades SET score = 100", "UPDATE people SET name = 'x'", "DELETE FROM statements", "DELETE FROM trace_chunks WHERE row = 1",
                          "CREATE VIEW v AS SELECT 1", "CREATE TABLE more (a)", "UPDATE exchange_description SET description = replace(description, 'results', 'office')",
                          "UPDATE station SET next_sequence = next_sequence + 1", "DELETE FROM exchange_description"}) {
    std::ofstream(other, std::ios::binary) << good;
    {
      auto file = must(Database::open(other));
      must(file.run("PRAGMA foreign_keys = OFF"));
      must(file.run(sql));
    }
    if (std::string_view(sql) == "DELETE FROM statements") continue;  // there is none: the file stays as it was signed
    EXPECT_EQ(refused_at_office(other), StorageError::not_exchange) << sql;
  }
  EXPECT_EQ(must(sessions_to_verify(office->context())).size(), 0u);
}

TEST_F(ExchangeTest, a_changed_byte_is_refused_or_changes_nothing_that_is_read) {
  const Account omar = make_student(*station, "2", "Omar");
  const SessionId session = attempt(omar);
  must(station->statements.comment(make_instructor(*station, "haas").actor(), session, "Well done."));
  const std::string good = bytes(results());
  at_office(folder / "file-1");
  const auto read = shared_records(*office);
  {
    const auto empty = open(folder / "empty.db");
    const Actor other = make_administrator(*empty, "other").actor();
    must(trust(empty->context(), other, key_of_station(*station), KeyRole::station));
    must(empty->database().run("PRAGMA wal_checkpoint(TRUNCATE)"));
  }
  constexpr unsigned kSeed = 37;
  constexpr int kChanges = 300;
  std::mt19937 random(kSeed);
  int refused = 0;
  std::unique_ptr<Store> trial;
  std::map<std::string, std::string> before;
  for (int i = 0; i < kChanges; ++i) {
    if (!trial) {
      copy_station(folder / "empty.db", folder / ("trial-" + std::to_string(i) + ".db"));
      trial = open(folder / ("trial-" + std::to_string(i) + ".db"));
      before = shared_records(*trial);
    }
    std::string content = good;
    std::size_t at = 0;
    do at = random() % content.size();
    while (content[at] == 0);  // most of a small file is empty
    content[at] = static_cast<char>(content[at] ^ (1 << random() % 8));
    std::ofstream(folder / "changed", std::ios::binary) << content;
    const auto done = read_in(trial->context(), chief, folder / "changed");
    const auto now = shared_records(*trial);
    if (!done) {
      ++refused;
      ASSERT_EQ(now, before) << "byte " << at << " seed " << kSeed;
      continue;
    }
    // No row holds this byte: what was read is what was signed.
    for (const char* table : {"sessions", "session_chain", "trace_chunks", "statements", "statement_texts", "grades"}) ASSERT_EQ(now.at(table), read.at(table)) << at;
    ASSERT_EQ(whole(*trial), "") << at;
    trial.reset();
  }
  std::printf("%d of %d changed bytes refused, the others in no row\n", refused, kChanges);
  EXPECT_GT(refused, kChanges / 2);
}

TEST_F(ExchangeTest, a_disk_that_fails_in_the_middle_leaves_all_of_a_file_or_nothing) {
  attempt(make_student(*station, "2", "Omar"));
  const fs::path file = results();
  office.reset();
  StoreOptions options = quick();
  options.database.vfs = failing_vfs();
  std::map<std::string, std::string> nothing, all;
  bool finished = false;
  int failed = 0;
  for (int n = 0; !finished; n += n == 0 ? 1 : 3) {
    const fs::path trial = folder / ("trial-" + std::to_string(n) + ".db");
    copy_station(folder / "office.db", trial);
    {
      auto store = must(Store::open(trial, options));
      if (n == 0) nothing = shared_records(*store);
      fail_from(n == 0 ? Failing::nothing : Failing::io_error, n);
      const auto done = read_in(store->context(), chief, file);
      finished = n > 0 && done.has_value() && operations_seen() < n;
      failed += !done;
      fail_from(Failing::nothing, 0);
    }
    const auto again = open(trial);
    const auto now = shared_records(*again);
    if (n == 0) all = now;
    EXPECT_TRUE(now == nothing || now == all) << n;
    EXPECT_EQ(whole(*again), "") << n;
  }
  EXPECT_NE(nothing, all);
  EXPECT_GT(failed, 3);
}

}  // namespace
}  // namespace cusp::test
