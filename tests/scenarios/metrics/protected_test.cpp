// What an attempt is to spare: a tissue or a region, by its severity.

#include <gtest/gtest.h>

#include "scenarios/grading/grader.h"
#include "tests/scenarios/metrics/block_cuts.h"

namespace cusp::test {
namespace {

/// A slot 3.3 mm deep takes 0.3 mm of the dentine below z = -3.
std::vector<Measure> slot_into_dentine(Protected part, double depth) {
  Scenario s = exercise(region_of(isthmus(1.2, 2)));
  s.protected_parts = {std::move(part)};
  return measured(s, exactly(region_of(isthmus(1.2, depth))));
}
bool damaged(const std::vector<Measure>& measures) { return get(measures, "protected_damage").value > 0; }

TEST(ProtectedPart, ATissueIsDamagedAtItsSeverity) {
  EXPECT_TRUE(damaged(slot_into_dentine(Tissue::dentine, 3.3)));
  EXPECT_FALSE(damaged(slot_into_dentine(Tissue::dentine, 2.7)));
  EXPECT_FALSE(damaged(slot_into_dentine({Tissue::dentine, Damage::touch}, 2.7)));
  EXPECT_TRUE(damaged(slot_into_dentine({Tissue::dentine, Damage::touch}, 3.05))) << "it lies bare";
  EXPECT_NEAR(get(slot_into_dentine(Tissue::dentine, 3.3), "protected_removed").value, 0.3 * (4 * 1.2 + 3.14159 * 0.36), 0.3);
}

TEST(ProtectedPart, ARegionIsDamagedAtItsSeverity) {
  Region below = sphere({0, 0, -4}, 1.5);  // its top lies at z = -2.5
  const auto of = [&](Damage severity, double depth_mm, double cut_mm) {
    Protected part(below, severity);
    part.depth_mm = depth_mm;
    return damaged(slot_into_dentine(part, cut_mm));
  };
  EXPECT_FALSE(of(Damage::removal, 0, 2.4));
  EXPECT_TRUE(of(Damage::removal, 0, 2.8));
  EXPECT_FALSE(of(Damage::touch, 0, 2.4));
  EXPECT_TRUE(of(Damage::touch, 0, 2.52));
  EXPECT_FALSE(of(Damage::depth, 0.5, 2.9)) << "0.4 mm into it";
  EXPECT_TRUE(of(Damage::depth, 0.5, 3.1)) << "0.6 mm into it";
}

TEST(ProtectedPart, ARegionThatIsGoneWhollyIsDamagedAtEverySeverity) {
  for (const Damage severity : {Damage::removal, Damage::touch, Damage::depth}) {
    Protected part(sphere({0, 0, -1}, 0.4), severity);
    part.depth_mm = 0.2;
    EXPECT_TRUE(damaged(slot_into_dentine(part, 2))) << static_cast<int>(severity);
  }
}

TEST(ProtectedPart, ARegionsRemovedVolumeIsThatOfTheSolid) {
  // The whole of a ball of 0.5 mm that the slot holds: 4/3 pi r3.
  const auto measures = slot_into_dentine(Protected(sphere({0, 0, -1}, 0.4)), 2);
  const Measure m = get(measures, "protected_removed");
  EXPECT_NEAR(m.value, 4.0 / 3.0 * 3.14159265 * 0.064, 0.005);
}

TEST(ProtectedPart, DamageFailsTheAttemptWhereTheRubricSaysSo) {
  Scenario s = exercise(region_of(isthmus(1.2, 3.3)));
  s.protected_parts = {Tissue::dentine};
  s.rubric.criteria = {{"target_removed", 10, {80, 90, 97, 100, 100, 100}}};
  const auto measures = measured(s, exactly(s.target));
  EXPECT_TRUE(grade(s, measures).passed);
  s.rubric.critical = {"protected_damage"};
  EXPECT_FALSE(grade(s, measures).passed);
  EXPECT_EQ(grade(s, measures).critical, std::vector<std::string>{"protected_damage"});
}

TEST(ProtectedPart, WithoutOneNothingIsSaidOfDamage) {
  const Scenario s = exercise(region_of(isthmus(1.2, 2)));
  EXPECT_FALSE(get(measured(s, exactly(s.target)), "protected_damage").measured);
}

}  // namespace
}  // namespace cusp::test
