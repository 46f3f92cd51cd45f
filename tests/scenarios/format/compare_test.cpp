// What two versions of an exercise differ in.

#include "scenarios/format/compare.h"

#include <gtest/gtest.h>

#include "scenarios/format/ranges.h"
#include "tests/modules.h"
#include "tests/scenarios/format/make_scenario.h"

namespace cusp::test {
namespace {

constexpr ChangeKind kChanged = ChangeKind::changed, kAdded = ChangeKind::added, kRemoved = ChangeKind::removed;

/// An outline 2.0 mm deep with one bur, one tissue and one criterion.
Scenario plain_channel() {
  Scenario s;
  s.title = {{"en", "Channel"}};
  s.briefing = {{"en", "Cut the channel."}};
  s.specimen.generator = "block";
  s.tissues = {{Tissue::plastic, 2, 3}};
  s.instruments = {{"2", 0.5, 0.3, 4, 0.8, 12, {}}};
  s.target.outline.paths = {{{-2, 0, -2}, {2, 0, -2}}};
  s.target.outline.depth_mm = 2.0;
  s.rubric.criteria = {{"target_removed", 30, {80, 90, 97, 100, 100, 100}}};
  return s;
}

template <class F>
std::vector<Change> differences(F change) {
  Scenario s = plain_channel();
  change(s);
  return compare(plain_channel(), s);
}

using Changes = std::vector<Change>;

const NumberRange* range_at(const Change& change) {
  const auto ranges = number_ranges();
  const auto at = std::ranges::find(ranges, std::string_view(change.path), &NumberRange::path);
  return at == ranges.end() ? nullptr : &*at;
}

TEST(Compare, FindsNothingBetweenEqualExercisesOfOtherIdentity) {
  EXPECT_EQ(differences([](Scenario& s) {
              s.id = ScenarioId::make();
              s.version = 7;
              s.key = "other";
            }),
            Changes{});
}

TEST(Compare, GivesANumberWithBothValuesAndAPathThatTheTableOfRangesKnows) {
  const auto deeper = differences([](Scenario& s) { s.target.outline.depth_mm = 1.5; });
  EXPECT_EQ(deeper, (Changes{{kChanged, "/target/depth_mm", "", 2.0, 1.5}}));
  EXPECT_EQ(range_at(deeper[0])->unit, "mm");
  const auto weight = differences([](Scenario& s) { s.rubric.criteria[0].weight = 40; });
  EXPECT_EQ(weight, (Changes{{kChanged, "/rubric/criteria/*/weight", "target_removed", 30, 40}}));
  EXPECT_NE(range_at(weight[0]), nullptr);
  const auto speed = differences([](Scenario& s) { s.tissues[0].speed_mm_s = 2; });
  EXPECT_EQ(speed, (Changes{{kChanged, "/tissues/*/speed_mm_s", "plastic", 3, 2}}));
}

TEST(Compare, MatchesTheItemsOfAListByTheirNames) {
  const auto lists = differences([](Scenario& s) {
    s.rubric.criteria.insert(s.rubric.criteria.begin(), {"depth_mean", 10, {1, 1, 2, 2, 3, 3}});
    s.instruments.clear();
    s.rubric.critical = {"pulp_exposure"};
  });
  EXPECT_EQ(lists, (Changes{{kRemoved, "/instruments/*", "2"},
                            {kAdded, "/rubric/criteria/*", "depth_mean"},
                            {kAdded, "/rubric/critical/*", "pulp_exposure"}}));
}

TEST(Compare, NamesAWholeWhereItsPartsAreOfNoUse) {
  EXPECT_EQ(differences([](Scenario& s) { s.rubric.criteria[0].bands.acc_lo = 91; }),
            (Changes{{kChanged, "/rubric/criteria/*/bands", "target_removed"}}));
  EXPECT_EQ(differences([](Scenario& s) { s.target.outline.paths[0][0].x = -3; }), (Changes{{kChanged, "/target/paths", ""}}));
  EXPECT_EQ(differences([](Scenario& s) { s.target.kind = RegionKind::box; }), (Changes{{kChanged, "/target", ""}}));
  EXPECT_EQ(differences([](Scenario& s) { s.protected_parts = {Tissue::pulp}; }), (Changes{{kChanged, "/protected", ""}}));
}

TEST(Compare, NamesTheLanguageOfAText) {
  EXPECT_EQ(differences([](Scenario& s) {
              s.briefing["de"] = "Präpariere den Kanal.";
              s.title["en"] = "Deep channel";
            }),
            (Changes{{kAdded, "/briefing/*", "de"}, {kChanged, "/title/*", "en"}}));
}

TEST(Compare, FindsADifferenceWheneverTheExercisesDiffer) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Scenario one = ScenarioMaker(seed).make();
    const Scenario other = ScenarioMaker(seed + 1000).make();
    EXPECT_FALSE(compare(one, other).empty()) << "seed " << seed;
    EXPECT_TRUE(compare(one, one).empty()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace cusp::test
