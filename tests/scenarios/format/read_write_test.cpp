#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "scenarios/burs/bur_catalogue.h"
#include "scenarios/format/read.h"
#include "scenarios/format/schema.h"
#include "scenarios/format/write.h"
#include "scenarios/tissues/tissue_facts.h"
#include "tests/modules.h"
#include "tests/scenarios/format/changed_scenario.h"
#include "tests/scenarios/format/make_scenario.h"

namespace cusp::test {
namespace {

using nlohmann::json;
using test::ScenarioMaker;
using test::sound;
using test::sound_scenario;

TEST(ScenarioFile, WritingAndReadingIsTheIdentity) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const Scenario scenario = ScenarioMaker(seed).make();
    const std::string text = write_scenario(scenario);
    const auto again = read_scenario(text);
    ASSERT_TRUE(again) << key_of(again.error().code) << " " << again.error().where << " " << again.error().detail;
    ASSERT_EQ(*again, scenario);
    ASSERT_EQ(write_scenario(*again), text);
    const auto one_line = read_scenario(canonical_json(scenario));
    ASSERT_TRUE(one_line);
    ASSERT_EQ(*one_line, scenario);
  }
}

TEST(ScenarioFile, WhatIsWrittenFitsTheSchema) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    for (const Finding& finding : check_schema(write_scenario(ScenarioMaker(seed).make()))) {
      ADD_FAILURE() << finding.path << ": " << finding.detail;
    }
  }
}

TEST(ScenarioFile, EveryMethodHasItsKey) {
  // design.md, "Contact methods": five methods, the first of them in two readings.
  const std::pair<Method, const char*> keys[] = {{Method::occupancy, "occupancy"}, {Method::occupancy_pivot, "occupancy-pivot"},
                                                  {Method::ray, "ray"},             {Method::penalty, "penalty"},
                                                  {Method::gradient, "gradient"},   {Method::surface, "surface"}};
  EXPECT_EQ(std::size(keys), kMethods.size());
  for (const auto& [method, key] : keys) {
    json document = sound();
    document["method"] = key;
    EXPECT_TRUE(check_schema(document.dump()).empty()) << key;
    const auto scenario = read_scenario(document.dump());
    ASSERT_TRUE(scenario) << key;
    EXPECT_EQ(scenario->method, method) << key;
    EXPECT_EQ(json::parse(write_scenario(*scenario))["method"], key);
  }
}

TEST(ScenarioFile, LeftOutKeysTakeTheirDefaults) {
  json document = sound();
  for (const char* key : {"key", "phenomena", "protected", "limits", "tolerance"}) document.erase(key);
  document["device"].erase("admitted");
  document["device"].erase("tool_tilt_deg");
  document["target"].erase("box_size_mm");
  document["specimen"].erase("voxel_mm");
  const auto scenario = read_scenario(document.dump());
  ASSERT_TRUE(scenario) << scenario.error().where;
  EXPECT_EQ(*scenario, sound_scenario());
}

TEST(ScenarioFile, StatesALevelAndAnExpectedTimeOrNone) {
  const auto silent = read_scenario(sound().dump());
  ASSERT_TRUE(silent);
  EXPECT_EQ(silent->level, std::nullopt);
  EXPECT_EQ(silent->expected_time_s, 0.0);
  for (std::size_t i = 0; i < kLevelKeys.size(); ++i) {
    json document = sound();
    document["level"] = kLevelKeys[i];
    document["expected_time_s"] = 900;
    EXPECT_TRUE(check_schema(document.dump()).empty()) << kLevelKeys[i];
    const auto scenario = read_scenario(document.dump());
    ASSERT_TRUE(scenario) << kLevelKeys[i];
    EXPECT_EQ(scenario->level, static_cast<Level>(i));
    EXPECT_EQ(scenario->expected_time_s, 900.0);
    EXPECT_EQ(json::parse(write_scenario(*scenario)), document);
  }
}

TEST(ScenarioFile, AsksForAnOwnAssessmentOnlyWhereItSaysSo) {
  const auto silent = read_scenario(sound().dump());
  ASSERT_TRUE(silent);
  EXPECT_FALSE(silent->self_assessment);
  EXPECT_FALSE(json::parse(write_scenario(*silent)).contains("self_assessment"));  // hashes stay
  json document = sound();
  document["self_assessment"] = true;
  EXPECT_TRUE(check_schema(document.dump()).empty());
  const auto scenario = read_scenario(document.dump());
  ASSERT_TRUE(scenario);
  EXPECT_TRUE(scenario->self_assessment);
  EXPECT_EQ(json::parse(write_scenario(*scenario)), document);
  for (const json& other : {json(1), json("yes"), json()}) {
    EXPECT_EQ(with("/self_assessment", other).code, FormatError::wrong_type);
  }
}

TEST(ScenarioFile, NamesTheTemplateThatItsAuthorBeganWith) {
  const auto by_hand = read_scenario(sound().dump());
  ASSERT_TRUE(by_hand);
  EXPECT_FALSE(by_hand->made_with);
  EXPECT_FALSE(json::parse(write_scenario(*by_hand)).contains("template"));  // hashes stay
  json document = sound();
  document["template"] = {{"key", "class-2-adhesive"}, {"values", {{{"parameter", "mesial"}, {"value", 0}}}}};
  EXPECT_TRUE(check_schema(document.dump()).empty());
  const auto fitted = read_scenario(document.dump());
  ASSERT_TRUE(fitted);
  EXPECT_EQ(fitted->made_with, (TemplateUse{"class-2-adhesive", {{"mesial", 0}}}));
  EXPECT_EQ(json::parse(write_scenario(*fitted)), document);
  EXPECT_EQ(with("/template", 1).code, FormatError::wrong_type);
  EXPECT_EQ(with("/template", {{"key", "no such thing"}, {"values", json::array()}}).code, FormatError::out_of_range);
  EXPECT_EQ(with("/template", {{"key", "a"}, {"values", {{{"parameter", "b"}, {"value", "c"}}}}}).code, FormatError::wrong_type);
  const json twice = {{"parameter", "b"}, {"value", 1}};
  EXPECT_EQ(with("/template", {{"key", "a"}, {"values", {twice, twice}}}).code, FormatError::duplicate_value);
}

TEST(ScenarioFile, ATissueWithoutFiguresHasItsUsualOnesAndIsWrittenWithThem) {
  json document = sound();
  document["tissues"] = {{{"tissue", "enamel"}}, {{"tissue", "dentine"}, {"speed_mm_s", 7}}};
  EXPECT_TRUE(check_schema(document.dump()).empty());
  const auto scenario = read_scenario(document.dump());
  ASSERT_TRUE(scenario) << scenario.error().where;
  EXPECT_EQ(scenario->tissues[0].speed_mm_s, tissue_facts(Tissue::enamel).speed_mm_s.value);
  EXPECT_EQ(scenario->tissues[0].stiffness_n_per_mm, tissue_facts(Tissue::enamel).stiffness_n_per_mm.value);
  EXPECT_EQ(scenario->tissues[1].speed_mm_s, 7.0) << "the exercise's own value comes first";
  const json written = json::parse(write_scenario(*scenario));
  EXPECT_TRUE(written["tissues"][0].contains("speed_mm_s")) << "a published exercise must not follow the table";
}

TEST(ScenarioFile, AnInstrumentMayNameABurOfTheCatalogueAndIsWrittenOut) {
  for (const CatalogueBur& one : bur_catalogue()) {
    SCOPED_TRACE(one.bur.name);
    json document = sound();
    document["instruments"] = {{{"catalogue", one.bur.name}}};
    EXPECT_TRUE(check_schema(document.dump()).empty());
    const auto scenario = read_scenario(document.dump());
    ASSERT_TRUE(scenario) << scenario.error().where;
    EXPECT_EQ(scenario->instruments, std::vector{one.bur});
    const std::string written = write_scenario(*scenario);
    EXPECT_FALSE(json::parse(written)["instruments"][0].contains("catalogue")) << "what is published must not follow the table";
    EXPECT_EQ(json::parse(written)["instruments"][0].contains("head"), !one.bur.head.ball());
    EXPECT_TRUE(check_schema(written).empty());
    EXPECT_EQ(*read_scenario(written), *scenario);
  }
}

TEST(ScenarioFile, EveryPhenomenonReadsAndComesBack) {
  for (const std::string_view key : kPhenomenonKeys) {
    json document = sound();
    document["phenomena"] = {key};
    EXPECT_TRUE(check_schema(document.dump()).empty()) << key;
    const auto scenario = read_scenario(document.dump());
    ASSERT_TRUE(scenario) << key;
    EXPECT_EQ(json::parse(write_scenario(*scenario))["phenomena"], json({key}));
  }
}

TEST(ScenarioFile, PhenomenaBecomeWhatTheEngineRunsAndNothingElse) {
  EXPECT_EQ(phenomena_from_keys({}), Phenomena{});
  EXPECT_EQ(phenomena_from_keys({"friction", "sound"}), Phenomena{}) << "of no account to these";
  EXPECT_EQ(phenomena_from_keys({"heat"}), (Phenomena{Handpiece::none, false, true}));
  EXPECT_EQ(phenomena_from_keys({"vibration"}), Phenomena{}) << "without a spindle nothing turns";
  EXPECT_EQ(phenomena_from_keys({"vibration", "heat", "spindle-slow"}), (Phenomena{Handpiece::slow, true, true}));
  EXPECT_EQ(phenomena_from_keys({"spindle-turbine", "spindle-slow"}).handpiece, Handpiece::turbine);
  EXPECT_EQ(phenomena_from_keys({"spindle-electric"}).handpiece, Handpiece::electric);
}

TEST(ScenarioFile, CariousLesionsAndSurroundingsReadAndComeBack) {
  Scenario s = sound_scenario();
  s.specimen = SpecimenSource{};
  s.specimen.generator = "tooth";
  s.specimen.fdi = 46;
  const std::string plain = write_scenario(s);
  for (const char* key : {"typodont", "around", "lesions"}) EXPECT_EQ(plain.find(key), plain.npos) << key;  // hashes stay
  s.specimen.typodont = true;
  s.specimen.around = {"neighbours", "gingiva", "bone", "jaw"};
  s.specimen.lesions = {{"proximal", "mesial", 1.0, 0.5, 0.25}, {"root", "buccal", 1.5, 0.0, 1.0}};
  const std::string text = write_scenario(s);
  const auto read = read_scenario(text);
  ASSERT_TRUE(read) << read.error().where;
  EXPECT_EQ(read->specimen, s.specimen);
  EXPECT_TRUE(check_schema(text).empty());
}

TEST(ScenarioFile, AFileIsNamedBeforeThePlace) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("cusp-format-" + std::to_string(std::random_device{}()));
  std::filesystem::create_directories(folder);
  EXPECT_EQ(read_scenario_file(folder).error().code, FormatError::unreadable);
  std::ofstream(folder / "scenario.json") << write_scenario(sound_scenario());
  ASSERT_TRUE(read_scenario_file(folder));
  EXPECT_EQ(*read_scenario_file(folder / "scenario.json"), sound_scenario());
  json document = sound();
  document["target"]["depth_mm"] = -1;
  std::ofstream(folder / "scenario.json") << document.dump();
  EXPECT_EQ(read_scenario_file(folder).error().where, (folder / "scenario.json").string() + "#/target/depth_mm");
  std::ofstream(folder / "scenario.json") << "{";
  EXPECT_EQ(read_scenario_file(folder).error().where, (folder / "scenario.json").string() + ":1:2");
  EXPECT_EQ(read_scenario_file(folder / "missing").error().code, FormatError::unreadable);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace cusp::test
