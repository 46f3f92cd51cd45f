#include "scenarios/checks/checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "tests/full_run.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<std::string> codes(const std::vector<Finding>& findings) {
  std::vector<std::string> out;
  for (const Finding& f : findings) out.push_back((f.severity == Severity::error ? "error " : "warning ") + f.path + " " + f.code);
  return out;
}

/// Each specimen once for all tests of this program: many exercises stand on the same block.
std::shared_ptr<const Specimen> grown(const Scenario& s) {
  static std::vector<std::tuple<SpecimenSource, Reading, std::shared_ptr<const Specimen>>> made;
  const Reading reading = reading_of(s.method);
  for (const auto& [source, how, specimen] : made) {
    if (source == s.specimen && how == reading) return specimen;
  }
  auto specimen = Specimen::build(make_specimen(s.specimen, {}).value(), reading);
  made.emplace_back(s.specimen, reading, specimen);
  return specimen;
}

/// Class I on 36 in coarse voxels.
struct Tooth {
  Scenario scenario = [] {
    Scenario s = load_builtin("class-1-36").value();
    s.specimen.voxel_mm = 0.2;
    return s;
  }();
  std::vector<std::string> regions() const { return codes(check_regions(scenario, *grown(scenario))); }
  std::vector<std::string> attempts() const { return codes(check_attempts(scenario, grown(scenario))); }
};

void deepen(Scenario& s, double depth) {
  s.target.outline.depth_mm = depth;
  for (auto& path : s.target.outline.paths)
    for (Vec3& p : path) p.z = s.target.outline.top_mm - depth;
}

/// By default one of each kind; whole, every exercise.
TEST(Checks, EveryExerciseOfTheLibraryHasNoFinding) {
  constexpr std::array<std::string_view, 6> kKinds = {"channel-2", "circle-3", "paper-block", "class-1-46", "class-2-25-mod", "caries-26"};
  for (const std::string_view key : builtin_scenarios()) {
    if (!full_run() && std::ranges::find(kKinds, key) == kKinds.end()) continue;
    SCOPED_TRACE(key);
    Scenario s = load_builtin(key).value();
    EXPECT_THAT(codes(check_texts(s, library_patterns())), IsEmpty());
    if (s.specimen.generator != "paper-block") s.specimen.voxel_mm = 0.2;
    if (key == "class-1-36-jaw") continue;  // as class-1-36, in half a minute more
    EXPECT_THAT(codes(check_exercise(s, grown(s))), IsEmpty());
  }
}

TEST(Pulp, ATargetThatOpensItIsAnErrorWhetherOrNotItFailsTheAttempt) {
  Tooth t;
  deepen(t.scenario, 3.4);
  EXPECT_THAT(t.regions(), Contains("error /target/depth_mm target_opens_pulp"));
  t.scenario.rubric.critical.clear();
  EXPECT_THAT(t.regions(), Contains("error /target/depth_mm target_opens_pulp"));
}

TEST(Pulp, ReportsAnAccessWithoutAnError) {
  Tooth t;
  deepen(t.scenario, 5.5);
  t.scenario.target.outline.width_mm = 3;
  t.scenario.rubric.critical.clear();
  EXPECT_THAT(t.regions(), ElementsAre("warning /target/depth_mm target_holds_pulp"));
  t.scenario.rubric.critical = {"pulp_exposure"};
  EXPECT_THAT(t.regions(), ElementsAre("error /target/depth_mm target_opens_pulp"));
}

TEST(Pulp, WithoutItsRuleAToothIsWarnedOf) {
  Tooth t;
  EXPECT_THAT(t.regions(), IsEmpty());
  t.scenario.rubric.critical.clear();
  EXPECT_THAT(t.regions(), ElementsAre("warning /rubric/critical pulp_rule_off"));
}

TEST(Pulp, AToleranceZoneThatReachesItIsAWarning) {
  Tooth t;
  t.scenario.leeway.floor_mm = 2.5;
  EXPECT_THAT(t.regions(), ElementsAre("warning /leeway/floor_mm leeway_opens_pulp"));
}

TEST(Protected, WhatTheTargetTakesIsAnErrorAndWhatItsToleranceZoneTakesAWarning) {
  Tooth t;
  t.scenario.protected_parts = {Tissue::pulp, Tissue::dentine};
  EXPECT_THAT(t.regions(), ElementsAre("error /protected/1 target_cuts_protected"));
  deepen(t.scenario, 0.6);
  t.scenario.leeway = {0.5, 0.1};
  EXPECT_THAT(t.regions(), Not(Contains("error /protected/1 target_cuts_protected")));
  t.scenario.leeway.floor_mm = 2.0;
  EXPECT_THAT(t.regions(), Contains("warning /protected/1 leeway_cuts_protected"));
}

TEST(Protected, ARegionIsTakenWhereTheTargetReachesDeeperThanItMay) {
  Tooth t;
  Region ball;
  ball.kind = RegionKind::sphere;
  ball.from_mm = {0.2, -0.15, 3.2};
  ball.radius_mm = 0.5;
  Protected part(ball, Damage::depth);
  part.depth_mm = 0.1;
  t.scenario.protected_parts = {Tissue::pulp, part};
  EXPECT_THAT(t.regions(), ElementsAre("error /protected/1 target_cuts_protected"));
  t.scenario.protected_parts[1].depth_mm = 2.0;
  EXPECT_THAT(t.regions(), IsEmpty());
}

TEST(Target, InTheAirHoldsNothingToCut) {
  Tooth t;
  t.scenario.target.outline.top_mm = 30;
  EXPECT_THAT(t.regions(), Contains("error /target/paths target_without_tissue"));
}

TEST(Target, WithATissueThatCannotBeCutIsAnError) {
  Tooth t;
  const auto enamel = std::ranges::find(t.scenario.tissues, Tissue::enamel, &ScenarioTissue::tissue);
  ASSERT_NE(enamel, t.scenario.tissues.end());
  enamel->speed_mm_s = 0;
  const auto at = enamel - t.scenario.tissues.begin();
  EXPECT_THAT(t.regions(), ElementsAre("error /tissues/" + std::to_string(at) + "/speed_mm_s target_uncuttable"));
  // The target lies clear of the pulp.
  Tooth u;
  const auto pulp = std::ranges::find(u.scenario.tissues, Tissue::pulp, &ScenarioTissue::tissue);
  ASSERT_NE(pulp, u.scenario.tissues.end());
  pulp->speed_mm_s = 0;
  EXPECT_THAT(u.regions(), IsEmpty());
}

TEST(Attempts, OfTheClassOneGiveNothingForNothing) { EXPECT_THAT(Tooth().attempts(), IsEmpty()); }

TEST(Attempts, IdlenessThatEarnsIsAnError) {
  // Nothing asks for the target: what is kept intact counts whole.
  Tooth t;
  std::erase_if(t.scenario.rubric.criteria, [](const Criterion& c) { return c.metric == "target_removed"; });
  EXPECT_THAT(t.attempts(), Contains("error /rubric/criteria idle_earns"));
  // Full points for nothing removed.
  Tooth u;
  u.scenario.rubric.criteria[0].bands = {-2, -1, 0, 100, 100, 100};
  EXPECT_THAT(u.attempts(), Contains("error /rubric/criteria idle_earns"));
  // Time alone: whoever waits ten seconds has it.
  Tooth v;
  v.scenario.rubric.criteria = {{"time", 10, {0, 0, 0, 600, 700, 800}}};
  EXPECT_THAT(v.attempts(), Contains("error /rubric/criteria idle_earns"));
}

TEST(Attempts, ATokenThatPassesIsAnError) {
  // A shaft to the floor has the depth that is asked for.
  Tooth t;
  t.scenario.rubric.criteria = {{"depth_mean", 10, {1, 1.4, 1.6, 2.0, 2.2, 2.6}}};
  EXPECT_THAT(t.attempts(), ElementsAre("error /rubric/criteria token_passes"));
  // The top of the target is enough.
  Tooth u;
  u.scenario.rubric.criteria = {{"target_removed", 10, {0, 1, 2, 100, 100, 100}}};
  EXPECT_THAT(u.attempts(), ElementsAre("error /rubric/criteria token_passes"));
  u.scenario.rubric.criteria[0].bands = {0, 8, 20, 100, 100, 100};
  EXPECT_THAT(u.attempts(), ElementsAre("warning /rubric/criteria token_earns")) << "31 points";
  u.scenario.rubric.criteria[0].bands = {10, 15, 20, 100, 100, 100};
  EXPECT_THAT(u.attempts(), IsEmpty());
}

TEST(Attempts, ACriterionThatTheFinishedTargetDoesNotHaveIsAnError) {
  // A class II whose neighbours and gums were taken away: its contact and clearances would drop out of every grade.
  Scenario s = load_builtin("class-2-46-mo").value();
  s.specimen.voxel_mm = 0.2;
  s.specimen.around.clear();
  std::vector<std::string> unmeasured;
  for (const Finding& f : check_attempts(s, grown(s)))
    if (f.code == "criterion_unmeasured") unmeasured.push_back(f.detail);
  EXPECT_THAT(unmeasured, Contains("contact_broken"));
  EXPECT_THAT(unmeasured, Contains("clearance_buccal_middle"));
  EXPECT_THAT(unmeasured, Not(Contains("gingival_above_cej")));
  Tooth t;
  t.scenario.rubric.criteria.push_back({"caries_left_pulp", 10, {0, 0, 0, 0.1, 0.2, 0.3}});
  EXPECT_THAT(t.attempts(), ElementsAre("error /rubric/criteria/" + std::to_string(t.scenario.rubric.criteria.size() - 1) +
                                        "/metric criterion_unmeasured"));
  Tooth u;  // what only a played attempt has
  u.scenario.rubric.criteria.push_back({"force_mean", 10, {0, 0, 0, 1, 2, 3}});
  EXPECT_THAT(u.attempts(), IsEmpty());
}

TEST(Attempts, ATargetThatDoesNotPassItselfIsAnError) {
  Tooth t;
  for (Criterion& c : t.scenario.rubric.criteria)
    if (c.metric.starts_with("depth_") || c.metric == "isthmus_width" || c.metric == "target_removed") c.bands = {50, 60, 70, 80, 90, 95};
  EXPECT_THAT(t.attempts(), Contains("error /rubric/pass target_fails"));
  Tooth u;  // waiting ten seconds is no time to cut in, and nothing is known of the way
  u.scenario.rubric.criteria.push_back({"time", 200, {60, 120, 180, 600, 700, 800}});
  EXPECT_THAT(u.attempts(), Not(Contains("error /rubric/pass target_fails")));
  Tooth v;
  v.scenario.rubric.critical.push_back("protected_damage");
  v.scenario.protected_parts.emplace_back(Tissue::enamel);
  EXPECT_THAT(v.attempts(), Contains("error /rubric/pass target_fails")) << "the target takes what is protected";
  Tooth w;  // what earns the points is not graded on the simplest device that is admitted
  for (Criterion& c : w.scenario.rubric.criteria)
    if (c.metric == "depth_mean") c.bands = {50, 60, 70, 80, 90, 95};
    else c.needs_dof = 6;
  w.scenario.device.needs_dof = 6;
  EXPECT_THAT(w.attempts(), Not(Contains("error /rubric/pass target_fails")));
  w.scenario.device.needs_dof = 3;
  EXPECT_THAT(w.attempts(), Contains("error /rubric/pass target_fails"));
}

TEST(Attempts, OfAFilledReadingAreGradedToo) {
  Scenario s = load_builtin("paper-block").value();
  const auto block = grown(s);
  EXPECT_THAT(codes(check_attempts(s, block)), IsEmpty());
  s.rubric.criteria = {{"target_removed", 10, {0, 1, 2, 100, 100, 100}}};
  EXPECT_THAT(codes(check_attempts(s, block)), ElementsAre("error /rubric/criteria token_passes"));
}

/// A copy of a library exercise under a name and a briefing of its own.
Scenario copy_of(const char* key) {
  Scenario s = load_builtin(key).value();
  s.id = {};
  s.key.clear();
  return s;
}

TEST(Texts, ACopyWithAnotherToothStillDescribesItsTemplate) {
  Scenario s = copy_of("class-1-36");
  EXPECT_THAT(codes(check_texts(s, library_patterns())), IsEmpty());
  s.specimen.fdi = 46;
  EXPECT_THAT(codes(check_texts(s, library_patterns())),
              ElementsAre("warning /title/de text_of_template", "warning /title/de text_other_tooth",
                          "warning /title/en text_of_template", "warning /title/en text_other_tooth",
                          "warning /briefing/de text_of_template", "warning /briefing/en text_of_template"));
  s.title = {{"en", "Class I, tooth 46"}};
  s.briefing = {{"en", "Prepare a class I cavity in the lower right first molar, 1.8 mm deep."}};
  EXPECT_THAT(codes(check_texts(s, library_patterns())), IsEmpty());
}

TEST(Texts, ATitleNamesTheToothOfAFileByTheNumberThatItsAuthorGaveIt) {
  Scenario s = copy_of("class-1-36");
  s.title = {{"en", "Scanned tooth 36"}};
  s.specimen = {};
  s.specimen.volume = "tooth.nrrd";
  const std::string found = "warning /title/en text_other_tooth";
  EXPECT_THAT(codes(check_texts(s, {})), Not(Contains(found))) << "nobody knows its number";
  s.specimen.landmarks.fdi = 46;
  EXPECT_THAT(codes(check_texts(s, {})), Contains(found));
  s.specimen.landmarks.fdi = 36;
  EXPECT_THAT(codes(check_texts(s, {})), Not(Contains(found)));
}

TEST(Texts, ADepthThatTheTargetNoLongerHasIsFoundInEveryLanguage) {
  Scenario s = copy_of("class-1-36");
  s.title = {{"en", "Deep class I"}, {"de", "Tiefe Klasse I"}};
  s.briefing["en"] += " Take your time.";
  s.briefing["de"] += " Lassen Sie sich Zeit.";
  deepen(s, 2.2);
  const auto findings = check_texts(s, library_patterns());
  EXPECT_THAT(codes(findings), ElementsAre("warning /briefing/de text_figure", "warning /briefing/en text_figure"));
  EXPECT_EQ(findings[0].args.at("value"), 1.8);
  EXPECT_EQ(findings[0].detail, "de");
}

TEST(Texts, AToleranceThatTheTemplateHadIsFoundThoughTheDepthIsRight) {
  Scenario s = copy_of("ring-2");
  s.briefing["en"] += " Mind the wall.";
  s.leeway = {0.4, 0.4};
  const auto findings = check_texts(s, library_patterns());
  ASSERT_THAT(codes(findings), Contains("warning /briefing/en text_figure"));
  EXPECT_EQ(findings.back().args.at("value"), 0.3);
}

TEST(Texts, LengthsOfOtherThingsAreLeftAloneWhereTheDepthIsNamed) {
  Scenario s = copy_of("class-1-36");
  s.title = {{"en", "My class I"}};
  s.briefing = {{"en", "Cut 1.8 mm deep and keep 1.6\xc2\xa0mm of the ridge; work for 12 minutes at 25 degrees."}};
  EXPECT_THAT(codes(check_texts(s, library_patterns())), IsEmpty());
  s.briefing = {{"en", "Keep 1.6 mm of the ridge."}};
  EXPECT_THAT(codes(check_texts(s, library_patterns())), ElementsAre("warning /briefing/en text_figure"));
}

TEST(Texts, AreasVolumesAndSpeedsAreNoLengths) {
  Scenario s = copy_of("class-1-36");
  s.title = {{"en", "My class I"}};
  for (const char* text : {"At most 1.5 mm\xc2\xb3 may be over-cut.", "Leave 3\xc2\xa0mm\xc2\xb2 of enamel.", "Feed at 7 mm/s.", "At most 5 mm^3."}) {
    s.briefing = {{"en", text}};
    EXPECT_THAT(codes(check_texts(s, library_patterns())), IsEmpty()) << text;
  }
  s.briefing = {{"en", "Keep 1.6 mm/2.6 mm of the ridge."}};
  EXPECT_THAT(codes(check_texts(s, library_patterns())), ElementsAre("warning /briefing/en text_figure"));
}

TEST(Texts, AnotherToothsNumberIsFoundWithoutATemplate) {
  Scenario s = copy_of("class-1-36");
  s.title = {{"en", "Tooth 16"}};
  s.briefing = {{"en", "As for 36 and 37."}};
  EXPECT_THAT(codes(check_texts(s, {})), ElementsAre("warning /title/en text_other_tooth"));
}

}  // namespace
}  // namespace cusp::test
