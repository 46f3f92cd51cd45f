/// Statements of two stations about one session, what both gave one candidate, and an attempt that went on from an old copy.
#include <gtest/gtest.h>

#include "tests/storage/two_stations.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

struct ExchangeStatements : TwoStations {
  Actor instructor = make_instructor(*office).actor();

  void SetUp() override { trust_each_other(); }
};

TEST_F(ExchangeStatements, of_marks_that_two_stations_confirmed_the_later_one_counts_at_both_and_asks_for_a_confirmation_of_both) {
  const SessionId session = attempt(make_student(*station, "2", "Omar"), 62);
  const Actor examiner = make_instructor(*station, "haas").actor();
  at_office(results());
  for (int i = 0; i < 5; ++i) attempt(make_student(*station, "3" + std::to_string(i), "Noah"));  // its numbers run ahead of the office's
  constexpr std::int64_t kHour_us = 3'600'000'000;
  must(station->statements.override_points(examiner, session, "target_removed", 3, "Seen on the tooth."));
  const SignedStatement early = must(station->statements.confirm(examiner, session));
  office->context().clock = [] { return kNow + kHour_us; };
  must(office->statements.override_points(instructor, session, "target_removed", 8, "Seen on the screen."));
  const SignedStatement late = must(office->statements.confirm(instructor, session));
  ASSERT_LT(late.sequence, early.sequence);
  const fs::path there = results(), here = office_file();
  at_office(there);
  at_station(here);
  const auto of = [&](Store& store, const Actor& reader) { return *must(store.history.details(reader, session)).grade; };
  for (const EffectiveGrade& grade : {of(*office, chief), of(*station, keeper)}) {
    EXPECT_EQ(grade.grade.criteria.front().points, 8);
    EXPECT_FALSE(grade.confirmation) << "neither examiner saw the mark of the other";
  }
  EXPECT_EQ(must(station->statements.of(keeper, session)).back().id, late.id);
  EXPECT_EQ(must(office->history.details(chief, session)).row.score, must(station->history.details(keeper, session)).row.score);
  must(station->statements.confirm(examiner, session));
  EXPECT_TRUE(of(*station, keeper).confirmation) << "its clock is an hour behind what it has read";
  at_office(results());
  EXPECT_TRUE(of(*office, chief).confirmation);
  EXPECT_EQ(whole(*office), "");
  EXPECT_EQ(whole(*station), "");
}

TEST_F(ExchangeStatements, a_confirmation_with_greater_numbers_is_none_of_a_mark_that_its_station_had_not_read) {
  const SessionId session = attempt(make_student(*station, "2", "Omar"), 62);
  at_office(results());
  const SignedStatement unread = must(station->statements.override_points(make_instructor(*station, "haas").actor(), session, "floor_depth_max", 1, "Seen on the tooth."));
  for (int i = 0; i < 20; ++i) must(office->statements.comment(instructor, session, "Look again."));  // its numbers run ahead
  constexpr std::int64_t kHour_us = 3'600'000'000;
  office->context().clock = [] { return kNow + kHour_us; };
  must(office->statements.override_points(instructor, session, "target_removed", 8, "Seen on the screen."));
  ASSERT_GT(must(office->statements.confirm(instructor, session)).sequence, unread.sequence);
  const auto of = [&](Store& store, const Actor& reader) { return *must(store.history.details(reader, session)).grade; };
  EXPECT_TRUE(of(*office, chief).confirmation);
  at_office(results());
  at_station(office_file());
  EXPECT_FALSE(of(*office, chief).confirmation) << "the depth has another mark than the examiner saw";
  EXPECT_FALSE(of(*station, keeper).confirmation);
  must(office->statements.confirm(instructor, session));
  EXPECT_TRUE(of(*office, chief).confirmation);
  EXPECT_EQ(whole(*office), "");
  EXPECT_EQ(whole(*station), "");
}

TEST_F(ExchangeStatements, a_confirmation_is_none_of_critical_events_and_points_that_another_station_changed_unread_under_the_same_score) {
  const Account omar = make_student(*station, "2", "Omar");
  const Actor examiner = make_instructor(*station, "haas").actor();
  const SessionId pardoned = complete_session(*station, omar, keep(*station), 80, false);
  const SessionId failed_again = complete_session(*station, omar, keep(*station), 80, false), moved = attempt(omar, 80);
  const SignedStatement pardon = must(station->statements.override_critical(examiner, failed_again, "pulp_exposure", "It was open before."));
  at_office(results());
  // Nobody at the office reads these before it confirms.
  must(station->statements.override_critical(examiner, pardoned, "pulp_exposure", "It was open before."));
  const SignedStatement unread = must(station->statements.withdraw(examiner, failed_again, pardon.id, "It was not."));
  must(station->statements.override_points(examiner, moved, "target_removed", 17, "Seen on the tooth."));
  must(station->statements.override_points(examiner, moved, "floor_depth_max", 5, "Seen on the tooth."));
  for (int i = 0; i < 20; ++i) must(office->statements.comment(instructor, moved, "Look again."));  // its numbers run ahead
  constexpr std::int64_t kHour_us = 3'600'000'000;
  office->context().clock = [] { return kNow + kHour_us; };
  const auto of = [](Store& store, const Actor& reader, SessionId session) { return *must(store.history.details(reader, session)).grade; };
  for (const SessionId session : {pardoned, failed_again, moved}) {
    ASSERT_GT(must(office->statements.confirm(instructor, session)).sequence, unread.sequence);
    EXPECT_TRUE(of(*office, chief, session).confirmation);
  }
  at_office(results());
  at_station(office_file());
  for (const SessionId session : {pardoned, failed_again, moved}) {
    for (const EffectiveGrade& grade : {of(*office, chief, session), of(*station, keeper, session)}) {
      EXPECT_NEAR(grade.grade.score, 80, 1e-6);
      EXPECT_FALSE(grade.confirmation) << session.text();
    }
  }
  EXPECT_TRUE(of(*office, chief, pardoned).grade.passed);
  EXPECT_TRUE(of(*station, keeper, failed_again).needs_confirmation()) << "nobody has confirmed that it fails";
  for (const SessionId session : {pardoned, failed_again, moved}) must(office->statements.confirm(instructor, session));
  at_station(office_file());
  for (const SessionId session : {pardoned, failed_again, moved}) {
    EXPECT_TRUE(of(*office, chief, session).confirmation) << session.text();
    EXPECT_TRUE(of(*station, keeper, session).confirmation) << session.text();
  }
  EXPECT_EQ(whole(*office), "");
  EXPECT_EQ(whole(*station), "");
}

TEST_F(ExchangeStatements, an_attempt_that_its_student_rated_at_two_stations_is_charted_once_by_the_first_rating) {
  const Account lena = make_student(*office);
  at_station(office_file());
  const SessionId session = attempt(lena);
  at_office(results());
  const SelfAssessment first{{{"target_removed", OwnRating::met}}}, second{{{"target_removed", OwnRating::not_met}}};
  must(station->statements.assess_own(lena.actor(), session, first));
  constexpr std::int64_t kHour_us = 3'600'000'000;
  office->context().clock = [] { return kNow + kHour_us; };
  must(office->statements.assess_own(lena.actor(), session, second));
  at_office(results());
  EXPECT_EQ(must(office->statements.self_assessment(chief, session)), first);
  const HistoryRow row = must(office->history.details(chief, session)).row;
  const auto rated = must(office->history.rated_attempts(chief, lena.id, row.scenario, row.device_class));
  ASSERT_EQ(rated.size(), 1u);
  EXPECT_EQ(rated[0].session, session);
  EXPECT_NEAR(rated[0].points.own, 100, 1e-9);
  EXPECT_EQ(whole(*office), "");
}

TEST_F(ExchangeStatements, of_adjustments_that_two_stations_gave_the_later_one_counts) {
  for (int i = 0; i < 5; ++i) attempt(make_student(*station, "3" + std::to_string(i), "Noah"));  // its numbers run ahead of the office's
  const Account lena = make_student(*office);
  const CohortId cohort = must(office->cohorts.create(chief, "Year 2")).id;
  must(office->cohorts.add(chief, cohort, lena.id));
  const Assignment exam = must(office->assignments.create(
      instructor, {.version = keep(*office).id, .cohort = cohort, .kind = SessionKind::assessment}, "4711"));
  at_station(office_file());
  const Actor examiner = make_instructor(*station, "haas").actor();
  constexpr std::int64_t kHour_us = 3'600'000'000;
  must(station->assignments.adjust(examiner, exam.id, lena.id, {.extra_time_percent = 50}));
  office->context().clock = [] { return kNow + kHour_us; };
  must(office->assignments.adjust(instructor, exam.id, lena.id, {.extra_time_percent = 25}));
  at_station(office_file());
  const auto sits_with = [&] {
    NewSession wanted = new_session(lena, must(station->scenarios.version(exam.version)));
    wanted.assignment = exam.id;
    wanted.start_code = "4711";
    return must(station->sessions.start(lena.actor(), wanted)).header.extra_time_percent;
  };
  EXPECT_EQ(must(station->assignments.adjustment(exam.id, lena.id)).extra_time_percent, 25);
  EXPECT_EQ(sits_with(), 25);
  must(station->assignments.adjust(examiner, exam.id, lena.id, {.extra_time_percent = 10}));
  EXPECT_EQ(must(station->assignments.adjustment(exam.id, lena.id)).extra_time_percent, 10) << "its clock is an hour behind what it has read";
  EXPECT_EQ(whole(*station), "");
}

TEST_F(ExchangeStatements, reading_a_file_packs_the_attempts_of_a_week_once_and_once_more_only_what_changed) {
  const Actor examiner = make_instructor(*station, "haas").actor();
  std::vector<SessionId> sessions;
  for (int i = 0; i < 5; ++i) sessions.push_back(attempt(make_student(*station, "3" + std::to_string(i), "Noah"), 62));
  for (const SessionId session : sessions) must(station->statements.override_points(examiner, session, "target_removed", 20, "Seen on the tooth."));
  must(office->database().run("CREATE TEMP TABLE written (n)"));
  must(office->database().run("CREATE TEMP TRIGGER packed AFTER INSERT ON main.packed_attempts BEGIN INSERT INTO written VALUES (1); END"));
  const auto packed = [&] { return *must(office->database().first("SELECT count(*) FROM written", [](Row row) { return row.integer(0); })); };
  at_office(results());
  EXPECT_EQ(packed(), 1);
  for (const SessionId session : sessions) must(office->statements.comment(instructor, session, "So it is."));
  const auto before = packed();
  at_office(results());
  EXPECT_EQ(packed(), before) << "nothing has changed";
  EXPECT_EQ(whole(*office), "");
  // As an older program may have left it.
  must(office->database().run("UPDATE session_summaries SET score = 1 WHERE session = ?1", sessions.front()));
  ASSERT_NE(whole(*office), "");
  at_office(results());
  EXPECT_EQ(packed(), before + 1);
  EXPECT_EQ(whole(*office), "");
}

TEST_F(ExchangeStatements, a_statement_waits_for_its_session) {
  const fs::path away = next_file();
  const SessionId session = attempt(make_student(*station, "2", "Omar"));
  at_office(results());
  must(office->statements.comment(instructor, session, "Well done."));
  const auto third = open(folder / "third.db");
  const Actor other = make_administrator(*third, "third").actor();
  must(trust(third->context(), other, key_of_station(*office), KeyRole::office));
  must(trust(third->context(), other, key_of_station(*station), KeyRole::station));
  const fs::path file = office_file();
  EXPECT_EQ(must(read_in(third->context(), other, file)).waiting, 1u);
  must(read_in(third->context(), other, results()));
  EXPECT_EQ(must(read_in(third->context(), other, file)).counts.statements, 1u);
  EXPECT_EQ(whole(*third), "");
}

TEST_F(ExchangeStatements, an_attempt_that_went_on_from_an_old_copy_stays_apart_and_refuses_no_file_of_the_new_key) {
  const fs::path file = folder / "station.db", old = folder / "old.db";
  const auto copy = [](const fs::path& from, const fs::path& to) {
    for (const char* part : {"", ".key", ".key-counter"}) fs::copy_file(from.string() + part, to.string() + part, fs::copy_options::overwrite_existing);
  };
  const Account omar = make_student(*station, "20260002", "Omar Haddad");
  const Actor haas = make_instructor(*station, "haas").actor();
  const SessionId both = attempt(omar, 62);
  station.reset();
  copy(file, old);
  station = open(file);
  must(station->grades.save(both, small_grade(70), {}, haas));
  at_office(results());
  station.reset();
  copy(old, file);
  station = open(file);
  must(station->grades.save(both, small_grade(40, false), {}, haas));
  must(station->statements.comment(haas, both, "Of the other grade."));
  const SessionId later = attempt(omar, 90);
  EXPECT_EQ(code_of(read_in(office->context(), chief, results())), StorageError::put_back);
  station.reset();
  fs::remove(file.string() + ".key");
  station = open(file);
  must(trust(office->context(), chief, key_of_station(*station), KeyRole::station));
  const ReadIn read = at_office(results());
  EXPECT_EQ(read.apart, std::vector{both});
  EXPECT_EQ(read.counts.sessions, 1u);
  EXPECT_EQ(must(office->history.details(chief, both)).row.score, 70);
  EXPECT_TRUE(must(office->statements.of(chief, both)).empty());
  EXPECT_EQ(must(office->history.details(chief, later)).row.score, 90);
  EXPECT_EQ(whole(*office), "");
}

}  // namespace
}  // namespace cusp::test
