// Cuts of scripted operators that are made at once: graded as an attempt, or refused with a cause.

#include "ui/session/operator_cut.h"

#include <gtest/gtest.h>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/session/scene_builder.h"

namespace cusp::test {
namespace {

Scenario coarse_channel() {
  Scenario out = *load_builtin("channel-1");
  out.specimen.voxel_mm = 0.4;
  return out;
}

TEST(OperatorCut, GradesTheReferenceAboveThePassMarkAndTheNoviceBelowIt) {
  const Scenario scenario = coarse_channel();
  const auto specimen = build_specimen(scenario, {});
  ASSERT_TRUE(specimen.has_value());
  const auto reference = cut_by_operator("reference", scenario, *specimen);
  const auto novice = cut_by_operator("novice", scenario, *specimen);
  ASSERT_TRUE(reference.has_value() && novice.has_value());
  EXPECT_TRUE(reference->grade.passed) << reference->grade.score;
  EXPECT_FALSE(novice->grade.passed) << novice->grade.score;
  EXPECT_TRUE(cut_at_once(*reference));
  EXPECT_EQ(reference->operator_name, "reference");
  EXPECT_EQ(reference->volume_hash, reference->volume->hash());
  EXPECT_EQ(reference->grade.criteria.size(), scenario.rubric.criteria.size());
}

TEST(OperatorCut, RefusesAnOperatorThatCutsNothingAtOnce) {
  const Scenario scenario = coarse_channel();
  const auto specimen = build_specimen(scenario, {});
  ASSERT_TRUE(specimen.has_value());
  const auto nobody = cut_by_operator("nobody", scenario, *specimen);
  ASSERT_FALSE(nobody.has_value());
  EXPECT_EQ(nobody.error(), OperatorCutError::no_path);
}

}  // namespace
}  // namespace cusp::test
