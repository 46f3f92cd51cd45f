// The tooth that an assessment draws for a candidate: always the same one, checked, and kept with the session.

#include "ui/session/drawn_tooth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "tests/modules.h"
#include "tests/ui/session/small_exercise.h"
#include "ui/session/replay.h"
#include "ui/session/session_setup.h"

namespace cusp::test {
namespace {

const AssignmentId kExam = AssignmentId::make();
const UserId kLena = UserId::make(), kOmar = UserId::make();

/// On coarse voxels, which grow in a tenth of the time.
Scenario class_1() {
  Scenario out = load_builtin("class-1-46").value();
  out.specimen.voxel_mm = 0.2;
  return out;
}

Outcome<std::shared_ptr<const Specimen>> grown(const Scenario& exercise) {
  return Specimen::build(make_specimen(exercise.specimen, {}).value(), Reading::banded);
}

/// The same tooth with nothing but pulp: no target suits it.
Outcome<std::shared_ptr<const Specimen>> all_pulp(const Scenario& exercise) {
  VoxelVolume voxels = make_specimen(exercise.specimen, {}).value();
  for (Tissue& tissue : voxels.tissue)
    if (tissue != Tissue::empty) tissue = Tissue::pulp;
  return Specimen::build(voxels, Reading::banded);
}

/// The same tooth without its pulp: nothing is measured over it.
Outcome<std::shared_ptr<const Specimen>> without_pulp(const Scenario& exercise) {
  VoxelVolume voxels = make_specimen(exercise.specimen, {}).value();
  for (Tissue& tissue : voxels.tissue)
    if (tissue == Tissue::pulp) tissue = Tissue::dentine;
  return Specimen::build(voxels, Reading::banded);
}

TEST(DrawnTooth, HasASeedForEachCandidateAndDrawThatIsAlwaysTheSame) {
  EXPECT_EQ(drawn_seed(kExam, kLena, 0), drawn_seed(kExam, kLena, 0));
  std::set<std::uint64_t> seeds;
  for (int draw = 0; draw < kMostDraws; ++draw)
    for (const UserId& student : {kLena, kOmar})
      for (const AssignmentId& exam : {kExam, AssignmentId::make()}) seeds.insert(drawn_seed(exam, student, draw));
  EXPECT_EQ(seeds.size(), 4u * kMostDraws);
  EXPECT_GT(*seeds.begin(), 0u) << "0 is the average tooth";
  EXPECT_LT(*seeds.rbegin(), std::uint64_t{1} << 53) << "every JSON reader keeps it";
}

TEST(DrawnTooth, IsTheFirstThatTheExerciseSuits) {
  std::vector<std::uint64_t> tried;
  const auto drawn = draw_tooth(class_1(), kExam, kLena, [&](const Scenario& exercise) {
    tried.push_back(exercise.specimen.seed);
    return tried.size() == 1 ? all_pulp(exercise) : grown(exercise);
  });
  ASSERT_TRUE(drawn) << drawn.error().where;
  ASSERT_GE(tried.size(), 2u) << "a target that opens the pulp is an error";
  EXPECT_EQ(drawn->specimen.seed, tried.back());
  EXPECT_FALSE(drawn->target == class_1().target);
}

TEST(DrawnTooth, LacksNoCriterionThatTheExercisesOwnToothHas) {
  const Scenario exercise = class_1();
  ASSERT_EQ(std::ranges::count(exercise.rubric.criteria, "remaining_over_pulp", &Criterion::metric), 1);
  const auto suited = draw_tooth(exercise, kExam, kLena, grown);
  ASSERT_TRUE(suited) << suited.error().where;
  const auto drawn_where = [&](const std::set<std::uint64_t>& without) {
    return draw_tooth(exercise, kExam, kLena, [&](const Scenario& one) { return without.contains(one.specimen.seed) ? without_pulp(one) : grown(one); });
  };
  const std::uint64_t seed = suited->specimen.seed;
  const auto other = drawn_where({seed});
  ASSERT_TRUE(other) << other.error().where;
  EXPECT_NE(other->specimen.seed, seed) << "its candidate would be graded without a criterion that the others have";
  const auto same = drawn_where({seed, exercise.specimen.seed});
  ASSERT_TRUE(same) << same.error().where;
  EXPECT_EQ(same->specimen.seed, seed) << "nobody is graded by it";
}

TEST(DrawnTooth, IsNotRefusedForATargetThatDoesNotPassOnTheExercisesOwnToothEither) {
  Scenario exercise = class_1();  // as published before the checks asked for it
  for (Criterion& c : exercise.rubric.criteria)
    if (c.metric.starts_with("depth_") || c.metric == "isthmus_width" || c.metric == "target_removed") c.bands = {50, 60, 70, 80, 90, 95};
  const auto drawn = draw_tooth(exercise, kExam, kLena, grown);
  ASSERT_TRUE(drawn) << drawn.error().where;
  const auto usual = draw_tooth(class_1(), kExam, kLena, grown);
  ASSERT_TRUE(usual) << usual.error().where;
  EXPECT_EQ(drawn->specimen.seed, usual->specimen.seed);
}

TEST(DrawnTooth, FailsWithTheCauseWhereNoneIsFound) {
  const auto stopped = [](const Scenario&) -> Outcome<std::shared_ptr<const Specimen>> {
    return session_fail(SessionError::specimen, ImportFailure{ImportError::cancelled, "tooth", {}});
  };
  EXPECT_EQ(draw_tooth(class_1(), kExam, kLena, stopped).error().code, SessionError::specimen);
  const auto by_hand = draw_tooth(load_builtin("class-1-36").value(), kExam, kLena, grown);
  EXPECT_EQ(by_hand.error().code, SessionError::no_tooth);
  EXPECT_EQ(by_hand.error().where, "/template");
}

/// A database with a student, and an assessment of the exercise that draws teeth.
struct School {
  Workplace work;
  std::unique_ptr<Store> store = work.store();
  Account lena;
  SessionPlan plan;

  School() {
    Account chief = store->accounts.create_first_administrator({"chief", "Ada Chief", Role::administrator, "correct horse", ""}).value();
    lena = store->accounts.create(chief.actor(), {"4711", "Lena Brandt", Role::student, "", "314159"}).value();
    const Actor examiner = store->accounts.create(chief.actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""})->actor();
    const CohortId cohort = store->cohorts.create(examiner, "Year 3")->id;
    EXPECT_TRUE(store->cohorts.add(examiner, cohort, lena.id));
    plan.scenario = class_1();
    plan.version = store->scenarios.ensure(plan.scenario, canonical_json(plan.scenario), content_hash(plan.scenario).bytes)->id;
    plan.assignment =
        store->assignments.create(examiner, {.version = plan.version, .cohort = cohort, .kind = SessionKind::assessment, .drawn_tooth = true}, "4711")->id;
    plan.kind = SessionKind::assessment;
    plan.start_code = "4711";
    plan.drawn_tooth = true;
    plan.database = work.database();
    plan.student = lena.actor();
  }
};

TEST(DrawnTooth, IsWhatTheSessionOpensWithLater) {
  School school;
  const Scenario own = school.plan.scenario;
  school.plan.scenario = draw_tooth(own, *school.plan.assignment, school.lena.id, grown).value();
  DrillingPort port(1);
  const auto setup = set_up(school.plan, port.limits());
  ASSERT_TRUE(setup) << setup.error().where;
  const auto opened = open_session(*school.store, setup->session);
  ASSERT_TRUE(opened) << opened.error().where;
  EXPECT_TRUE(opened->scenario == school.plan.scenario);
  EXPECT_NE(opened->scenario.specimen.seed, own.specimen.seed);
  EXPECT_EQ(opened->version.id, school.plan.version) << "lists and figures count it as an attempt at the version";
}

}  // namespace
}  // namespace cusp::test
