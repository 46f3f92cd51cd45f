// What the values of a template make of its texts, bands and criteria.

#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/templates/templates.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

Result<Scenario, FitFailure> with_values(const std::string& key, std::map<std::string, double> values) {
  return fit_template({.key = key, .fdi = 36, .seed = 0, .values = std::move(values), .id = {}});
}

TEST(TemplateValues, ChangeTheExerciseWithEachParameter) {
  for (const ExerciseTemplate& one : exercise_templates())
    for (const TemplateParameter& p : one.parameters) {
      auto low = with_values(one.key, {{p.key, p.least}});
      const auto high = with_values(one.key, {{p.key, p.most}});
      EXPECT_TRUE(low || high) << one.key << " " << p.key;
      if (!low || !high) continue;  // a refusal is a change too
      low->made_with = high->made_with;
      EXPECT_FALSE(*low == *high) << one.key << " " << p.key;
    }
}

TEST(TemplateValues, NameTheCariesThatIsMeasuredOnce) {
  for (const double deep : {1.54, 1.55}) {  // times 0.88 squared: 1.1926 and 1.2003 mm, about the bound of 1.2
    const auto scenario = with_values("caries-fissure", {{"deep", deep}, {"softness", 0.88}});
    ASSERT_TRUE(scenario) << deep;
    const std::string& en = scenario->briefing.at("en");
    const bool both = en.find("periphery, in enamel and over the pulp") != std::string::npos;
    EXPECT_NE(both, en.find("periphery and in enamel") != std::string::npos) << en;
  }
}

TEST(TemplateValues, AskForNoMoreHeightAboveTheJunctionThanTheTargetKeeps) {
  for (const auto& [key, least] : {std::pair("class-2-adhesive", 0.5), {"class-2-classical", 0.5}, {"caries-proximal", 0.3}}) {
    const auto scenario = with_values(key, {{"above_cej", least}});
    ASSERT_TRUE(scenario) << key;
    const auto asked = std::ranges::find(scenario->rubric.criteria, "gingival_above_cej", &Criterion::metric);
    ASSERT_NE(asked, scenario->rubric.criteria.end()) << key;
    EXPECT_LE(asked->bands.ideal_lo, least) << key;
  }
}

}  // namespace
}  // namespace cusp::test
