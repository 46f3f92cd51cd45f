#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "engine/volume/specimen.h"
#include "scenarios/operators/faults.h"
#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "tests/full_run.h"
#include "tests/modules.h"
#include "tests/scenarios/operators/attempt.h"

namespace cusp::test {
namespace {

/// Each block in each size of voxels once for all tests of this program.
std::shared_ptr<const Specimen> block(const SpecimenSource& source) {
  static std::map<std::pair<std::string, double>, std::shared_ptr<const Specimen>> made;
  auto& out = made[{source.generator, source.voxel_mm}];
  if (!out) out = Specimen::build(make_specimen(source, {}).value(), Reading::banded);
  return out;
}

/// In ticks of 4 ms: a tick cuts as far as four of 1 ms would.
attempt::Result play(const std::string& key, const char* name) {
  const Scenario scenario = load_builtin(key).value();
  const auto specimen = block(scenario.specimen);
  const Reference reference(scenario, specimen);
  return attempt::run(scenario, reference, specimen, *operator_by_name(name, scenario, *specimen, 1), 4000);
}

/// One of them; with CUSP_FULL set all fifteen (two minutes).
std::vector<std::string> exercises() {
  if (!full_run()) return {"channel-1"};
  std::vector<std::string> out;
  for (const std::string_view key : builtin_scenarios()) {
    if (load_builtin(key)->specimen.generator.ends_with("block") && key != "paper-block") out.emplace_back(key);
  }
  return out;
}

class Dexterity : public testing::TestWithParam<std::string> {};

TEST_P(Dexterity, TheExpertPassesAndTheNoviceDoesNot) {
  const attempt::Result good = play(GetParam(), "expert");
  EXPECT_TRUE(good.grade.passed);
  EXPECT_GE(good.grade.score, 90.0);  // measured: 100 for all fifteen
  EXPECT_GT(good.get("target_removed").value, 97.0);
  EXPECT_EQ(good.overflow, 0u);
  EXPECT_FALSE(good.faulted);
  const attempt::Result bad = play(GetParam(), "novice");
  EXPECT_FALSE(bad.grade.passed);
  EXPECT_LE(bad.grade.score, 50.0);  // measured: 5 to 36, the lower the higher the level
}

INSTANTIATE_TEST_SUITE_P(Library, Dexterity, testing::ValuesIn(exercises()), [](const auto& key) {
  std::string name = key.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST(Levels, TolerateLessAndLess) {
  for (const std::string shape : {"line", "channel", "cross", "circle", "ring"}) {
    double tolerated_mm = 1.0;
    for (const char* level : {"-1", "-2", "-3"}) {
      const Scenario s = load_builtin(shape + level).value();
      EXPECT_LT(s.leeway.side_mm, tolerated_mm);
      EXPECT_EQ(s.leeway.side_mm, s.leeway.floor_mm);
      tolerated_mm = s.leeway.side_mm;
      EXPECT_EQ(s.target.outline.depth_mm, 2.0);
      EXPECT_EQ(s.specimen.generator, level[1] == '3' ? "layered-block" : "block");
    }
    EXPECT_EQ(tolerated_mm, 0.2);  // dental.md 2.1: 0.5, 0.3, 0.2
  }
}

}  // namespace
}  // namespace cusp::test
