/// Assigned attempts: who may begin one, when and how often; and that the result of an assessment is withheld until release.
#include <gtest/gtest.h>

#include "storage/records/session_summary.h"
#include "tests/storage/assessments.h"

namespace cusp::test {
namespace {

TEST_F(AssessmentTest, an_assigned_attempt_takes_its_kind_from_the_assignment) {
  const Assignment practice = assign(SessionKind::practice), exam = assign(SessionKind::assessment);
  EXPECT_EQ(must(begin(lena, practice)).kind, SessionKind::practice);
  const Session session = must(begin(lena, exam));
  EXPECT_EQ(session.kind, SessionKind::assessment);
  EXPECT_EQ(session.assignment, exam.id);
  EXPECT_EQ(must(store->assignments.attempts(exam.id, lena.id)), 1);
  EXPECT_EQ(must(store->history.of_assignment(instructor, exam.id)).size(), 1u);
  EXPECT_EQ(must(store->history.of_assignment(lena.actor(), exam.id)).size(), 1u);
  EXPECT_TRUE(must(store->history.of_assignment(omar.actor(), exam.id)).empty()) << "a student reads own attempts alone";
}

TEST_F(AssessmentTest, it_begins_between_its_dates_as_often_as_allowed_with_the_code_by_its_students) {
  const Assignment exam = assign(SessionKind::assessment, 1);
  EXPECT_EQ(refusal(begin(omar, exam)), "assignment");
  EXPECT_EQ(refusal(begin(lena, exam, "4712")), "start_code");
  EXPECT_EQ(refusal(begin(lena, exam, "")), "start_code");
  EXPECT_EQ(admission(lena, exam, "4712"), "start_code");
  EXPECT_EQ(admission(lena, exam, "4711"), "admitted");
  EXPECT_EQ(must(store->assignments.attempts(exam.id, lena.id)), 0);
  *now = kNow - 1;
  EXPECT_EQ(refusal(begin(lena, exam)), "not_open");
  *now = kNow + kHour;
  EXPECT_EQ(refusal(begin(lena, exam)), "past_due");
  *now = kNow;
  EXPECT_EQ(refusal(begin(lena, exam)), "begun");
  EXPECT_EQ(refusal(begin(lena, exam)), "attempts_used");
}

TEST_F(AssessmentTest, a_withdrawn_assignment_admits_no_further_attempt_and_keeps_those_that_were_begun) {
  const Assignment exam = assign(SessionKind::assessment);
  const SessionId sat = sit(exam, 81, true), left = must(begin(lena, exam)).id;
  must(store->sessions.interrupt(left, "process_gone"));
  EXPECT_EQ(code_of(store->assignments.withdraw(lena.actor(), exam.id)), StorageError::not_allowed);
  must(store->assignments.withdraw(instructor, exam.id));
  EXPECT_EQ(code_of(store->assignments.withdraw(instructor, exam.id)), StorageError::duplicate);
  EXPECT_TRUE(must(store->assignments.find(exam.id)).withdrawn);
  EXPECT_TRUE(must(store->assignments.for_student(lena.id)).at(0).withdrawn);
  EXPECT_EQ(admission(lena, exam, "4712"), "start_code");
  EXPECT_EQ(admission(lena, exam, "4711"), "withdrawn");
  EXPECT_EQ(refusal(begin(lena, exam)), "withdrawn");
  must(store->sessions.resume(left, "student"));
  must(store->statements.release(instructor, sat));
  EXPECT_EQ(seen(sat), "81");
}

TEST_F(AssessmentTest, an_adjustment_is_of_one_student_in_one_assignment_and_of_attempts_that_begin_afterwards) {
  const Assignment exam = assign(SessionKind::assessment), other = assign(SessionKind::assessment);
  const auto give = [&](const Actor& actor, UserId student, int percent) {
    const auto done = store->assignments.adjust(actor, exam.id, student, {.extra_time_percent = percent});
    return done ? "given" : done.error().where;
  };
  const Session without = must(begin(lena, exam));
  EXPECT_EQ(give(instructor, lena.id, 25), "given");
  EXPECT_EQ(give(lena.actor(), lena.id, 25), "assign");
  EXPECT_EQ(give(instructor, omar.id, 25), "assignment") << "not in the cohort";
  for (const int percent : {-1, kMostExtraTimePercent + 1}) EXPECT_EQ(give(instructor, lena.id, percent), "extra_time");
  EXPECT_EQ(must(store->sessions.find(without.id)).header.extra_time_percent, 0);
  EXPECT_EQ(must(begin(lena, exam)).header.extra_time_percent, 25);
  EXPECT_EQ(must(begin(lena, other)).header.extra_time_percent, 0);
  EXPECT_EQ(give(instructor, lena.id, 0), "given");
  EXPECT_EQ(must(begin(lena, exam)).header.extra_time_percent, 0) << "the newest counts";
  EXPECT_EQ(must(store->assignments.adjustment(exam.id, lena.id)), Adjustment{});
  const Adjustment both{.extra_time_percent = 50, .large_text = true};
  must(store->assignments.adjust(instructor, exam.id, lena.id, both));
  EXPECT_EQ(must(store->assignments.adjustment(exam.id, lena.id)), both);
  const SessionHeader header = must(begin(lena, exam)).header;
  EXPECT_EQ((Adjustment{header.extra_time_percent, header.large_text}), both);
  EXPECT_FALSE(must(begin(lena, other)).header.large_text);
  EXPECT_FALSE(must(store->sessions.find(without.id)).header.large_text);
  EXPECT_TRUE(must(verify_store(store->context())).intact());
}

TEST_F(AssessmentTest, it_begins_with_a_device_of_a_class_that_the_assignment_admits) {
  const auto assign_for = [&](std::vector<std::string> classes) {
    return store->assignments.create(instructor, {.version = version.id, .cohort = cohort, .device_classes = std::move(classes)});
  };
  const auto with = [&](const std::string& device_class, const Assignment& assignment) {
    NewSession wanted = new_session(lena, version);
    wanted.assignment = assignment.id;
    wanted.header.device.device_class = device_class;
    const auto done = store->sessions.admit(lena.actor(), wanted);
    EXPECT_EQ(store->sessions.start(lena.actor(), wanted).has_value(), done.has_value()) << "start() says what admit() says";
    return done ? "admitted" : done.error().where + " instead of " + done.error().detail;
  };
  const Assignment any = must(assign_for({})), force = must(assign_for({"inverse3", "falcon", "falcon"}));
  EXPECT_EQ(must(store->assignments.find(force.id)).device_classes, (std::vector<std::string>{"falcon", "inverse3"}));
  EXPECT_TRUE(must(store->assignments.find(any.id)).device_classes.empty());
  EXPECT_EQ(with("pointer", any), "admitted");
  EXPECT_EQ(with("inverse3", force), "admitted");
  EXPECT_EQ(with("pointer", force), "pointer instead of falcon inverse3");
  EXPECT_EQ(with("", force), " instead of falcon inverse3");
  for (const char* wrong : {"", "Falcon", "a b", "é"}) EXPECT_EQ(assign_for({wrong}).error().where, "device_classes") << wrong;
  EXPECT_TRUE(must(verify_store(store->context())).intact());
}

TEST_F(AssessmentTest, a_drawn_tooth_begins_with_its_exercise_which_the_session_keeps) {
  const Assignment wish{.version = version.id, .cohort = cohort, .kind = SessionKind::assessment, .drawn_tooth = true};
  const Assignment exam = must(store->assignments.create(instructor, wish, "4711"));
  EXPECT_TRUE(must(store->assignments.find(exam.id)).drawn_tooth);
  NewSession wanted = new_session(lena, version);
  wanted.assignment = exam.id;
  wanted.start_code = "4711";
  EXPECT_TRUE(store->sessions.admit(lena.actor(), wanted)) << "the tooth is drawn once the student is admitted";
  EXPECT_EQ(store->sessions.start(lena.actor(), wanted).error().where, "exercise");
  wanted.header.exercise = "{\"specimen\": {\"seed\": 17}}";
  const Session session = must(store->sessions.start(lena.actor(), wanted));
  EXPECT_EQ(must(store->sessions.find(session.id)).header.exercise, wanted.header.exercise);
  EXPECT_TRUE(must(verify_store(store->context())).intact());
}

TEST_F(AssessmentTest, only_an_assessment_that_draws_a_tooth_takes_another_exercise_than_its_versions) {
  NewSession practice = new_session(lena, version);
  practice.header.exercise = "{}";
  EXPECT_EQ(store->sessions.start(lena.actor(), practice).error().where, "exercise");
  const Assignment wish{.version = version.id, .cohort = cohort, .kind = SessionKind::practice, .drawn_tooth = true};
  EXPECT_EQ(store->assignments.create(instructor, wish).error().where, "drawn_tooth");
}

TEST_F(AssessmentTest, who_was_switched_off_at_another_window_reads_that_and_begins_nothing) {
  const Assignment exam = assign(SessionKind::assessment);
  must(store->accounts.disable(make_administrator(*store).actor(), lena.id));
  for (const auto& begun : {begin(lena, exam), store->sessions.start(lena.actor(), new_session(lena, version))}) {
    EXPECT_EQ(code_of(begun), StorageError::disabled);
    EXPECT_EQ(begun.error().where, "actor");
  }
}

TEST_F(AssessmentTest, a_start_code_has_4_to_32_characters_whatever_their_bytes) {
  const auto where = [&](std::size_t count) {
    std::string code;
    for (std::size_t i = 0; i < count; ++i) code += "\xC3\xBC";
    const auto made = store->assignments.create(instructor, {.version = version.id, .cohort = cohort, .kind = SessionKind::assessment}, code);
    return made ? "made" : made.error().where;
  };
  for (const std::size_t count : {kLeastStartCode - 1, kMostStartCode + 1}) EXPECT_EQ(where(count), "start_code") << count;
  for (const std::size_t count : {kLeastStartCode, kMostStartCode}) EXPECT_EQ(where(count), "made") << count;
}

TEST_F(AssessmentTest, an_assessment_without_assignment_or_of_another_version_does_not_begin) {
  NewSession wanted = new_session(lena, version);
  wanted.kind = SessionKind::assessment;
  EXPECT_EQ(refusal(store->sessions.start(lena.actor(), wanted)), "assignment");
  const Assignment exam = assign(SessionKind::assessment);
  Scenario other = small_scenario();
  other.id = *ScenarioId::parse("018f0000-0000-7000-8000-000000000002");
  wanted.version = keep(*store, other, "{\"id\":2}").id;
  wanted.assignment = exam.id;
  wanted.start_code = "4711";
  EXPECT_EQ(refusal(store->sessions.start(lena.actor(), wanted)), "assignment");
}

TEST_F(AssessmentTest, an_interrupted_attempt_continues_after_the_due_moment) {
  const SessionId id = must(begin(lena, assign(SessionKind::assessment, 1))).id;
  must(store->sessions.interrupt(id, "process_gone"));
  *now = kNow + 2 * kHour;
  must(store->sessions.resume(id, "student"));
}

TEST_F(AssessmentTest, the_student_reads_no_result_in_any_way_until_it_is_released) {
  const SessionId id = sit(assign(SessionKind::assessment), 81, true);
  must(store->statements.comment(instructor, id, "A good floor."));
  const Actor student = lena.actor();
  const auto withheld = must(store->history.details(student, id));
  EXPECT_FALSE(withheld.row.score || withheld.row.passed || withheld.row.released);
  EXPECT_EQ(withheld.row.state, SessionState::finished);
  EXPECT_FALSE(withheld.grade);
  EXPECT_TRUE(withheld.comments.empty());
  EXPECT_TRUE(withheld.removed.empty());
  EXPECT_FALSE(must(store->history.details(instructor, id)).removed.empty());
  EXPECT_FALSE(must(store->history.list(student)).front().score);
  EXPECT_TRUE(must(store->history.list(student, {.passed = true})).empty());
  EXPECT_FALSE(must(store->history.standings(student, lena.id)).front().best);
  EXPECT_FALSE(must(store->history.newest_comment(student, lena.id)));
  EXPECT_TRUE(must(store->statements.of(student, id)).empty());
  EXPECT_EQ(store->history.may_read_result(student, id).error().where, "withheld");
  EXPECT_TRUE(store->history.may_read_result(instructor, id));
  EXPECT_EQ(must(store->history.figures(student)).attempts, 0);
  const SessionId later = complete_session(*store, lena, version);
  EXPECT_FALSE(must(store->history.best_before(student, later)));
  EXPECT_EQ(must(store->history.details(instructor, id)).row.score, 81);

  must(store->statements.release(instructor, id));
  EXPECT_TRUE(store->history.may_read_result(student, id));
  EXPECT_EQ(must(store->history.details(student, id)).row.score, 81);
  EXPECT_EQ(must(store->history.details(student, id)).comments.size(), 1u);
  EXPECT_EQ(must(store->history.best_before(student, later))->session, id);
  EXPECT_TRUE(must(verify_store(store->context())).intact());
}

TEST_F(AssessmentTest, a_failed_result_is_released_only_when_a_person_has_confirmed_it) {
  const SessionId id = sit(assign(SessionKind::assessment), 40, false);
  const auto refused = store->statements.release(instructor, id);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, "confirmation");
  must(store->statements.confirm(instructor, id));
  must(store->statements.release(instructor, id));
  EXPECT_EQ(code_of(store->statements.release(instructor, id)), StorageError::wrong_state);
}

TEST_F(AssessmentTest, a_release_is_out_of_force_while_a_result_that_was_lowered_afterwards_awaits_its_confirmation) {
  const SessionId id = sit(assign(SessionKind::assessment), 37, false);
  must(store->statements.confirm(instructor, id));
  must(store->statements.release(instructor, id));
  EXPECT_EQ(seen(id), "37");
  const SignedStatement lowered = must(store->statements.override_points(instructor, id, "target_removed", 0, "Not cut."));
  EXPECT_EQ(seen(id), "withheld");
  EXPECT_EQ(store->statements.release(instructor, id).error().where, "confirmation");
  must(store->statements.confirm(instructor, id));
  EXPECT_EQ(seen(id), "19");
  EXPECT_EQ(store->statements.release(instructor, id).error().where, "released");
  must(store->statements.withdraw(instructor, id, lowered.id, "It was cut."));
  EXPECT_EQ(seen(id), "withheld") << "the result changed again";
}

TEST_F(AssessmentTest, a_pass_that_becomes_a_fail_after_its_release_is_withheld_until_it_passes_or_is_confirmed) {
  const SessionId id = sit(assign(SessionKind::assessment), 72, true);
  must(store->statements.release(instructor, id));
  const SignedStatement lowered = must(store->statements.override_points(instructor, id, "target_removed", 0, "Not cut."));
  EXPECT_EQ(seen(id), "withheld");
  must(store->statements.withdraw(instructor, id, lowered.id, "It was cut."));
  EXPECT_EQ(seen(id), "72");
  must(store->grades.save(id, small_grade(40, false), {}, instructor));
  EXPECT_EQ(seen(id), "withheld") << "graded again";
  must(store->statements.confirm(instructor, id));
  EXPECT_EQ(seen(id), "40");
}

TEST_F(AssessmentTest, a_rebuild_withholds_what_awaits_its_confirmation_and_verification_names_a_summary_that_does_not) {
  const Actor administrator = make_administrator(*store).actor();
  const SessionId id = sit(assign(SessionKind::assessment), 72, true);
  must(store->statements.release(instructor, id));
  must(store->statements.override_points(instructor, id, "target_removed", 0, "Not cut."));
  EXPECT_EQ(must(rebuild_summaries(store->context(), administrator)), 0u);
  EXPECT_EQ(seen(id), "withheld");
  must(store->database().run("UPDATE session_summaries SET released = 1"));
  const auto findings = must(verify_store(store->context())).findings;
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings[0].what, "released");
  EXPECT_GT(must(rebuild_summaries(store->context(), administrator)), 0u);
  EXPECT_EQ(seen(id), "withheld");
}

TEST_F(AssessmentTest, a_withdrawn_release_withholds_the_result_again) {
  const SessionId id = sit(assign(SessionKind::assessment), 81, true);
  const SignedStatement release = must(store->statements.release(instructor, id));
  must(store->statements.withdraw(instructor, id, release.id, "An appeal is open."));
  EXPECT_FALSE(must(store->history.details(lena.actor(), id)).row.score);
  EXPECT_TRUE(must(verify_store(store->context())).intact());
}

TEST_F(AssessmentTest, a_candidate_has_the_same_number_each_time_and_another_one_elsewhere) {
  const AssignmentId a = AssignmentId::make(), b = AssignmentId::make();
  EXPECT_EQ(candidate_number(a, lena.id), candidate_number(a, lena.id));
  EXPECT_NE(candidate_number(a, lena.id), candidate_number(b, lena.id));
  EXPECT_NE(candidate_number(a, lena.id), candidate_number(a, omar.id));
  EXPECT_EQ(candidate_number(a, lena.id).size(), 7u);
}

}  // namespace
}  // namespace cusp::test
