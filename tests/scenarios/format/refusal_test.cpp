// What the reader refuses, and the place that it names.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

#include "scenarios/format/ranges.h"
#include "scenarios/format/read.h"
#include "scenarios/format/schema.h"
#include "scenarios/format/write.h"
#include "tests/modules.h"
#include "tests/scenarios/format/changed_scenario.h"
#include "tests/scenarios/format/make_scenario.h"

namespace cusp::test {
namespace {

using nlohmann::json;
using test::failure_of;
using test::ScenarioMaker;
using test::sound;
using test::sound_scenario;
using test::with;
using test::without;

TEST(RefusedScenarioFile, ABurOfNoCatalogueIsRefused) {
  EXPECT_EQ(with("/instruments/0", {{"catalogue", "12"}}).code, FormatError::unknown_bur);
  EXPECT_EQ(with("/instruments/0", {{"catalogue", "12"}}).where, "/instruments/0/catalogue");
  EXPECT_EQ(with("/instruments/0", {{"catalogue", 56}}).code, FormatError::wrong_type);
  EXPECT_EQ(with("/instruments/0", {{"catalogue", "56"}, {"radius_mm", 1}}).code, FormatError::unknown_key) << "one or the other";
}

TEST(RefusedScenarioFile, AHeadThatIsNoConvexBodyOfTheBursSizeIsRefused) {
  const auto head = [](const json& pieces) {
    json document = sound();
    document["instruments"][0]["radius_mm"] = 0.5;
    document["instruments"][0]["head"] = pieces;
    return document.dump();
  };
  ASSERT_TRUE(read_scenario(head({{-0.5, 0, -0.5, 0.5}, {-0.5, 0.5, 3.5, 0.5}, {3.5, 0.5, 3.5, 0}})));
  ASSERT_TRUE(read_scenario(head({{-0.5, 0, 0, 0.5, 0, 0, 0.5}, {0, 0.5, 3.5, 0.5}, {3.5, 0.5, 3.5, 0}})));
  const json broken[] = {
      json::array(),
      {{-0.5, 0, -0.5, 0.5}, {-0.5, 0.5, 3.5, 0.5}},                          // open
      {{-0.5, 0, -0.5, 0.5}, {-0.5, 0.4, 3.5, 0.4}, {3.5, 0.4, 3.5, 0}},      // does not join
      {{-0.5, 0, -0.5, 0.3}, {-0.5, 0.3, 3.5, 0.5}, {3.5, 0.5, 4, 0.5}, {4, 0.5, 3, 0}},  // hollow
      {{-0.5, 0, -0.5, 0.4}, {-0.5, 0.4, 3.5, 0.4}, {3.5, 0.4, 3.5, 0}},      // narrower than the bur
      {{0, 0, 0, 0.5}, {0, 0.5, 4, 0.5}, {4, 0.5, 4, 0}},                     // the pivot is at its tip
      {{-0.5, 0, 0, 0.5, 0, 0}},                                              // an arc without a radius
      {{-0.5, 0, 0, 0.5, 0, 0, 0}}};
  for (const json& pieces : broken) EXPECT_EQ(failure_of(head(pieces)).code, FormatError::out_of_range) << pieces;
  EXPECT_EQ(failure_of(head("ball")).code, FormatError::wrong_type);
  EXPECT_EQ(failure_of(head({{-0.5, 0, "a", 0.5}})).code, FormatError::wrong_type);
}

TEST(RefusedScenarioFile, BrokenJsonIsNamedWithLineAndColumn) {
  FormatFailure failure = failure_of("{\n  \"format\": 1,\n  \"id\" 7\n}");
  EXPECT_EQ(failure.code, FormatError::broken_json);
  EXPECT_EQ(failure.where, "3:8");  // the 7, where a colon should be
  failure = failure_of("{\"title\": \"ü\xf0\x9f\xa6\xb7\" x}");
  EXPECT_EQ(failure.where, "1:16");  // the x, counted by hand: characters, not the 20 bytes before it
  EXPECT_EQ(failure_of("").code, FormatError::broken_json);
  EXPECT_EQ(failure_of("{\"format\": 1").code, FormatError::broken_json);
  EXPECT_EQ(failure_of("{} {}").code, FormatError::broken_json);
  EXPECT_EQ(failure_of("{\"title\": \"\xff\"}").code, FormatError::broken_json);
  EXPECT_EQ(failure_of("[]").code, FormatError::wrong_type);
  EXPECT_EQ(failure_of("7").code, FormatError::wrong_type);
}

TEST(RefusedScenarioFile, NumbersThatAreNoneAreNamed) {
  std::string text = write_scenario(sound_scenario());
  const auto replaced = [&](const std::string& by) {
    std::string out = text;
    const std::string from = "\"depth_mm\": 2";
    out.replace(out.find(from), from.size(), "\"depth_mm\": " + by);
    return out;
  };
  const auto line =
      std::to_string(std::count(text.begin(), text.begin() + static_cast<long>(text.find("\"depth_mm\"")), '\n') + 1);
  for (const std::string number : {"NaN", "Infinity", "-Infinity", "nan", "1e999", "-1e400"}) {
    SCOPED_TRACE(number);
    const FormatFailure failure = failure_of(replaced(number));
    EXPECT_EQ(failure.code, FormatError::not_finite);
    EXPECT_EQ(failure.where.substr(0, failure.where.find(':')), line);
  }
  EXPECT_EQ(failure_of(replaced("null")).code, FormatError::wrong_type);
}

TEST(RefusedScenarioFile, ANumberThatDoesNotReadNamesTheRangeThatHolds) {
  EXPECT_EQ(with("/rubric/criteria/0/weight", -5).detail, "[0.1, 1000]");
  EXPECT_EQ(with("/rubric/pass", -1).detail, "[1, 100]");
  EXPECT_EQ(with("/tissues/0/speed_mm_s", -1).detail, "0 or [0.01, 100]");
  EXPECT_EQ(with("/limits/time_s", -1).detail, "0 or [10, 86400]");
}

TEST(RefusedScenarioFile, ANewerFormatIsRefusedBeforeItsUnknownKeys) {
  json document = sound();
  document["format"] = 3;
  document["holograms"] = true;
  const FormatFailure failure = failure_of(document.dump());
  EXPECT_EQ(failure.code, FormatError::newer_format);
  EXPECT_EQ(failure.where, "/format");
  EXPECT_EQ(failure.detail, "3");
  EXPECT_EQ(with("/format", 18446744073709551615u).code, FormatError::newer_format);
  EXPECT_EQ(with("/format", 0).code, FormatError::out_of_range);
  EXPECT_EQ(with("/format", -3).code, FormatError::out_of_range);
  EXPECT_EQ(with("/format", "1").code, FormatError::wrong_type);
  EXPECT_EQ(without("", "format").code, FormatError::missing_key);
}

TEST(RefusedScenarioFile, UnknownKeysAreRefusedWhereTheyStand) {
  const std::pair<const char*, const char*> places[] = {
      {"/extra", "/extra"},
      {"/specimen/fdi", "/specimen/fdi"},  // a block has no number
      {"/tissues/0/colour", "/tissues/0/colour"},
      {"/instruments/0/length_mm", "/instruments/0/length_mm"},
      {"/device/force", "/device/force"},
      {"/target/angle", "/target/angle"},
      {"/leeway/top_mm", "/leeway/top_mm"},
      {"/limits/points", "/limits/points"},
      {"/rubric/bonus", "/rubric/bonus"},
      {"/rubric/criteria/1/label", "/rubric/criteria/1/label"},
      {"/rubric/criteria/0/bands/best", "/rubric/criteria/0/bands/best"},
      {"/tolerance/mm", "/tolerance/mm"},
  };
  for (const auto& [pointer, where] : places) {
    const FormatFailure failure = with(pointer, 1);
    EXPECT_EQ(failure.code, FormatError::unknown_key) << pointer;
    EXPECT_EQ(failure.where, where);
  }
  json odd = sound();
  odd["a/b~c"] = 1;
  EXPECT_EQ(failure_of(odd.dump()).where, "/a~1b~0c");  // RFC 6901
}

TEST(RefusedScenarioFile, AKeyThatStandsTwiceIsRefused) {
  std::string text = write_scenario(sound_scenario());
  const std::string from = "\"floor_mm\": 0.3,";
  text.replace(text.find(from), from.size(), "\"floor_mm\": 0.3, \"floor_mm\": 9,");
  const FormatFailure failure = failure_of(text);
  EXPECT_EQ(failure.code, FormatError::duplicate_key);
  EXPECT_EQ(failure.where, "/leeway/floor_mm");
  const FormatFailure in_list = failure_of(R"({"tissues": [{"tissue": 1}, {"tissue": 1, "tissue": 2}]})");
  EXPECT_EQ(in_list.where, "/tissues/1/tissue");
}

TEST(RefusedScenarioFile, MissingKeysAreNamed) {
  const std::pair<const char*, const char*> places[] = {
      {"", "id"},
      {"", "version"},
      {"", "title"},
      {"", "briefing"},
      {"", "specimen"},
      {"", "tissues"},
      {"", "instruments"},
      {"", "device"},
      {"", "method"},
      {"", "target"},
      {"", "leeway"},
      {"", "rubric"},
      {"/specimen", "generator"},
      {"/tissues/0", "tissue"},
      {"/instruments/0", "radius_mm"},
      {"/device", "full_force_n"},
      {"/target", "paths"},
      {"/leeway", "side_mm"},
      {"/rubric", "pass"},
      {"/rubric/criteria/1", "bands"},
      {"/rubric/criteria/1/bands", "fail_hi"},
      {"/tolerance", "points"},
  };
  for (const auto& [parent, key] : places) {
    const FormatFailure failure = without(parent, key);
    EXPECT_EQ(failure.code, FormatError::missing_key);
    EXPECT_EQ(failure.where, std::string(parent) + "/" + key);
  }
}

/// Every leaf and every container, turned into values of other types: the reader refuses each, at its place.
TEST(RefusedScenarioFile, WrongTypesAreRefusedAtTheirPlace) {
  const json document = sound();
  const json flat = document.flatten();
  const json others[] = {nullptr, true, "text", 1.5, json::array(), json::object(), json::array({json::object()})};
  int refused = 0;
  for (auto it = flat.begin(); it != flat.end(); ++it) {
    for (const json& other : others) {
      const json& now = document.at(json::json_pointer(it.key()));
      if (now.type() == other.type() || (now.is_number() && other.is_number()) || now.is_structured()) continue;
      json changed = document;
      changed[json::json_pointer(it.key())] = other;
      const FormatFailure failure = failure_of(changed.dump());
      EXPECT_TRUE(failure.code == FormatError::wrong_type) << it.key() << " " << other << ": " << key_of(failure.code);
      EXPECT_EQ(failure.where.substr(0, it.key().size()), it.key()) << other;
      EXPECT_FALSE(check_schema(changed.dump()).empty()) << it.key() << " " << other;
      ++refused;
    }
  }
  EXPECT_GT(refused, 200);
}

struct Bound {
  const char* pointer;
  json inside, outside;
};
const Bound kBounds[] = {
    {"/version", 1, 0},
    {"/version", 1000000000, 1000000001},
    {"/key", "a-1", ""},
    {"/key", std::string(64, 'k'), std::string(65, 'k')},
    {"/title", {{"en", "x"}}, {{"en", ""}}},
    {"/title", {{"en", std::string(kMostTextCharacters, 'x')}}, {{"en", std::string(kMostTextCharacters + 1, 'x')}}},
    {"/specimen/voxel_mm", 0.04, 0.0399},
    {"/specimen/voxel_mm", 1, 1.001},
    {"/tissues/0/stiffness_n_per_mm", 1e-9, 0},
    {"/tissues/0/stiffness_n_per_mm", 20, 20.001},
    {"/tissues/0/speed_mm_s", 0, -1e-9},
    {"/tissues/0/speed_mm_s", 100, 100.1},
    {"/instruments/0/name", "x", ""},
    {"/instruments/0/radius_mm", 1e-9, 0},
    {"/instruments/0/radius_mm", 10, 10.1},
    {"/instruments/0/neck_radius_mm", 1e-9, 0},
    {"/instruments/0/neck_radius_mm", 10, 10.1},
    {"/instruments/0/neck_length_mm", 0, -1},
    {"/instruments/0/neck_length_mm", 50, 50.1},
    {"/instruments/0/shank_radius_mm", 1e-9, 0},
    {"/instruments/0/shank_radius_mm", 10, 10.1},
    {"/instruments/0/shank_length_mm", 0, -1},
    {"/instruments/0/shank_length_mm", 100, 100.1},
    {"/device/needs_dof", 3, 2},
    {"/device/needs_dof", 6, 7},
    {"/device/full_force_n", 1e-9, 0},
    {"/device/full_force_n", 50, 50.1},
    {"/device/tool_tilt_deg", -80, -80.1},
    {"/device/tool_tilt_deg", 80, 80.1},
    {"/device/tool_turn_deg", 0, -0.1},
    {"/device/tool_turn_deg", 60, 60.1},
    {"/target/paths/0/0/2", -1000, -1000.1},
    {"/target/paths/0/0/2", 1000, 1000.1},
    {"/target/width_mm", 1e-9, 0},
    {"/target/width_mm", 100, 100.1},
    {"/target/depth_mm", 1e-9, 0},
    {"/target/depth_mm", 100, 100.1},
    {"/target/top_mm", -1000, -1000.1},
    {"/target/top_mm", 1000, 1000.1},
    {"/target/corner_radius_mm", 0, -1e-9},
    {"/target/corner_radius_mm", 10, 10.1},
    {"/leeway/floor_mm", 0, -1e-9},
    {"/leeway/floor_mm", 10, 10.1},
    {"/leeway/side_mm", 0, -1e-9},
    {"/leeway/side_mm", 10, 10.1},
    {"/limits/time_s", 0, -1},
    {"/limits/time_s", 86400, 86401},
    {"/expected_time_s", 0, -1},
    {"/expected_time_s", 86400, 86401},
    {"/rubric/pass", 0, -1},
    {"/rubric/pass", 100, 100.1},
    {"/rubric/criteria/0/weight", 0, -1},
    {"/rubric/criteria/0/weight", 1000, 1001},
    {"/rubric/criteria/0/bands/fail_lo", -1e6, -1.1e6},
    {"/rubric/criteria/0/bands/fail_hi", 1e6, 1.1e6},
    {"/tolerance/points", 0, -1},
    {"/tolerance/points", 100, 100.1},
};

/// Bounds of the reader: the last value inside reads, the first outside is refused, by the schema too. What may be
/// published is narrower for most numbers: ranges_test.cpp.
TEST(RefusedScenarioFile, BoundsOfTheReaderAreHeldByTheSchemaToo) {
  for (const Bound& bound : kBounds) {
    SCOPED_TRACE(bound.pointer);
    json document = sound();
    document[json::json_pointer(bound.pointer)] = bound.inside;
    EXPECT_TRUE(read_scenario(document.dump())) << bound.inside;
    if (!bound.inside.is_number()) {
      EXPECT_TRUE(check_schema(document.dump()).empty()) << bound.inside;
    }
    document[json::json_pointer(bound.pointer)] = bound.outside;
    EXPECT_EQ(failure_of(document.dump()).code, FormatError::out_of_range) << bound.outside;
    EXPECT_FALSE(check_schema(document.dump()).empty()) << bound.outside;
  }
}

TEST(RefusedScenarioFile, UnknownKeysAreNamedByKind) {
  const struct {
    const char* pointer;
    json value;
    FormatError code;
  } cases[] = {
      {"/tissues/0/tissue", "cheese", FormatError::unknown_tissue},
      {"/tissues/0/tissue", "empty", FormatError::unknown_tissue},
      {"/tissues/0/tissue", "15", FormatError::unknown_tissue},
      {"/tissues/0/tissue", "32", FormatError::unknown_tissue},
      {"/protected", json::array({{{"tissue", "nerve"}}}), FormatError::unknown_tissue},
      {"/target/kind", "star", FormatError::unknown_shape},
      {"/rubric/criteria/0/metric", "beauty", FormatError::unknown_metric},
      {"/rubric/criteria/0/metric", "removed_empty", FormatError::unknown_metric},
      {"/rubric/criteria/0/metric", "removed_", FormatError::unknown_metric},
      {"/rubric/critical", {"boredom"}, FormatError::unknown_critical},
      {"/method", "guess", FormatError::unknown_method},
      {"/specimen/generator", "cube", FormatError::unknown_generator},
      {"/specimen/generator", "", FormatError::unknown_generator},
      {"/target/shape", "star", FormatError::unknown_shape},
      {"/phenomena", {"magic"}, FormatError::unknown_phenomenon},
      {"/level", "expert", FormatError::unknown_level},
      {"/id", "not-a-uuid", FormatError::bad_id},
      {"/title", {{"de", "nur deutsch"}}, FormatError::bad_language},
      {"/title", {{"en", "x"}, {"English", "y"}}, FormatError::bad_language},
      {"/title", {{"en", "x"}, {"pt-BR", "y"}}, FormatError::bad_language},
      {"/specimen", {{"volume", "../secret.nrrd"}}, FormatError::bad_file_name},
      {"/specimen", {{"volume", "a/b.nrrd"}}, FormatError::bad_file_name},
      {"/specimen", {{"volume", "c:x.nrrd"}}, FormatError::bad_file_name},
      {"/specimen", {{"volume", ".hidden"}}, FormatError::bad_file_name},
      {"/specimen", {{"generator", "tooth"}, {"fdi", 19}}, FormatError::out_of_range},
      {"/specimen", {{"generator", "tooth"}, {"fdi", 36}, {"around", {"cheek"}}}, FormatError::unknown_generator},
      {"/specimen", {{"generator", "tooth"}, {"fdi", 36}, {"typodont", 1}}, FormatError::wrong_type},
      {"/specimen", {{"generator", "tooth"}, {"fdi", 36}, {"lesions", {{{"kind", "fissure"}}}}}, FormatError::missing_key},
      {"/specimen", {{"generator", "tooth"}, {"fdi", 36}, {"seed", -1}}, FormatError::out_of_range},
      {"/specimen", {{"generator", "tooth"}, {"fdi", 36}, {"seed", 9007199254740992u}}, FormatError::out_of_range},
  };
  for (const auto& one : cases) {
    EXPECT_EQ(with(one.pointer, one.value).code, one.code) << one.pointer << " " << one.value;
    json document = sound();
    document[json::json_pointer(one.pointer)] = one.value;
    EXPECT_FALSE(check_schema(document.dump()).empty()) << "the schema takes " << one.pointer << " " << one.value;
  }
}

TEST(RefusedScenarioFile, NothingIsNamedTwice) {
  json document = sound();
  document["tissues"].push_back(document["tissues"][0]);
  EXPECT_EQ(failure_of(document.dump()).code, FormatError::duplicate_value);
  EXPECT_EQ(failure_of(document.dump()).where, "/tissues/1");
  document = sound();
  document["instruments"].push_back(document["instruments"][0]);
  EXPECT_EQ(failure_of(document.dump()).where, "/instruments/1");
  document = sound();
  document["rubric"]["criteria"].push_back(document["rubric"]["criteria"][0]);
  EXPECT_EQ(failure_of(document.dump()).where, "/rubric/criteria/2/metric");
}

TEST(RefusedScenarioFile, HugeAndDeepTextsAreRefusedAtOnce) {
  EXPECT_EQ(failure_of(std::string(kMaxScenarioBytes + 1, ' ')).code, FormatError::too_large);
  EXPECT_EQ(failure_of(std::string(100000, '[')).code, FormatError::too_large);
  std::string objects;
  for (int i = 0; i < 1000; ++i) objects += "{\"a\":";
  EXPECT_EQ(failure_of(objects).code, FormatError::too_large);
}

TEST(RefusedScenarioFile, NoTextBreaksTheReader) {
  const unsigned seed = 3;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  const std::string good = write_scenario(ScenarioMaker(5).make());
  int read = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = good;
    for (int change = 1 + static_cast<int>(random() % 3); change > 0; --change) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0:
          text.erase(at, 1 + random() % 40);
          break;
        case 1:
          text[at] = static_cast<char>(random());
          break;
        default:
          text.insert(at, good.substr(random() % good.size(), random() % 40));
      }
      if (text.empty()) text = "{";
    }
    const auto scenario = read_scenario(text);
    read += scenario.has_value();
    if (!scenario) continue;
    const auto again = read_scenario(write_scenario(*scenario));
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, *scenario);
  }
  EXPECT_LT(read, 3000);
}

}  // namespace
}  // namespace cusp::test
