/// A student's own assessment: given once and before the result, kept as a statement, erased with the student's texts, and set beside
/// what was measured.
#include <gtest/gtest.h>

#include "storage/records/self_assessment.h"
#include "storage/retention/thinning.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

/// Of small_grade(): the target has 18 of 20 points, the depth 4 of 10.
const SelfAssessment kOwn{{{"target_removed", OwnRating::met}, {"floor_depth_max", OwnRating::partly}}};

struct SelfAssessmentTest : ::testing::Test {
  Folder folder;
  std::unique_ptr<Store> store = open(folder / "a.db");
  Actor administrator = make_administrator(*store).actor();
  Actor instructor = make_instructor(*store).actor();
  Account lena = make_student(*store), omar = make_student(*store, "20260002", "Omar Haddad");
  ScenarioVersion version = keep(*store);

  Statements& statements() { return store->statements; }
  std::optional<SelfAssessment> own(const Actor& reader, SessionId session) { return must(statements().self_assessment(reader, session)); }
  SessionId sit() {
    const CohortId cohort = must(store->cohorts.create(instructor, "Year 2")).id;
    must(store->cohorts.add(instructor, cohort, lena.id));
    const Assignment exam =
        must(store->assignments.create(instructor, {.version = version.id, .cohort = cohort, .kind = SessionKind::assessment}, "4711"));
    NewSession wanted = new_session(lena, version);
    wanted.assignment = exam.id;
    wanted.start_code = "4711";
    const SessionId session = must(store->sessions.start(lena.actor(), wanted)).id;
    must(store->traces.append(session, second_from(1)));
    must(store->sessions.finish(session, volume_after(12), "student"));
    must(store->grades.save(session, small_grade(), {}));
    return session;
  }
  void expect_whole() {
    const auto whole = must(verify_store(store->context()));
    EXPECT_TRUE(whole.intact()) << (whole.findings.empty() ? "" : whole.findings[0].table + " " + whole.findings[0].what);
  }
};

TEST_F(SelfAssessmentTest, is_read_by_its_student_and_by_staff_and_the_records_stay_whole) {
  const SessionId id = complete_session(*store, lena, version);
  EXPECT_FALSE(own(lena.actor(), id));
  must(statements().assess_own(lena.actor(), id, kOwn));
  EXPECT_EQ(own(lena.actor(), id), kOwn);
  EXPECT_EQ(own(instructor, id), kOwn);
  EXPECT_EQ(own(administrator, id), kOwn);
  EXPECT_EQ(code_of(statements().self_assessment(omar.actor(), id)), StorageError::not_allowed);
  EXPECT_EQ(must(store->history.details(instructor, id)).row.score, 81.5) << "it changes no point";
  expect_whole();
}

TEST_F(SelfAssessmentTest, is_given_once_by_its_student_and_of_criteria_that_the_grade_has) {
  const SessionId id = complete_session(*store, lena, version);
  EXPECT_EQ(statements().assess_own(omar.actor(), id, kOwn).error().where, "own_session");
  EXPECT_EQ(statements().assess_own(instructor, id, kOwn).error().where, "own_session");
  EXPECT_EQ(statements().assess_own(lena.actor(), id, {{{"colour", OwnRating::met}}}).error().where, "criterion");
  EXPECT_EQ(code_of(statements().assess_own(lena.actor(), SessionId::make(), kOwn)), StorageError::not_found);
  const SignedStatement given = must(statements().assess_own(lena.actor(), id, kOwn));
  EXPECT_EQ(statements().assess_own(lena.actor(), id, {}).error().where, "self_assessment");
  EXPECT_EQ(statements().withdraw(instructor, id, given.id, "Not hers.").error().where, "self_assessment");
  EXPECT_EQ(own(instructor, id), kOwn);
  const SessionId running = must(store->sessions.start(lena.actor(), new_session(lena, version))).id;
  EXPECT_EQ(code_of(statements().assess_own(lena.actor(), running, kOwn)), StorageError::wrong_state);
}

TEST_F(SelfAssessmentTest, that_is_skipped_is_kept_as_skipped) {
  const SessionId id = complete_session(*store, lena, version);
  must(statements().assess_own(lena.actor(), id, {}));
  ASSERT_TRUE(own(instructor, id));
  EXPECT_TRUE(own(instructor, id)->skipped());
  EXPECT_TRUE(must(store->history.rated_attempts(lena.actor(), lena.id, version.scenario, "pointer")).empty());
  expect_whole();
}

TEST_F(SelfAssessmentTest, of_an_assessment_comes_before_its_release) {
  const SessionId id = sit();
  must(statements().assess_own(lena.actor(), id, kOwn));
  EXPECT_EQ(own(lena.actor(), id), kOwn) << "while the result is withheld";
  EXPECT_TRUE(must(store->history.rated_attempts(lena.actor(), lena.id, version.scenario, "pointer")).empty()) << "its points would show";
  EXPECT_EQ(must(store->history.rated_attempts(instructor, lena.id, version.scenario, "pointer")).size(), 1u);
  must(statements().release(instructor, id));
  EXPECT_EQ(must(store->history.rated_attempts(lena.actor(), lena.id, version.scenario, "pointer")).size(), 1u);
}

TEST_F(SelfAssessmentTest, after_the_release_is_refused) {
  const SessionId id = sit();
  must(statements().release(instructor, id));
  EXPECT_EQ(statements().assess_own(lena.actor(), id, kOwn).error().where, "released");
}

TEST_F(SelfAssessmentTest, is_erased_with_its_student_and_the_records_stay_whole) {
  const SessionId id = complete_session(*store, lena, version);
  must(statements().assess_own(lena.actor(), id, kOwn));
  must(store->accounts.erase(administrator, lena.id));
  EXPECT_FALSE(own(instructor, id));
  EXPECT_EQ(must(statements().of(instructor, id)).size(), 1u) << "that there was one stays";
  expect_whole();
}

TEST_F(SelfAssessmentTest, that_somebody_changes_by_hand_is_named) {
  const SessionId id = complete_session(*store, lena, version);
  must(statements().assess_own(lena.actor(), id, kOwn));
  must(store->database().run(R"(UPDATE statement_texts SET text = '{"target_removed":"not_met"}')"));
  const auto findings = must(check_statements(store->database()));
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].table, "statement_texts");
  EXPECT_EQ(findings[0].owner, id.uuid);
}

TEST_F(SelfAssessmentTest, keeps_no_recording_from_being_thinned) {
  const SessionId id = complete_session(*store, lena, version);
  must(statements().assess_own(lena.actor(), id, kOwn));
  const auto later = open(folder / "a.db", quick(std::make_shared<std::int64_t>(kNow + 100 * 86'400'000'000)));
  EXPECT_EQ(must(thin_traces(later->context(), administrator, {.mode = ThinningMode::carry_out})).attempts, 1u);
  EXPECT_EQ(own(instructor, id), kOwn);
  expect_whole();
}

TEST_F(SelfAssessmentTest, stands_beside_what_was_measured_in_points_of_the_rated_criteria) {
  must(statements().assess_own(lena.actor(), complete_session(*store, lena, version), kOwn));
  const SessionId second = complete_session(*store, lena, version);
  must(statements().assess_own(lena.actor(), second, {{{"floor_depth_max", OwnRating::met}}}));
  complete_session(*store, lena, version);
  const auto rated = must(store->history.rated_attempts(lena.actor(), lena.id, version.scenario, "pointer"));
  ASSERT_EQ(rated.size(), 2u);
  EXPECT_EQ(rated[0].points.criteria, 2);
  EXPECT_NEAR(rated[0].points.own, 100.0 * (20 + 5) / 30, 1e-9);
  EXPECT_NEAR(rated[0].points.measured, 100.0 * (18 + 4) / 30, 1e-9);
  EXPECT_EQ(rated[1].session, second);
  EXPECT_EQ(rated[1].attempt, 2);
  EXPECT_NEAR(rated[1].points.own, 100, 1e-9);
  EXPECT_NEAR(rated[1].points.measured, 40, 1e-9);
  must(statements().override_points(instructor, second, "floor_depth_max", 10, "Worn."));
  EXPECT_NEAR(must(store->history.rated_attempts(lena.actor(), lena.id, version.scenario, "pointer"))[1].points.measured, 100, 1e-9)
      << "what counts is compared";
  EXPECT_EQ(code_of(store->history.rated_attempts(omar.actor(), lena.id, version.scenario, "pointer")), StorageError::not_allowed);
}

TEST(SelfAssessmentText, reads_back_and_refuses_what_it_never_writes) {
  EXPECT_EQ(self_assessment_from(text_of(kOwn)), kOwn);
  EXPECT_EQ(self_assessment_from(text_of({})), SelfAssessment{});
  for (const char* text : {"", "x", "[]", R"({"a":1})", R"({"a":"good"})", R"({"a":null})"}) EXPECT_FALSE(self_assessment_from(text)) << text;
}

TEST(SelfAssessmentText, compares_with_three_steps_of_the_measured_points) {
  Grade grade;
  grade.criteria.resize(2);
  grade.criteria[0].points_max = 10;
  grade.criteria[1].points_max = 90;
  const auto at = [&](double points) {
    grade.criteria[0].points = points;
    return measured_rating(grade, grade.criteria[0]);
  };
  EXPECT_EQ(at(10), OwnRating::met);
  EXPECT_EQ(at(9.96), OwnRating::met) << "the report shows full points";
  EXPECT_EQ(at(9.9), OwnRating::partly);
  EXPECT_EQ(at(5), OwnRating::partly);
  EXPECT_EQ(at(4.9), OwnRating::not_met);
}

TEST(SelfAssessmentText, compares_with_points_of_the_score_whatever_the_weights_sum_to) {
  Grade in_weights;  // a third of the points is lost, then a thousandth
  in_weights.criteria.resize(2);
  const auto of = [&](double lost, double whole) {
    in_weights.criteria[0].points_max = 0.1 * whole;
    in_weights.criteria[0].points = (1 - lost) * 0.1 * whole;
    in_weights.criteria[1].points_max = 0.9 * whole;
    return measured_rating(in_weights, in_weights.criteria[0]);
  };
  for (const double whole : {1.0, 30.0, 100.0, 1000.0}) {
    EXPECT_EQ(of(1.0 / 3, whole), OwnRating::partly) << whole;
    EXPECT_EQ(of(0.001, whole), OwnRating::met) << whole;
    EXPECT_EQ(of(0.9, whole), OwnRating::not_met) << whole;
  }
}

}  // namespace
}  // namespace cusp::test
