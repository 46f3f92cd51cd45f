#include "tests/modules.h"
#include "ui/session/play_through.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/session/small_exercise.h"
#include "ui/session/replay.h"

namespace cusp::test {
namespace {

using test::DrillingPort;
using test::Workplace;

TEST(PlayThrough, LeavesASessionWhoseReplayIsTheSameBitForBit) {
  const Workplace work;
  DrillingPort port(2600);
  const auto result = play_through(work.plan(), port);
  ASSERT_TRUE(result) << key_of(result.error().code) << ' ' << result.error().where << ' ' << result.error().detail;
  EXPECT_FALSE(result->session.is_nil());
  EXPECT_FALSE(result->interrupted);
  EXPECT_DOUBLE_EQ(result->seconds, 2.6);
  EXPECT_GT(result->volume->cut_bricks().size(), 0u);

  const auto store = work.store();
  const auto proof = prove_session(*store, result->session);
  ASSERT_TRUE(proof) << key_of(proof.error().code);
  EXPECT_TRUE(proof->holds());
  EXPECT_TRUE(proof->chain.intact());
  EXPECT_TRUE(proof->same_engine);
  EXPECT_EQ(proof->ticks, 2600u);
  EXPECT_EQ(proof->seconds_compared, 3u) << "two whole seconds and the rest";
  EXPECT_TRUE(proof->has_final_volume && proof->volume_equal);
  EXPECT_TRUE(proof->has_grade && proof->grade_equal);
  EXPECT_EQ(proof->volume_hash, result->volume_hash);
}

TEST(PlayThrough, WithSpindleVibrationAndHeatItsReplayIsTheSameBitForBitAndTheGradeKnowsOfCoolant) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.scenario.phenomena = {"spindle-turbine", "vibration", "sound", "heat"};
  plan.scenario.rubric.criteria.push_back({"dry_cutting_time", 10, {0, 0, 0, 0.1, 0.2, 0.3}});
  DrillingPort port(2600);
  const auto result = play_through(plan, port);
  ASSERT_TRUE(result) << key_of(result.error().code) << ' ' << result.error().where << ' ' << result.error().detail;
  EXPECT_GT(result->volume->cut_bricks().size(), 0u);
  EXPECT_EQ(result->grade.criteria.back().reason_code, "too_dry");
  const auto store = work.store();
  const auto proof = prove_session(*store, result->session);
  ASSERT_TRUE(proof) << key_of(proof.error().code);
  EXPECT_TRUE(proof->holds());
  EXPECT_TRUE(proof->has_grade && proof->grade_equal) << "the coolant comes from the inputs again";
}

TEST(PlayThrough, PlayedTwiceComesToTheSameTooth) {
  const Workplace work;
  DrillingPort first(700), second(700);
  const auto a = play_through(work.plan(), first);
  const auto b = play_through(work.plan(), second);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->volume_hash, b->volume_hash);
  EXPECT_EQ(a->grade.score, b->grade.score);
  EXPECT_NE(a->session, b->session);
}

TEST(PlayThrough, RecordsRemovedTissueAndForcesEachSecond) {
  const Workplace work;
  DrillingPort port(2100);
  const auto result = play_through(work.plan(), port);
  ASSERT_TRUE(result);
  const auto store = work.store();
  const auto rows = store->metrics.over_time(result->session);
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 3u);
  double before = 0;
  for (const MetricsRow& row : *rows) {
    ASSERT_EQ(row.metrics.removed.size(), 1u);
    EXPECT_EQ(row.metrics.removed[0].tissue, Tissue::plastic);
    EXPECT_GE(row.metrics.removed[0].mm3, before);
    before = row.metrics.removed[0].mm3;
    EXPECT_GT(row.metrics.force_peak_n, 0.0);
    EXPECT_LE(row.metrics.force_mean_n, row.metrics.force_peak_n);
  }
  // The last row's total is the final measure of the same volume.
  const auto final_mm3 = std::find_if(result->measures.begin(), result->measures.end(),
                                      [](const Measure& m) { return m.metric == "removed_plastic"; });
  ASSERT_NE(final_mm3, result->measures.end());
  EXPECT_NEAR(before, final_mm3->value, 1e-9);
  const double voxel_mm3 = 0.15 * 0.15 * 0.15;
  EXPECT_NEAR(static_cast<double>(rows->back().metrics.removed[0].voxels) * voxel_mm3, before, 0.15 * before);
}

TEST(PlayThrough, WithoutADatabaseNothingIsKept) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.database.clear();
  DrillingPort port(300);
  const auto result = play_through(plan, port);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->session.is_nil());
  EXPECT_FALSE(result->grade.criteria.empty());
  EXPECT_TRUE(work.store()->history.list(work.demo.actor())->empty());
}

TEST(PlayThrough, ATryOutIsKeptApartFromTheHistory) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.kind = SessionKind::try_out;
  DrillingPort port(300);
  const auto result = play_through(plan, port);
  ASSERT_TRUE(result);
  EXPECT_TRUE(work.store()->history.list(work.demo.actor())->empty());
}

TEST(PlayThrough, StoppedFromOutsideItIsInterruptedAndGradedAsItStands) {
  const Workplace work;
  DrillingPort port(100'000);
  PlaySettings settings;
  settings.go_on = [](std::uint64_t elapsed_us) { return elapsed_us < 1'000'000; };
  const auto result = play_through(work.plan(), port, settings);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->interrupted);
  const auto store = work.store();
  const auto again = open_result(*store, result->session);
  ASSERT_TRUE(again);
  EXPECT_TRUE(again->interrupted);
  EXPECT_EQ(again->volume_hash, result->volume_hash);
  EXPECT_EQ(again->grade.score, result->grade.score);
  EXPECT_TRUE(prove_session(*store, result->session)->holds());
}

TEST(PlayThrough, AScenarioWithATissueLeftOutIsRefusedBeforeAnyRowIsWritten) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.scenario.tissues = {{Tissue::enamel, 1.0, 1.0}};
  DrillingPort port(300);
  const auto result = play_through(plan, port);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, SessionError::scene);
  EXPECT_EQ(result.error().where, "/tissues");
  EXPECT_EQ(result.error().detail, "plastic");
  EXPECT_TRUE(work.store()->history.list(work.demo.actor())->empty());
}

TEST(PlayThrough, AScenarioThatCouldNotBeReadAgainIsRefusedBeforeAnyRowIsWritten) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.scenario.instruments[0].name.clear();
  DrillingPort port(300);
  const auto result = play_through(plan, port);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, SessionError::scenario);
  EXPECT_EQ(result.error().where, "/instruments/0/name");
  EXPECT_TRUE(work.store()->scenarios.library()->empty());
}

class Mouse : public test::DrillingPort {
 public:
  using DrillingPort::DrillingPort;
  DeviceLimits limits() const override {
    DeviceLimits limits = DrillingPort::limits();
    limits.device_class = "pointer";
    limits.rotation_axes = 0;
    return limits;
  }
};

TEST(PlayThrough, ADeviceThatTheScenarioDoesNotAdmitIsRefused) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.scenario.device.admitted = {"falcon"};
  Mouse port(10);
  const auto result = play_through(plan, port);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, SessionError::device_class);
}

TEST(PlayThrough, ADeviceThatSensesFewerAxesThanTheScenarioNeedsIsRefusedAndNothingIsKept) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.scenario.device.needs_dof = 6;
  Mouse port(10);
  const auto result = play_through(plan, port);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, SessionError::device_axes);
  EXPECT_EQ(result.error().detail, "6");
  plan.scenario.device.needs_dof = 3;
  EXPECT_TRUE(play_through(plan, port));
}

}  // namespace
}  // namespace cusp::test
