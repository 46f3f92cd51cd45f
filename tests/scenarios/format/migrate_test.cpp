// Files of format 1 as they were written (format1/), read by this program.
#include "scenarios/format/migrate.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/validate.h"
#include "tests/modules.h"
#include "tests/scenarios/format/changed_scenario.h"
#include "tests/source_dir.h"

namespace cusp::test {
namespace {

std::string file_of_format_1(const std::string& name) {
  std::ifstream file(source_dir() / "tests/scenarios/format/format1" / (name + ".json"), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

json changed(const char* pointer, const json& value) {
  json document = json::parse(file_of_format_1("box"));
  document[json::json_pointer(pointer)] = value;
  return document;
}

TEST(Format1, EveryFileReadsWithoutAFindingOfItsFormat) {
  for (const char* name : {"channel-1", "class-1-36", "box", "outline"}) {
    SCOPED_TRACE(name);
    const auto scenario = read_scenario(file_of_format_1(name));
    ASSERT_TRUE(scenario) << scenario.error().where;
    EXPECT_EQ(scenario->format, kScenarioFormat);
    for (const Finding& f : validate_text(file_of_format_1(name))) EXPECT_NE(f.code, "schema") << f.path << ' ' << f.detail;
  }
}

TEST(Format1, TheMetricUndercutIsTheUncutRemainder) {
  const auto scenario = read_scenario(file_of_format_1("class-1-36"));
  ASSERT_TRUE(scenario);
  EXPECT_EQ(scenario->rubric.criteria[2].metric, "uncut_remainder");
  EXPECT_EQ(with("/rubric/criteria/0/metric", "undercut").code, FormatError::unknown_metric) << "format 2 has no such key";
}

TEST(Format1, ProtectedTissuesAreKept) {
  EXPECT_EQ(read_scenario(file_of_format_1("box"))->protected_parts, std::vector<Protected>{Tissue::pulp});
}

TEST(Format1, AnExerciseKeepsItsContentHashWhenItIsWrittenInFormat2) {
  // The rule of format 1: of the file's own canonical form. library_test.cpp holds the hashes of every exercise that was
  // published in format 1.
  const auto scenario = read_scenario(file_of_format_1("channel-1"));
  ASSERT_TRUE(scenario);
  const auto again = read_scenario(write_scenario(*scenario));
  ASSERT_TRUE(again);
  EXPECT_EQ(content_hash(*again), content_hash(*scenario));
  const std::string old = *canonical_json(file_of_format_1("channel-1"));
  const std::string line = hash_of_bytes(std::as_bytes(std::span(old))).hex() + "  scenario.json\n";
  EXPECT_EQ(content_hash(*scenario), hash_of_bytes(std::as_bytes(std::span(line))));
}

TEST(Format1, IsGivenBackFromEveryDocumentThatItCanSay) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const json document = json::parse(write_scenario(ScenarioMaker(seed).make()));
    auto old = in_format_1(document);
    if (!old) continue;
    EXPECT_EQ((*old)["format"], 1);
    ASSERT_TRUE(migrate(*old)) << seed;
    EXPECT_EQ(*old, document) << seed;
  }
}

TEST(Format1, KnowsNoWordOfFormat2) {
  const std::pair<const char*, json> words[] = {
      {"/target/kind", "outline"}, {"/leeway/faces", json::object()}, {"/rubric/criteria/0/needs_dof", 5},
      {"/level", "beginner"}, {"/expected_time_s", 600}, {"/self_assessment", true}, {"/template", json::object()}, {"/specimen/landmarks", json::object()}};
  for (const auto& [pointer, value] : words) {
    const FormatFailure failure = failure_of(changed(pointer, value).dump());
    EXPECT_EQ(failure.code, FormatError::unknown_key) << pointer;
    EXPECT_EQ(failure.where, pointer);
  }
  EXPECT_EQ(failure_of(changed("/rubric/criteria/0/metric", "uncut_remainder").dump()).code, FormatError::unknown_metric);
  EXPECT_EQ(failure_of(changed("/protected/0", {{"tissue", "pulp"}}).dump()).code, FormatError::wrong_type);
}

TEST(Format1, ValuesOfOtherTypesAreRefusedWhereTheyStand) {
  for (const char* pointer : {"/target", "/leeway", "/protected", "/rubric", "/rubric/criteria", "/rubric/criteria/0"})
    for (const json& value : {json(), json(7), json("x"), json::array({7}), json{{"a", 1}}}) {
      const FormatFailure failure = failure_of(changed(pointer, value).dump());
      EXPECT_TRUE(failure.where.starts_with(pointer)) << pointer << " " << value << ": " << failure.where;
    }
}

TEST(Format1, ARubricAloneTakesTheOldNameOfItsMetric) {
  json rubric = json::parse(file_of_format_1("box"))["rubric"];
  migrate_rubric(rubric);
  EXPECT_EQ(rubric["criteria"][2]["metric"], "uncut_remainder");
  json odd = json::array({7});
  migrate_rubric(odd);
  EXPECT_EQ(odd, json::array({7}));
}

}  // namespace
}  // namespace cusp::test
