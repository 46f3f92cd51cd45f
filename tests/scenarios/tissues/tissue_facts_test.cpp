// The table of tissues: that it reads, what it holds, and how it refuses.
#include "scenarios/tissues/tissue_facts.h"
#include "tests/modules.h"
#include "tests/source_dir.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace cusp::test {
namespace {

using Json = nlohmann::json;

std::string the_file() {
  std::ifstream in(source_dir() / "scenarios/tissues/tissues.json");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TissueTableError error_of(const Json& document) {
  const auto read = read_tissue_table(document.dump());
  EXPECT_FALSE(read);
  return read ? TissueTableError::bad_json : read.error().code;
}

TEST(TissueFacts, the_file_reads_and_names_every_tissue_of_tissue_h_once) {
  const auto table = read_tissue_table(the_file());
  ASSERT_TRUE(table) << table.error().where;
  const Json document = Json::parse(the_file());
  EXPECT_EQ(document["tissues"].size(), kTissueKeys.size() - 1);  // but for "empty"
  EXPECT_EQ((*table)[index_of(Tissue::enamel)].speed_mm_s.value, tissue_facts(Tissue::enamel).speed_mm_s.value);
}

TEST(TissueFacts, every_figure_has_a_source_and_those_of_general_knowledge_are_marked_unverified) {
  for (std::size_t t = 1; t < kTissueCodes; ++t) {
    const TissueFacts& facts = tissue_facts(static_cast<Tissue>(t));
    for (const auto& figure : {facts.stiffness_n_per_mm, facts.speed_mm_s, facts.tone_hz, facts.loudness}) {
      EXPECT_FALSE(figure.source.empty()) << t;
      EXPECT_EQ(figure.verified, figure.source != "M") << t;
    }
    EXPECT_FALSE(facts.colour.source.empty()) << t;
    EXPECT_FALSE(facts.critical.source.empty()) << t;
  }
}

TEST(TissueFacts, enamel_resists_about_four_times_as_much_as_dentine) {
  // Chun 2014: 274.8 / 65.6 = 4.19.
  const double ratio = tissue_facts(Tissue::dentine).speed_mm_s.value / tissue_facts(Tissue::enamel).speed_mm_s.value;
  EXPECT_NEAR(ratio, 274.8 / 65.6, 0.05);
  EXPECT_EQ(tissue_facts(Tissue::dentine).speed_mm_s.source, "chun-2014");
  EXPECT_EQ(tissue_facts(Tissue::enamel).speed_mm_s.source, "paper");
  EXPECT_FALSE(tissue_facts(Tissue::enamel).stiffness_n_per_mm.verified);
}

TEST(TissueFacts, of_all_tissues_the_pulp_alone_is_critical) {
  for (std::size_t t = 1; t < kTissueCodes; ++t)
    EXPECT_EQ(tissue_facts(static_cast<Tissue>(t)).critical.value, static_cast<Tissue>(t) == Tissue::pulp) << t;
}

TEST(TissueFacts, no_two_named_tissues_look_the_same) {
  for (std::size_t a = 1; a < kTissueKeys.size(); ++a)
    for (std::size_t b = a + 1; b < kTissueKeys.size(); ++b)
      EXPECT_NE(tissue_facts(static_cast<Tissue>(a)).colour.value, tissue_facts(static_cast<Tissue>(b)).colour.value);
}

TEST(TissueFacts, a_scenarios_own_tissues_take_turns_among_the_shades) {
  EXPECT_EQ(tissue_facts(static_cast<Tissue>(16)).colour.value, tissue_facts(static_cast<Tissue>(20)).colour.value);
  EXPECT_NE(tissue_facts(static_cast<Tissue>(16)).colour.value, tissue_facts(static_cast<Tissue>(17)).colour.value);
  EXPECT_GT(tissue_facts(static_cast<Tissue>(16)).stiffness_n_per_mm.value, 0.0);
}

TEST(TissueFacts, a_neighbours_tissues_feel_as_the_tooths_own_and_a_firm_lesion_lies_between_soft_and_sound) {
  const TissueFacts &enamel = tissue_facts(Tissue::enamel), &beside = tissue_facts(static_cast<Tissue>(29));
  EXPECT_EQ(beside.stiffness_n_per_mm.value, enamel.stiffness_n_per_mm.value);
  EXPECT_EQ(beside.speed_mm_s.value, enamel.speed_mm_s.value);
  EXPECT_NE(beside.colour.value, enamel.colour.value);
  EXPECT_EQ(tissue_facts(static_cast<Tissue>(30)).speed_mm_s.value, tissue_facts(Tissue::dentine).speed_mm_s.value);
  const TissueFacts &firm = tissue_facts(static_cast<Tissue>(31)), &soft = tissue_facts(Tissue::carious_dentine);
  EXPECT_GT(firm.stiffness_n_per_mm.value, soft.stiffness_n_per_mm.value);
  EXPECT_LT(firm.stiffness_n_per_mm.value, tissue_facts(Tissue::dentine).stiffness_n_per_mm.value);
  EXPECT_LT(firm.speed_mm_s.value, soft.speed_mm_s.value);
}

TEST(TissueFacts, what_is_no_json_or_no_object_is_refused) {
  for (const char* text : {"", "{", "[]", "7", "null", "{\"sources\": 1}"}) EXPECT_FALSE(read_tissue_table(text)) << text;
  EXPECT_EQ(read_tissue_table("{").error().code, TissueTableError::bad_json);
}

TEST(TissueFacts, a_figure_without_a_source_or_with_an_unknown_one_is_refused_at_its_place) {
  Json document = Json::parse(the_file());
  document["tissues"][0]["speed_mm_s"].erase("source");
  EXPECT_EQ(error_of(document), TissueTableError::unknown_source);
  document["tissues"][0]["speed_mm_s"]["source"] = "somebody";
  const auto read = read_tissue_table(document.dump());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().where, "/tissues/0/speed_mm_s/source");
}

TEST(TissueFacts, values_of_another_kind_or_out_of_range_are_refused) {
  const Json good = Json::parse(the_file());
  const std::pair<const char*, Json> bad[] = {
      {"stiffness_n_per_mm", 0},     {"stiffness_n_per_mm", 20.5}, {"stiffness_n_per_mm", "3"}, {"speed_mm_s", -1},
      {"speed_mm_s", 101},           {"tone_hz", 0},               {"loudness", 1.5},           {"loudness", nullptr},
      {"colour", "F1EBDD"},          {"colour", "#f1ebdd"},        {"colour", "#F1EBD"},        {"colour", 7},
      {"critical", 1},
  };
  for (const auto& [key, value] : bad) {
    Json document = good;
    document["tissues"][3][key]["value"] = value;
    EXPECT_EQ(error_of(document), TissueTableError::bad_value) << key << ' ' << value;
  }
}

TEST(TissueFacts, a_tissue_twice_unknown_or_left_out_is_refused) {
  const Json good = Json::parse(the_file());
  Json twice = good, unknown = good, less = good;
  twice["tissues"].push_back(twice["tissues"][0]);
  unknown["tissues"][0]["tissue"] = "marble";
  less["tissues"].erase(2);
  EXPECT_EQ(error_of(twice), TissueTableError::unknown_tissue);
  EXPECT_EQ(error_of(unknown), TissueTableError::unknown_tissue);
  EXPECT_EQ(error_of(less), TissueTableError::missing);
  Json lacking = good;
  lacking["tissues"][1].erase("loudness");
  EXPECT_EQ(error_of(lacking), TissueTableError::missing);
  lacking = good;
  lacking.erase("own");
  EXPECT_EQ(error_of(lacking), TissueTableError::missing);
}

}  // namespace
}  // namespace cusp::test
