// The reference operator on the library's teeth: what it cuts at once has full points. Where it had not, the exercise would be
// wrong.

#include <gtest/gtest.h>


#include "scenarios/grading/grader.h"
#include "scenarios/library/library.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/operators/fast_cut.h"
#include "scenarios/specimens/specimens.h"
#include "tests/full_run.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// One of each class and a disc; with CUSP_FULL set all exercises (four minutes).
std::vector<std::string> exercises() {
  if (!full_run()) return {"class-1-25", "class-2-46-mo", "circle-3"};
  std::vector<std::string> out;
  for (const std::string_view key : builtin_scenarios()) out.emplace_back(key);
  return out;
}

class ReferenceOperator : public testing::TestWithParam<std::string> {};

TEST_P(ReferenceOperator, HasFullPointsTheNoviceFailsAndIdlenessEarnsNothing) {
  const Scenario scenario = *load_builtin(GetParam());
  const auto dense = make_specimen(scenario.specimen, {});
  ASSERT_TRUE(dense);
  const auto specimen = Specimen::build(*dense, reading_of(scenario.method));
  const Reference against(scenario, specimen);
  const auto graded = [&](std::string_view name) {
    Volume volume(specimen);
    const auto plan = plan_by_name(name, scenario, *specimen);
    EXPECT_TRUE(plan && cut_along(*plan, scenario, volume)) << name;
    return grade(scenario, measure(against, volume, {}));
  };
  const Grade reference = graded("reference");
  EXPECT_EQ(reference.score, 100.0);
  for (const CriterionGrade& c : reference.criteria)
    EXPECT_TRUE(c.points == c.points_max || !c.measure.measured) << c.id << " " << c.measure.value;
  EXPECT_TRUE(reference.critical.empty());
  const Grade novice = graded("novice");
  EXPECT_FALSE(novice.passed) << novice.score;
  const Grade idle = grade(scenario, measure(against, Volume(specimen), {}));
  EXPECT_EQ(idle.score, 0.0);
  EXPECT_FALSE(idle.passed);
}

INSTANTIATE_TEST_SUITE_P(Library, ReferenceOperator, testing::ValuesIn(exercises()), [](const auto& key) {
  std::string name = key.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace cusp::test
