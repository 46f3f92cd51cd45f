#include <gtest/gtest.h>

#include "storage/summary/records_size.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {


class HistoryTest : public ::testing::Test {
 protected:
  Folder folder;
  std::shared_ptr<std::int64_t> now = std::make_shared<std::int64_t>(kNow);
  std::unique_ptr<Store> store = open(folder / "a.db", quick(now));
  Actor instructor = make_instructor(*store).actor();
  Account lena = make_student(*store);
  Account noah = make_student(*store, "20260001", "Noah Adler");
  ScenarioVersion version = keep(*store);

  SessionId attempt(const Account& student, double score, bool passed = true) {
    *now += 60'000'000;
    return complete_session(*store, student, version, score, passed);
  }
};

TEST_F(HistoryTest, a_students_list_is_newest_first_with_attempts_counted) {
  attempt(lena, 60, false);
  attempt(noah, 90);
  const SessionId last = attempt(lena, 78);
  const auto rows = must(store->history.list(lena.actor()));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].session, last);
  EXPECT_EQ(rows[0].attempt, 2);
  EXPECT_EQ(rows[0].score, 78.0);
  EXPECT_EQ(rows[0].passed, true);
  EXPECT_EQ(rows[0].pass_mark, 70.0);
  EXPECT_EQ(rows[0].elapsed_us, 36u * 83'334u);
  EXPECT_EQ(rows[0].device_class, "pointer");
  EXPECT_EQ(rows[0].title.at("en"), "Straight channel");
  EXPECT_EQ(rows[0].state, SessionState::graded);
  EXPECT_EQ(rows[1].attempt, 1);
  EXPECT_EQ(rows[1].critical, std::vector<std::string>{"pulp_exposure"});
}

TEST_F(HistoryTest, the_size_of_the_records_counts_sessions_of_any_state_and_bytes_in_whole_pages) {
  attempt(lena, 60, false);
  must(store->sessions.start(noah.actor(), new_session(noah, version)));
  const RecordsSize size = must(records_size(store->database()));
  EXPECT_EQ(size.sessions, 2u);
  EXPECT_EQ(size.page_bytes, 8192u) << "of a new file";
  EXPECT_EQ(size.bytes % size.page_bytes, 0u);
  EXPECT_GT(size.bytes, size.page_bytes) << "also while all of it stands in the log";
  must(store->database().run("ALTER TABLE session_summaries RENAME TO lost_summaries"));
  EXPECT_EQ(code_of(records_size(store->database())), StorageError::bad_statement);
}

TEST_F(HistoryTest, an_attempt_that_ended_here_without_its_grade_lacks_one_for_its_student_and_for_instructors) {
  const SessionId ended = must(store->sessions.start(lena.actor(), new_session(lena, version))).id;
  must(store->traces.append(ended, second_from(1)));
  const auto lacks = [&](const Actor& actor) { return must(store->history.lacks_grade(actor, ended)); };
  EXPECT_FALSE(lacks(lena.actor())) << "it runs";
  must(store->sessions.finish(ended, volume_after(12), "student"));
  EXPECT_TRUE(lacks(lena.actor()));
  EXPECT_TRUE(lacks(instructor));
  EXPECT_FALSE(lacks(noah.actor()));
  EXPECT_FALSE(lacks({UserId::make(), Role::administrator}));
  must(store->database().run("UPDATE sessions SET station = zeroblob(16) WHERE id = ?1", ended));
  EXPECT_FALSE(lacks(instructor)) << "another station grades its own";
  must(store->database().run("UPDATE sessions SET station = ?2 WHERE id = ?1", ended, store->context().station));
  must(store->grades.save(ended, small_grade(), {}));
  EXPECT_FALSE(lacks(lena.actor()));
}

TEST_F(HistoryTest, the_interrupted_attempts_are_those_that_can_be_resumed_or_graded) {
  attempt(lena, 60, false);
  const auto interrupted = [&](const Account& student) {
    *now += 60'000'000;
    const SessionId id = must(store->sessions.start(student.actor(), new_session(student, version))).id;
    must(store->traces.append(id, second_from(1)));
    must(store->sessions.interrupt(id, "process_gone"));
    return id;
  };
  const SessionId open_one = interrupted(lena), graded = interrupted(lena), closed = interrupted(lena),
                  resumed = interrupted(lena), newest = interrupted(lena), other_engine = interrupted(lena);
  interrupted(noah);
  must(store->grades.save(graded, small_grade(), {}));
  must(store->sessions.close(closed, "left"));
  must(store->sessions.resume(resumed, "student"));
  must(store->database().run("UPDATE session_summaries SET engine_version = engine_version - 1 WHERE session = ?1",
                             other_engine));

  const auto rows = must(store->history.interrupted(lena.actor(), lena.id));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].session, newest);
  EXPECT_EQ(rows[1].session, open_one);
  EXPECT_EQ(rows[1].state, SessionState::interrupted);
  EXPECT_EQ(rows[1].elapsed_us, 12u * 83'334u);
  EXPECT_EQ(must(store->history.interrupted(instructor, lena.id)).size(), 2u);
  EXPECT_EQ(code_of(store->history.interrupted(lena.actor(), noah.id)), StorageError::not_allowed);
}

TEST_F(HistoryTest, a_student_cannot_ask_for_another) {
  attempt(noah, 90);
  HistoryFilter filter;
  filter.student = noah.id;
  EXPECT_EQ(code_of(store->history.list(lena.actor(), filter)), StorageError::not_allowed);
  const SessionId others = attempt(noah, 91);
  EXPECT_EQ(code_of(store->history.details(lena.actor(), others)), StorageError::not_allowed);
  EXPECT_EQ(code_of(store->history.best_before(lena.actor(), others)), StorageError::not_allowed);
  EXPECT_TRUE(must(store->history.list(lena.actor())).empty());
}

TEST_F(HistoryTest, filters_narrow_and_leave_the_attempt_numbers_as_they_were) {
  attempt(lena, 60, false);
  const SessionId second = attempt(lena, 78);
  attempt(noah, 90);
  const Cohort cohort = must(store->cohorts.create(instructor, "A"));
  must(store->cohorts.add(instructor, cohort.id, noah.id));
  const auto count = [&](const HistoryFilter& filter) { return must(store->history.list(instructor, filter)).size(); };

  EXPECT_EQ(count({}), 3u);
  EXPECT_EQ(count({.student = lena.id}), 2u);
  EXPECT_EQ(count({.scenario = version.scenario}), 3u);
  EXPECT_EQ(count({.scenario = ScenarioId::make()}), 0u);
  EXPECT_EQ(count({.cohort = cohort.id}), 1u);
  EXPECT_EQ(count({.device_class = "falcon"}), 0u);
  EXPECT_EQ(count({.from_utc_us = kNow + 120'000'000}), 2u);
  EXPECT_EQ(count({.to_utc_us = kNow + 120'000'000}), 1u);
  EXPECT_EQ(count({.passed = false}), 1u);
  EXPECT_EQ(count({.search = "BRANDT"}), 2u);
  EXPECT_EQ(count({.search = "2026000"}), 1u);
  EXPECT_EQ(count({.search = "%"}), 0u);
  EXPECT_EQ(count({.scripted = true}), 0u);
  EXPECT_EQ(count({.scripted = false}), 3u);
  EXPECT_EQ(count({.limit = 2}), 2u);
  const auto passed = must(store->history.list(instructor, {.student = lena.id, .passed = true}));
  ASSERT_EQ(passed.size(), 1u);
  EXPECT_EQ(passed[0].session, second);
  EXPECT_EQ(passed[0].attempt, 2);
}

TEST_F(HistoryTest, sessions_of_one_moment_keep_their_order) {
  const SessionId first = complete_session(*store, lena, version, 1);
  const SessionId second = complete_session(*store, lena, version, 2);
  const auto rows = must(store->history.list(lena.actor()));
  EXPECT_EQ(rows[0].session, second);
  EXPECT_EQ(rows[1].session, first);
  EXPECT_EQ(rows[0].attempt, 2);
}

TEST_F(HistoryTest, guests_and_try_outs_are_in_no_list_but_show_their_own_details) {
  const Account guest = make_guest(*store);
  const SessionId tried = complete_session(*store, guest, version);
  NewSession out = new_session(Account{.id = instructor.id}, version);
  out.kind = SessionKind::try_out;
  must(store->sessions.start(instructor, out));
  EXPECT_TRUE(must(store->history.list(instructor)).empty());
  const auto details = must(store->history.details(guest.actor(), tried));
  EXPECT_EQ(details.session.kind, SessionKind::try_it);
  EXPECT_EQ(details.grade->grade.score, 81.5);
  EXPECT_EQ(details.row.attempt, 1);
}

TEST_F(HistoryTest, details_hold_all_of_a_session) {
  const SessionId id = attempt(lena, 81.5);
  must(store->statements.comment(instructor, id, "Good."));
  const auto details = must(store->history.details(lena.actor(), id));
  EXPECT_EQ(details.row.session, id);
  EXPECT_EQ(details.session.header.guard.limit_n, 3.3);
  EXPECT_EQ(details.events.size(), 3u);
  EXPECT_EQ(details.grade->grade.criteria.size(), 2u);
  ASSERT_EQ(details.removed.size(), 1u);
  EXPECT_EQ(details.removed[0].voxels, 250u);
  EXPECT_EQ(details.comments.size(), 1u);
  EXPECT_EQ(code_of(store->history.details(lena.actor(), SessionId::make())), StorageError::not_found);
}

TEST_F(HistoryTest, the_best_before_is_the_earlier_of_two_alike_and_never_a_later_one) {
  const SessionId first = attempt(lena, 60);
  const SessionId best = attempt(lena, 78);
  attempt(lena, 78);
  const SessionId now_one = attempt(lena, 70);
  attempt(lena, 99);
  attempt(noah, 100);
  EXPECT_EQ(must(store->history.best_before(lena.actor(), now_one))->session, best);
  EXPECT_FALSE(must(store->history.best_before(lena.actor(), first)));
  EXPECT_EQ(must(store->history.attempts(lena.actor(), lena.id, version.scenario)), 5);
}

TEST_F(HistoryTest, standings_count_attempts_and_name_best_and_last) {
  const SessionId best = attempt(lena, 78);
  const SessionId last = attempt(lena, 60);
  must(store->sessions.start(lena.actor(), new_session(lena, version)));  // not graded
  const auto standings = must(store->history.standings(lena.actor(), lena.id));
  ASSERT_EQ(standings.size(), 1u);
  EXPECT_EQ(standings[0].attempts, 3);
  EXPECT_EQ(standings[0].best->session, best);
  EXPECT_EQ(standings[0].last->session, last);
}

TEST_F(HistoryTest, standings_leave_out_what_a_scripted_operator_drilled) {
  const SessionId own = attempt(lena, 40, false);
  NewSession scripted = new_session(lena, version);
  scripted.operator_name = "expert";
  const SessionId played = must(store->sessions.start(lena.actor(), scripted)).id;
  must(store->traces.append(played, second_from(1)));
  must(store->sessions.finish(played, volume_after(12), "student"));
  must(store->grades.save(played, small_grade(100), {}));
  ASSERT_EQ(must(store->history.list(lena.actor())).size(), 2u);
  const auto standings = must(store->history.standings(lena.actor(), lena.id));
  ASSERT_EQ(standings.size(), 1u);
  EXPECT_EQ(standings[0].attempts, 1);
  EXPECT_EQ(standings[0].best->session, own);
  EXPECT_FALSE(standings[0].passed);
}

TEST_F(HistoryTest, the_newest_comment_is_that_of_the_newest_commented_session) {
  EXPECT_FALSE(must(store->history.newest_comment(lena.actor(), lena.id)));
  const SessionId first = attempt(lena, 60), second = attempt(lena, 70);
  attempt(lena, 80);
  must(store->statements.comment(instructor, second, "Better."));
  *now += 1'000'000;
  must(store->statements.comment(instructor, second, "Mind the wall.", {.tick = 12}));
  must(store->statements.comment(instructor, first, "Later, on an older one."));
  const auto newest = must(store->history.newest_comment(lena.actor(), lena.id));
  ASSERT_TRUE(newest);
  EXPECT_EQ(newest->comment.text, "Mind the wall.");
  EXPECT_EQ(newest->comment.session, second);
  EXPECT_EQ(newest->started_utc_us, kNow + 120'000'000);
}

TEST_F(HistoryTest, practice_and_assessments_are_listed_and_counted_apart) {
  const CohortId cohort = must(store->cohorts.create(instructor, "Year 3")).id;
  must(store->cohorts.add(instructor, cohort, lena.id));
  const SessionId practised = attempt(lena, 60, false);
  NewSession wanted = new_session(lena, version);
  wanted.kind = SessionKind::assessment;
  wanted.start_code = "4711";
  wanted.assignment =
      must(store->assignments.create(instructor, {.version = version.id, .cohort = cohort, .kind = SessionKind::assessment}, "4711")).id;
  const SessionId examined = must(store->sessions.start(lena.actor(), wanted)).id;
  must(store->traces.append(examined, second_from(1)));
  must(store->sessions.finish(examined, volume_after(12), "student"));
  must(store->grades.save(examined, small_grade(90), {}));
  for (const auto& [kind, session] : {std::pair{SessionKind::practice, practised}, {SessionKind::assessment, examined}})
    for (const std::optional<UserId> student : {std::optional<UserId>{}, std::optional(lena.id)}) {
      const HistoryFilter filter{.student = student, .kind = kind};
      const auto rows = must(store->history.list(instructor, filter));
      ASSERT_EQ(rows.size(), 1u);
      EXPECT_EQ(rows[0].session, session);
      EXPECT_EQ(must(store->history.figures(instructor, filter)).attempts, 1);
    }
  EXPECT_TRUE(must(verify_store(store->context())).intact());
}

TEST_F(HistoryTest, a_name_is_found_in_any_case_also_beyond_ascii) {
  const Account ozlem = make_student(*store, "20260002", "Özlem Çelik");
  attempt(ozlem, 80);
  attempt(make_student(*store, "20260003", "Юлия Ковач"), 70);
  attempt(make_student(*store, "20260004", "Άννα Ώρα"), 75);
  attempt(make_student(*store, "20260005", "ΝΙΚΟΣ Παππάς"), 65);
  attempt(lena, 60, false);
  const auto found = [&](const char* text) { return must(store->history.list(instructor, {.search = text})).size(); };
  for (const char* text : {"özlem", "ÖZLEM", "Öz", "çELIK", "ковач", "άννα", "ώρα", "νικος", "ΠΑΠΠΆΣ"}) {
    EXPECT_EQ(found(text), 1u) << text;
    EXPECT_EQ(must(store->history.figures(instructor, {.search = text})).attempts, 1) << text;
  }
  EXPECT_EQ(found("ozlem"), 0u);
}

TEST_F(HistoryTest, an_exercise_stays_passed_when_an_attempt_with_more_points_fails) {
  attempt(lena, 78);
  const SessionId opened_pulp = attempt(lena, 92, false);
  const auto standings = must(store->history.standings(lena.actor(), lena.id));
  ASSERT_EQ(standings.size(), 1u);
  EXPECT_EQ(standings[0].best->session, opened_pulp);
  EXPECT_TRUE(standings[0].passed);
  attempt(noah, 92, false);
  EXPECT_FALSE(must(store->history.standings(noah.actor(), noah.id)).at(0).passed);
}

}  // namespace
}  // namespace cusp::test
