#include "scenarios/burs/bur_catalogue.h"
#include "scenarios/format/validate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "scenarios/format/schema.h"
#include "scenarios/format/write.h"
#include "tests/modules.h"
#include "tests/scenarios/format/make_scenario.h"

namespace cusp::test {
namespace {

using test::sound_scenario;
using ::testing::IsEmpty;

std::vector<std::string> codes(const std::vector<Finding>& findings) {
  std::vector<std::string> out;
  for (const Finding& f : findings) out.push_back((f.severity == Severity::error ? "error " : "warning ") + f.path + " " + f.code);
  return out;
}

/// The findings of the sound scenario after one change.
template <class Change>
std::vector<std::string> after(Change change, const SpecimenFacts* facts = nullptr) {
  Scenario scenario = sound_scenario();
  change(scenario);
  return codes(validate(scenario, facts));
}

SpecimenFacts plastic_block() {
  return {Vec3(-10, -10, -10), Vec3(10, 10, 0), 0.1, {Tissue::plastic}};
}

TEST(Validate, ASoundScenarioHasNoFinding) {
  EXPECT_THAT(codes(validate(sound_scenario())), IsEmpty());
  const SpecimenFacts facts = plastic_block();
  EXPECT_THAT(codes(validate(sound_scenario(), &facts)), IsEmpty());
  EXPECT_THAT(codes(validate_text(write_scenario(sound_scenario()), &facts)), IsEmpty());
}

TEST(Validate, FindsWhatMakesAnExerciseImpossible) {
  using ::testing::Contains;
  EXPECT_THAT(after([](Scenario& s) { s.instruments.clear(); }), Contains("error /instruments no_instrument"));
  EXPECT_THAT(after([](Scenario& s) { s.target.outline.paths.clear(); }), Contains("error /target/paths no_target"));
  EXPECT_THAT(after([](Scenario& s) { s.target.outline.paths.push_back(s.target.outline.paths[0]); }), Contains("error /target/paths path_count"));
  EXPECT_THAT(after([](Scenario& s) { s.target.outline.paths[0].pop_back(); }), Contains("error /target/paths/0 point_count"));
  EXPECT_THAT(after([](Scenario& s) {
                s.target.outline.shape = "outline";  // about one point: a disc
                s.target.outline.paths[0].pop_back();
              }),
              ::testing::Not(Contains(::testing::HasSubstr("point_count"))));
  EXPECT_THAT(after([](Scenario& s) { s.target.outline.shape = "box"; }), Contains("error /target/paths/0 point_count"));
  EXPECT_THAT(after([](Scenario& s) {
                s.target.outline.shape = "box";
                s.target.outline.paths[0].pop_back();
              }),
              Contains("error /target/box_size_mm empty_target"));
  EXPECT_THAT(after([](Scenario& s) { s.rubric.criteria.clear(); }), Contains("error /rubric/criteria no_criteria"));
  EXPECT_THAT(after([](Scenario& s) { s.rubric.criteria[1].weight = 0; }), Contains("error /rubric/criteria/1/weight weight_zero"));
  EXPECT_THAT(after([](Scenario& s) { s.rubric.criteria[0].bands.acc_lo = 99; }),
              Contains("error /rubric/criteria/0/bands bands_not_ordered"));
  EXPECT_THAT(after([](Scenario& s) { s.protected_parts = {Tissue::pulp}; }), Contains("error /protected/0 protected_missing"));
  EXPECT_THAT(after([](Scenario& s) { s.rubric.critical = {"pulp_exposure"}; }), Contains("error /rubric/critical protected_missing"));
  EXPECT_THAT(after([](Scenario& s) {
                s.phenomena = {"heat"};
                s.rubric.critical = {"dry_cutting", "dry_cutting"};
              }),
              ::testing::ElementsAre("error /rubric/critical/1 critical_twice"));
}

TEST(Validate, WarnsOfWhatIsProtectedTwice) {
  using ::testing::Contains;
  const std::string found = "warning /protected/1 protected_twice";
  for (const Damage severity : {Damage::removal, Damage::touch})
    EXPECT_THAT(after([severity](Scenario& s) { s.protected_parts = {Tissue::plastic, Protected(Tissue::plastic, severity)}; }), Contains(found));
  Region ball;
  ball.kind = RegionKind::sphere;
  ball.radius_mm = 1;
  EXPECT_THAT(after([&](Scenario& s) { s.protected_parts = {Protected(ball), Protected(ball)}; }), Contains(found));
  Region plastic;
  plastic.kind = RegionKind::tissue;
  plastic.tissue = Tissue::plastic;
  EXPECT_THAT(after([&](Scenario& s) { s.protected_parts = {Tissue::plastic, Protected(plastic, Damage::touch)}; }), Contains(found))
      << "as a tissue, and as a region of it";
  Region other = ball;
  other.radius_mm = 2;
  EXPECT_THAT(after([&](Scenario& s) { s.protected_parts = {Protected(ball), Protected(other), Tissue::plastic}; }), IsEmpty());
}

TEST(Validate, TakesPulpThatIsProtectedAsARegionForProtected) {
  Region pulp;
  pulp.kind = RegionKind::tissue;
  pulp.tissue = Tissue::pulp;
  const auto with = [&](std::vector<Protected> parts) {
    return after([&](Scenario& s) {
      s.tissues.push_back({Tissue::pulp, 1, 1});
      s.protected_parts = std::move(parts);
      s.rubric.critical = {"pulp_exposure"};
    });
  };
  EXPECT_THAT(with({}), ::testing::ElementsAre("error /rubric/critical protected_missing"));
  EXPECT_THAT(with({Tissue::pulp}), IsEmpty());
  EXPECT_THAT(with({Protected(pulp, Damage::touch)}), IsEmpty());
}

TEST(Validate, PhenomenaMustFitTogetherAndWhatIsGradedMustBeReckoned) {
  using ::testing::Contains;
  EXPECT_THAT(after([](Scenario& s) { s.phenomena = {"spindle-turbine", "vibration", "sound", "heat", "friction"}; }), IsEmpty());
  EXPECT_THAT(after([](Scenario& s) { s.phenomena = {"spindle-turbine", "spindle-slow"}; }),
              Contains("error /phenomena two_spindles"));
  EXPECT_THAT(after([](Scenario& s) { s.phenomena = {"heat", "vibration"}; }), Contains("error /phenomena/1 spindle_missing"));
  EXPECT_THAT(after([](Scenario& s) { s.phenomena = {"sound"}; }), Contains("error /phenomena/0 spindle_missing"));
  EXPECT_THAT(after([](Scenario& s) { s.rubric.critical = {"dry_cutting"}; }), Contains("error /rubric/critical/0 heat_missing"));
  EXPECT_THAT(after([](Scenario& s) { s.rubric.criteria[1].metric = "dry_cutting_time"; }),
              Contains("error /rubric/criteria/1/metric heat_missing"));
  EXPECT_THAT(after([](Scenario& s) {
                s.phenomena = {"heat"};
                s.rubric.critical = {"dry_cutting"};
                s.rubric.criteria.push_back({"temperature_rise_peak", 10, {0, 0, 0, 2, 4, 5.5}});
              }),
              IsEmpty());
}

TEST(Validate, APassMarkThatNobodyReachesIsAnError) {
  using ::testing::Contains;
  using ::testing::ElementsAre;
  using ::testing::Not;
  // Depth wanted at 3 mm while the target is 2 mm deep: a perfect attempt reads 2.0, exactly at fail_lo, so 0 of 40 points.
  const auto too_deep = [](Scenario& s) { s.rubric.criteria[1].bands = {2, 2.5, 2.9, 3.1, 3.5, 4}; };
  EXPECT_THAT(after(too_deep), ElementsAre("error /rubric/pass pass_unreachable",
                                           "warning /rubric/criteria/1/bands target_scores_less"));
  EXPECT_THAT(after([&](Scenario& s) {
                too_deep(s);
                s.rubric.pass = 60;
              }),
              Not(Contains("error /rubric/pass pass_unreachable")));
  // Reads 2.0 at acc_lo: half of 40 points, so 80 are left.
  const auto half = [](double pass) {
    return [pass](Scenario& s) {
      s.rubric.criteria[1].bands = {1.5, 2, 2.9, 3.1, 3.5, 4};
      s.rubric.pass = pass;
    };
  };
  EXPECT_THAT(after(half(80)), Not(Contains("error /rubric/pass pass_unreachable")));
  EXPECT_THAT(after(half(80.01)), Contains("error /rubric/pass pass_unreachable"));
  // More than 100 % cannot be removed; a time below nothing cannot be measured.
  EXPECT_THAT(after([](Scenario& s) {
                s.rubric.criteria = {{"time", 10, {-9, -8, -7, -6, -5, -4}}};
              }),
              Contains("error /rubric/pass pass_unreachable"));
}

TEST(Validate, OneCriterionAtLeastSuitsTheSimplestDevice) {
  using ::testing::Contains;
  using ::testing::Not;
  const auto all = [](Scenario& s) {
    for (Criterion& c : s.rubric.criteria) c.needs_dof = 6;
  };
  EXPECT_THAT(after(all), Contains("error /rubric/pass pass_unreachable"));
  EXPECT_THAT(after([&](Scenario& s) {
                all(s);
                s.device.needs_dof = 6;
              }),
              Not(Contains("error /rubric/pass pass_unreachable")));
  EXPECT_THAT(after([&](Scenario& s) {
                all(s);
                s.rubric.criteria[0].needs_dof = 3;
              }),
              Not(Contains("error /rubric/pass pass_unreachable")));
  // An exact cut reads 2.0 mm, of which it earns nothing; what earns the 60 points is not graded on a device of three axes.
  const auto on = [](int axes) {
    return [axes](Scenario& s) {
      s.device.needs_dof = axes;
      s.rubric.pass = 60;
      s.rubric.criteria[0].needs_dof = 6;
      s.rubric.criteria[1].bands = {2, 2.5, 2.9, 3.1, 3.5, 4};
    };
  };
  EXPECT_THAT(after(on(3)), Contains("error /rubric/pass pass_unreachable"));
  EXPECT_THAT(after(on(6)), Not(Contains("error /rubric/pass pass_unreachable")));
}

TEST(Validate, EveryPointCanBeAskedForWhateverTheWeightsRoundTo) {
  EXPECT_THAT(after([](Scenario& s) {
                s.rubric.pass = 100;
                s.rubric.criteria.resize(1);
                s.rubric.criteria[0].weight = 0.17;  // 100 times it, divided by it, is 1.4e-14 below 100
              }),
              IsEmpty());
}

TEST(Validate, WarnsOfWhatTheVoxelsCannotShow) {
  using ::testing::ElementsAre;
  // 2.5 voxels of 0.1 mm.
  EXPECT_THAT(after([](Scenario& s) { s.target.outline.width_mm = 0.24; }),
              ElementsAre("warning /target/width_mm feature_thin", "warning /target/width_mm bur_wider_than_target"));
  EXPECT_THAT(after([](Scenario& s) {
                s.instruments[0].name = "own";
                s.instruments[0].radius_mm = 0.29;
              }),
              ElementsAre("warning /instruments/0/radius_mm bur_small", "warning /instruments/0/neck_radius_mm neck_wider_than_ball"));
  EXPECT_THAT(after([](Scenario& s) {
                s.instruments[0].name = "own";
                s.instruments[0].radius_mm = 0.3;
                s.instruments[0].neck_radius_mm = 0.2;
              }),
              IsEmpty());
  EXPECT_THAT(after([](Scenario& s) { s.leeway.side_mm = 0.05; }), ElementsAre("warning /leeway/side_mm leeway_below_voxel"));
}

TEST(Validate, WarnsOfWhatTheBurCannotCut) {
  using ::testing::ElementsAre;
  EXPECT_THAT(after([](Scenario& s) { s.target.outline.width_mm = 1.3; }), ElementsAre("warning /target/width_mm bur_wider_than_target"));
  EXPECT_THAT(after([](Scenario& s) { s.target.outline.corner_radius_mm = 0.2; }),
              ElementsAre("warning /target/corner_radius_mm corner_below_bur"));
  EXPECT_THAT(after([](Scenario& s) { s.tissues[0].speed_mm_s = 0; }), ElementsAre("warning /tissues nothing_can_be_cut"));
}

TEST(Validate, RefusesAMarginalRidgeBetweenNeighboursOfTheSamePlastic) {
  const auto of = [](const SpecimenSource& tooth) {
    return after([&](Scenario& s) {
      s.specimen = tooth;
      s.rubric.criteria[1] = {"ridge_mesial", 40, {1.2, 1.6, 2.0, 100, 100, 100}};
    });
  };
  SpecimenSource tooth;
  tooth.generator = "tooth";
  tooth.fdi = 36;
  tooth.around = {"neighbours"};
  EXPECT_THAT(of(tooth), IsEmpty()) << "natural neighbours have tissues of their own";
  tooth.typodont = true;
  EXPECT_THAT(of(tooth), ::testing::ElementsAre("error /rubric/criteria/1/metric ridge_of_plastic"));
  tooth.around = {"jaw"};
  EXPECT_THAT(of(tooth), ::testing::ElementsAre("error /rubric/criteria/1/metric ridge_of_plastic")) << "a jaw has neighbours";
  tooth.around = {"gingiva"};
  EXPECT_THAT(of(tooth), IsEmpty());
}

TEST(Validate, WarnsOfBandsThatNoMeasureLeaves) {
  using ::testing::ElementsAre;
  using ::testing::HasSubstr;
  const auto with = [](const char* metric, const Bands& bands) {
    return after([&](Scenario& s) { s.rubric.criteria.push_back({metric, 10, bands}); });
  };
  EXPECT_THAT(with("overcut_beyond_mesial_wall", {0, 0, 0, 1000, 1000, 1000}), ElementsAre(HasSubstr("bands_without_edge")));
  EXPECT_THAT(with("contact_broken", {0, 0, 0, 1, 1, 1}), ElementsAre(HasSubstr("bands_without_edge"))) << "yes or no";
  EXPECT_THAT(with("time", {0, 0, 0, 86400, 86400, 86400}), ElementsAre(HasSubstr("bands_without_edge")));
  EXPECT_THAT(with("time", {0, 0, 0, 1200, 1800, 2400}), IsEmpty());
  EXPECT_THAT(with("remaining_over_pulp", {0.3, 0.5, 0.8, 100, 100, 100}), IsEmpty()) << "its low edge costs points";
}

TEST(Validate, WarnsOfAFloorThatNoBurReaches) {
  using ::testing::ElementsAre;
  const auto with = [](double depth_mm, double width_mm) {
    return after([&](Scenario& s) {
      Outline& t = s.target.outline;
      t.depth_mm = depth_mm;
      t.width_mm = width_mm;
      for (Vec3& p : t.paths[0]) p.z = -depth_mm;
      s.instruments[0].shank_radius_mm = 0.9;  // the neck of 4 mm begins 0.7 mm above the tip
      s.rubric.criteria.resize(1);             // no criterion of depth
    });
  };
  EXPECT_THAT(with(4.7, 1.6), IsEmpty());
  EXPECT_THAT(with(4.8, 1.6), ElementsAre("warning /target/depth_mm bur_short"));
  EXPECT_THAT(with(4.8, 1.8), IsEmpty()) << "the shank goes in";
}

TEST(Validate, WarnsOfABurThatIsNotWhatItsCatalogueNumberNames) {
  using ::testing::ElementsAre;
  EXPECT_THAT(after([](Scenario& s) { s.instruments[0].radius_mm = s.target.outline.corner_radius_mm = 0.75; }),
              ElementsAre("warning /instruments/0/name bur_not_of_number"));
  EXPECT_THAT(after([](Scenario& s) {
                s.instruments[0].name = "own";
                s.instruments[0].radius_mm = 0.65;
              }),
              IsEmpty());
}

TEST(Validate, WarnsOfAHeadShorterThanTheVoxelsCanShow) {
  using ::testing::ElementsAre;
  // 33 1/2 is 0.6 mm wide and high: below 3 voxels of 0.105 mm radius, and 6 of height.
  EXPECT_THAT(after([](Scenario& s) {
                s.instruments = {catalogue_bur("33 1/2")->bur};
                s.specimen.voxel_mm = 0.105;
              }),
              ElementsAre("warning /instruments/0/radius_mm bur_small", "warning /instruments/0/head head_short"));
}

TEST(Validate, KnowsThatAFlatEndLeavesASharpCorner) {
  using ::testing::ElementsAre;
  const auto with = [](const char* number, double corner_mm) {
    return after([&](Scenario& s) {
      s.instruments = {catalogue_bur(number)->bur};
      s.target.outline.corner_radius_mm = corner_mm;
    });
  };
  EXPECT_THAT(with("57", 0.0), IsEmpty());
  EXPECT_THAT(with("1157", 0.2), ElementsAre("warning /target/corner_radius_mm corner_below_bur")) << "a dome's is its radius";
  EXPECT_THAT(with("245", 0.25), IsEmpty()) << "the catalogue has 0.25 mm";
  EXPECT_THAT(with("245", 0.2), ElementsAre("warning /target/corner_radius_mm corner_below_bur"));
}

TEST(Validate, WarnsOfTextsInOneLanguageOnlyAndPointsOffTheFloor) {
  using ::testing::ElementsAre;
  EXPECT_THAT(after([](Scenario& s) { s.briefing.erase("de"); }), ElementsAre("warning /briefing language_missing"));
  EXPECT_THAT(after([](Scenario& s) {
                s.time_limit_s = 300;
                s.expected_time_s = 301;
              }),
              ElementsAre("warning /expected_time_s expected_beyond_limit"));
  EXPECT_THAT(after([](Scenario& s) { s.target.outline.paths[0][1].z = -1.9; }), ElementsAre("warning /target/paths/0/1 point_off_floor"));
}

TEST(Validate, HoldsTheTargetAgainstTheSpecimen) {
  using ::testing::Contains;
  using ::testing::ElementsAre;
  const SpecimenFacts facts = plastic_block();
  EXPECT_THAT(after([](Scenario& s) { s.target.outline.paths[0][1].x = 9.3; }, &facts), ElementsAre("error /target/paths/0/1 target_outside"));
  EXPECT_THAT(after([](Scenario& s) { s.target.outline.paths[0][1].x = 9.2; }, &facts), IsEmpty());  // 9.2 + 1.6 / 2 = 10
  EXPECT_THAT(after([](Scenario& s) { s.target.outline.depth_mm = 10.5; }, &facts), Contains("error /target/depth_mm target_outside"));
  EXPECT_THAT(after([](Scenario& s) { s.target.outline.top_mm = 3; }, &facts), Contains("error /target/depth_mm target_outside"));
  EXPECT_THAT(after([](Scenario& s) { s.specimen.voxel_mm = 0.2; }, &facts), Contains("error /specimen/voxel_mm voxel_mismatch"));
  EXPECT_THAT(after([](Scenario& s) { s.tissues[0].tissue = Tissue::bone; }, &facts),
              ElementsAre("error /tissues tissue_missing", "warning /tissues/0 tissue_unused"));
  EXPECT_THAT(after(
                  [](Scenario& s) {
                    s.tissues.push_back({Tissue::pulp, 1, 1});
                    s.protected_parts = {Tissue::pulp};
                  },
                  &facts),
              Contains("error /protected/0 protected_missing"));
}

TEST(Validate, TakesAVoxelSizeThatAFileHoldsIn32Bits) {
  SpecimenFacts facts = plastic_block();
  facts.voxel_mm = 0.1f;  // 0.1000000015
  EXPECT_THAT(after([](Scenario&) {}, &facts), IsEmpty());
  facts.voxel_mm = 0.1001;
  EXPECT_THAT(after([](Scenario&) {}, &facts), ::testing::ElementsAre("error /specimen/voxel_mm voxel_mismatch"));
}

TEST(Validate, AVoxelSizeThatMissesTheRangeByARoundingIsItsEnd) {
  EXPECT_EQ(stated_voxel_mm(0.04f), 0.04);  // 0.0399999991
  EXPECT_EQ(stated_voxel_mm(0.1f), static_cast<double>(0.1f));
  EXPECT_EQ(stated_voxel_mm(0.0399), std::nullopt);
  EXPECT_EQ(stated_voxel_mm(1.001), std::nullopt);
  EXPECT_EQ(stated_voxel_mm(std::numeric_limits<double>::quiet_NaN()), std::nullopt);
}

TEST(Validate, KnowsAVolumeByItsOccupiedVoxels) {
  VoxelVolume volume(Grid{IVec3(10, 8, 6), 0.5, Vec3(-1, 0, 2)});
  for (int x = 2; x <= 5; ++x) {
    const std::size_t at = volume.grid.index({x, 3, 4});
    volume.s[at] = kSolid;
    volume.tissue[at] = x < 4 ? Tissue::enamel : Tissue::pulp;
  }
  volume.s[volume.grid.index({9, 7, 5})] = kHalf - 1;  // not occupied
  volume.tissue[volume.grid.index({9, 7, 5})] = Tissue::bone;
  const SpecimenFacts facts = facts_of(volume);
  EXPECT_EQ(facts.low_mm, Vec3(-1 + 2 * 0.5 - 0.25, 1.5 - 0.25, 4 - 0.25));
  EXPECT_EQ(facts.high_mm, Vec3(-1 + 5 * 0.5 + 0.25, 1.5 + 0.25, 4 + 0.25));
  EXPECT_EQ(facts.tissues, (std::vector<Tissue>{Tissue::enamel, Tissue::pulp}));
}

TEST(Validate, AnUnreadableTextYieldsItsReasonAndTheSchemasFindings) {
  std::string text = write_scenario(sound_scenario());
  text.replace(text.find("\"depth_mm\": 2"), 13, "\"depth_mm\": -2");
  text.replace(text.find("\"surface\""), 9, "\"telepathy\"");
  const auto findings = validate_text(text);
  ASSERT_GE(findings.size(), 3u);
  EXPECT_EQ(findings[0].code, "unknown_method");
  EXPECT_EQ(findings[0].path, "/method");
  const auto schema_at = [&](const std::string& path) {
    return std::any_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.code == "schema" && f.path == path; });
  };
  EXPECT_TRUE(schema_at("/method"));
  EXPECT_TRUE(schema_at("/target/depth_mm"));
  EXPECT_TRUE(has_error(findings));

  const auto broken = validate_text("{");
  ASSERT_EQ(broken.size(), 1u);
  EXPECT_EQ(broken[0].code, "broken_json");
  EXPECT_EQ(broken[0].path, "1:2");
}

}  // namespace
}  // namespace cusp::test
