#include "tests/modules.h"
#include "ui/session/scene_builder.h"

#include <gtest/gtest.h>

#include "tests/ui/session/small_exercise.h"
#include "ui/session/replay.h"
#include "ui/session/play_through.h"

namespace cusp::test {
namespace {

using test::Workplace;

Scenario two_tissues() {
  Scenario scenario = test::small_exercise();
  scenario.tissues = {{Tissue::plastic, 1.0, 4.0}, {Tissue::enamel, 2.0, 1.0}};
  return scenario;
}

DeviceLimits held_device() {
  DeviceLimits device;
  device.device_class = "scripted";
  return device;  // damping and delay unknown
}

TEST(BuildScene, CutsAllTissuesByTheSameShareOnADeviceThatAHandHolds) {
  const auto specimen = Specimen::build(test::block_volume(), Reading::banded);
  const auto scene = build_scene(two_tissues(), specimen, held_device());
  ASSERT_TRUE(scene);
  // Half of (0.5 + 2) N s/m over 1.5 ms; the stiffest tissue gets that.
  EXPECT_NEAR((*scene)->tissues[index_of(Tissue::enamel)].stiffness_n_per_mm, 0.8333, 1e-4);
  EXPECT_NEAR((*scene)->tissues[index_of(Tissue::plastic)].stiffness_n_per_mm, 0.4167, 1e-4);
  const StiffnessCut cut = stiffness_cut(two_tissues(), 0.15, held_device());
  EXPECT_TRUE(cut.cuts());
  EXPECT_EQ(cut.asked_n_per_mm, 2.0);
  EXPECT_TRUE(cut.rule.assumed);
}

TEST(BuildScene, LeavesAMouseAndACalibratedDeviceWhatTheScenarioAsks) {
  const auto specimen = Specimen::build(test::block_volume(), Reading::banded);
  DeviceLimits mouse = held_device();
  mouse.closed_loop = false;
  mouse.max_stiffness_n_per_mm = 20.0;
  DeviceLimits calibrated = held_device();
  calibrated.damping_ns_per_m = 8.0;
  calibrated.delay_ms = 1.0;
  for (const DeviceLimits& device : {mouse, calibrated}) {
    const auto scene = build_scene(two_tissues(), specimen, device);
    ASSERT_TRUE(scene);
    EXPECT_EQ((*scene)->tissues[index_of(Tissue::enamel)].stiffness_n_per_mm, 2.0);
  }
}

TEST(BuildScene, GivesTheGuardWhatTheDeviceIs) {
  const auto specimen = Specimen::build(test::block_volume(), Reading::banded);
  DeviceLimits device = held_device();
  device.encoder_mm = 0.02;
  device.delay_ms = 2.0;
  const auto scene = build_scene(two_tissues(), specimen, device);
  ASSERT_TRUE(scene);
  EXPECT_EQ((*scene)->guard.encoder_mm, 0.02);
  EXPECT_EQ((*scene)->guard.delay_ms, 2.0);
  EXPECT_TRUE((*scene)->guard.has(GuardPart::passivity));
  device.closed_loop = false;
  const auto open = build_scene(two_tissues(), specimen, device);
  ASSERT_TRUE(open);
  EXPECT_FALSE((*open)->guard.has(GuardPart::passivity));
  EXPECT_TRUE((*open)->guard.has(GuardPart::limit));
}

TEST(BuildScene, AReplayHasTheStiffnessAndTheGuardOfItsSession) {
  const Workplace work;
  test::DrillingPort port(1500);
  SessionPlan plan = work.plan();
  plan.scenario.tissues = {{Tissue::plastic, 2.0, 4.0}};
  const auto result = play_through(plan, port);
  ASSERT_TRUE(result) << key_of(result.error().code);
  EXPECT_NEAR(result->stiffness_share, 0.4167, 1e-4);
  const auto store = work.store();
  const auto opened = open_session(*store, result->session);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->session.header.stiffness_share, result->stiffness_share);
  EXPECT_NEAR(opened->scene->tissues[index_of(Tissue::plastic)].stiffness_n_per_mm, 0.8333, 1e-4);
  EXPECT_EQ(opened->scene->guard, opened->session.header.guard);
  EXPECT_TRUE(prove_session(*store, result->session)->holds());
}

}  // namespace
}  // namespace cusp::test
