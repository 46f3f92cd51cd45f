// Regions in scenario.json: what is read and written, what is refused and where, what is found wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/migrate.h"
#include "scenarios/format/schema.h"
#include "scenarios/format/validate.h"
#include "tests/modules.h"
#include "tests/scenarios/format/changed_scenario.h"

namespace cusp::test {
namespace {

using testing::Contains;

Scenario composed() {
  Scenario s = sound_scenario();
  s.target = region_with_every_kind();
  s.leeway.faces = {{FaceName::gingival_floor, 0.1}};
  s.protected_parts = {Tissue::plastic, Protected(s.target.parts[1], Damage::depth)};
  s.protected_parts[1].depth_mm = 0.5;
  s.rubric.criteria[0].needs_dof = 5;
  return s;
}
json document() { return json::parse(write_scenario(composed())); }

FormatFailure refused(const std::string& pointer, const json& value) {
  json out = document();
  out[json::json_pointer(pointer)] = value;
  EXPECT_FALSE(check_schema(out.dump()).empty()) << "the schema takes " << pointer << ' ' << value;
  return failure_of(out.dump());
}

TEST(RegionFormat, EveryKindReadsBackAsItIsWritten) {
  const Scenario s = composed();
  const auto back = read_scenario(write_scenario(s));
  ASSERT_TRUE(back) << back.error().where;
  EXPECT_EQ(*back, s);
  for (const Finding& f : check_schema(write_scenario(s))) ADD_FAILURE() << f.path << ' ' << f.detail;
}

TEST(RegionFormat, ATreeIsHashedInFormat2AndEachOfItsValuesCounts) {
  EXPECT_FALSE(in_format_1(document()));
  const Scenario s = composed();
  std::set<ContentHash> seen{content_hash(s)};
  const auto differs = [&](auto change) {
    Scenario other = s;
    change(other);
    EXPECT_TRUE(seen.insert(content_hash(other)).second);
  };
  differs([](Scenario& o) { o.target.rounding_mm = 0.3; });
  differs([](Scenario& o) { o.target.parts[0].outline.taper_deg[2] = 0; });
  differs([](Scenario& o) { o.target.parts[1].faces["z_high"] = FaceName::axial_wall; });
  differs([](Scenario& o) { o.target.parts[8].tissue = Tissue::pulp; });
  differs([](Scenario& o) { o.target.parts[9].down_to = Hardness::firm; });
  differs([](Scenario& o) { o.leeway.faces[FaceName::gingival_floor] = 0.2; });
  differs([](Scenario& o) { o.protected_parts[0].severity = Damage::touch; });
  differs([](Scenario& o) { o.rubric.criteria[0].needs_dof = 6; });
}

TEST(RegionFormat, AFaceThatIsNamedAsItWouldBeAnywayChangesNothing) {
  json named = document();
  named["target"]["parts"][1]["faces"] = {{"z_low", "pulpal_floor"}};
  EXPECT_EQ(*read_scenario(named.dump()), composed());
}

TEST(RegionFormat, WhatIsWrongIsRefusedWhereItStands) {
  const struct {
    const char* pointer;
    json value;
    FormatError code;
    const char* where;
  } cases[] = {
      {"/target/kind", "torus", FormatError::unknown_shape, "/target/kind"},
      {"/target/kind", 3, FormatError::wrong_type, "/target/kind"},
      {"/target/parts", json::array(), FormatError::out_of_range, "/target/parts"},
      {"/target/parts/13/parts", json::array({document()["target"]["parts"][4], document()["target"]["parts"][4]}), FormatError::out_of_range, "/target/parts/13/parts"},
      {"/target/parts/4/size_mm", {1, 1, 1}, FormatError::unknown_key, "/target/parts/4/size_mm"},
      {"/target/parts/4/radius_mm", -1, FormatError::out_of_range, "/target/parts/4/radius_mm"},
      {"/target/parts/4/radius_mm", 1e300, FormatError::out_of_range, "/target/parts/4/radius_mm"},
      {"/target/parts/4/from_mm", {1, 2}, FormatError::wrong_type, "/target/parts/4/from_mm"},
      {"/target/parts/1/faces", {{"roof", "axial_wall"}}, FormatError::unknown_key, "/target/parts/1/faces/roof"},
      {"/target/parts/1/faces", {{"z_low", "bottom"}}, FormatError::unknown_face, "/target/parts/1/faces/z_low"},
      {"/target/parts/0/taper_deg", {{"x_low", 50}}, FormatError::out_of_range, "/target/parts/0/taper_deg/x_low"},
      {"/target/faces", json::object(), FormatError::unknown_key, "/target/faces"},
      {"/target/parts/8/tissue", "gold", FormatError::unknown_tissue, "/target/parts/8/tissue"},
      {"/target/parts/8/tissue", "empty", FormatError::unknown_tissue, "/target/parts/8/tissue"},
      {"/target/parts/8/tissue", 5, FormatError::wrong_type, "/target/parts/8/tissue"},
      {"/target/parts/8/from_mm", {0, 0, 0}, FormatError::unknown_key, "/target/parts/8/from_mm"},
      {"/target/parts/9/down_to", "leathery", FormatError::unknown_hardness, "/target/parts/9/down_to"},
      {"/target/parts/9/down_to", 1, FormatError::wrong_type, "/target/parts/9/down_to"},
      {"/target/parts/9/tissue", "pulp", FormatError::unknown_key, "/target/parts/9/tissue"},
      {"/target/parts/9/faces", {{"floor", "axial_wall"}}, FormatError::unknown_key, "/target/parts/9/faces/floor"},
      {"/leeway/faces", {{"floor", 0.1}}, FormatError::unknown_key, "/leeway/faces/floor"},
      {"/protected/0/severity", "scratch", FormatError::unknown_severity, "/protected/0/severity"},
      {"/rubric/criteria/0/needs_dof", 7, FormatError::out_of_range, "/rubric/criteria/0/needs_dof"},
      {"/rubric/criteria/0/needs_dof", 4.5, FormatError::wrong_type, "/rubric/criteria/0/needs_dof"},
  };
  for (const auto& one : cases) {
    const FormatFailure failure = refused(one.pointer, one.value);
    EXPECT_EQ(failure.code, one.code) << one.pointer << ' ' << one.value;
    EXPECT_EQ(failure.where, one.where) << one.value;
  }
}

Scenario with_two_targets() {
  Scenario s = composed();
  s.target.parts[4].name = "mesial_pit";
  s.target.parts[4].title = {{"en", "Mesial pit"}, {"de", "Mesiale Grube"}};
  s.target.parts[6].name = "b2";
  s.rubric.criteria.push_back({"depth_mean@mesial_pit", 5, {0, 1, 2, 3, 4, 5}});
  return s;
}

TEST(RegionFormat, SeveralTargetsReadBackAndTheirNamesAndTitlesCount) {
  const Scenario s = with_two_targets();
  const auto back = read_scenario(write_scenario(s));
  ASSERT_TRUE(back) << back.error().where;
  EXPECT_EQ(*back, s);
  for (const Finding& f : check_schema(write_scenario(s))) ADD_FAILURE() << f.path << ' ' << f.detail;
  ASSERT_EQ(named_targets(back->target).size(), 2u);
  EXPECT_EQ(named_targets(back->target)[1]->name, "b2");
  Scenario other = s;
  other.target.parts[6].name = "b3";
  EXPECT_NE(content_hash(other), content_hash(s));
  other = s;
  other.target.parts[4].title["de"] = "Grube";
  EXPECT_NE(content_hash(other), content_hash(s));
  other = s;
  for (Region& part : other.target.parts) part.name.clear(), part.title.clear();
  other.rubric = composed().rubric;
  EXPECT_EQ(content_hash(other), content_hash(composed())) << "an exercise without names keeps its hash";
}

TEST(RegionFormat, ANameStandsOnADirectPartOfTheTargetsUnionAlone) {
  const auto failure = [](const std::string& pointer, const json& value) {
    json out = json::parse(write_scenario(with_two_targets()));
    out[json::json_pointer(pointer)] = value;
    return failure_of(out.dump());
  };
  const struct {
    const char* pointer;
    json value;
    FormatError code;
  } cases[] = {{"/target/parts/6/name", "Pit", FormatError::bad_target_name},      {"/target/parts/6/name", "2b", FormatError::bad_target_name},
               {"/target/parts/6/name", "a@b", FormatError::bad_target_name},      {"/target/parts/6/name", 7, FormatError::wrong_type},
               {"/target/parts/6/name", "mesial_pit", FormatError::duplicate_value}, {"/target/name", "whole", FormatError::unknown_key},
               {"/target/parts/13/parts/0/name", "deep", FormatError::unknown_key}, {"/target/parts/5/title", {{"en", "T"}}, FormatError::unknown_key},
               {"/target/parts/4/title", {{"de", "T"}}, FormatError::bad_language}, {"/protected/1/region/name", "spared", FormatError::unknown_key}};
  for (const auto& one : cases) EXPECT_EQ(failure(one.pointer, one.value).code, one.code) << one.pointer << ' ' << one.value;
  const std::string last = "/rubric/criteria/" + std::to_string(with_two_targets().rubric.criteria.size() - 1) + "/metric";
  for (const char* key : {"depth_mean@", "depth_mean@Pit", "time@b2", "caries_left_pulp@b2", "depth@b2", "depth_mean@b2@b2", "removed_gold@b2"}) {
    EXPECT_EQ(failure(last, key).code, FormatError::unknown_metric) << key;
    json out = json::parse(write_scenario(with_two_targets()));
    out[json::json_pointer(last)] = key;
    EXPECT_FALSE(check_schema(out.dump()).empty()) << "the schema takes " << key;
  }
  for (const char* key : {"depth_most@b2", "removed_plastic@b2", "target_removed@mesial_pit"}) {
    json out = json::parse(write_scenario(with_two_targets()));
    out[json::json_pointer(last)] = key;
    EXPECT_TRUE(read_scenario(out.dump())) << key;
    EXPECT_TRUE(check_schema(out.dump()).empty()) << key;
  }
}

TEST(RegionFormat, ACriterionOfATargetThatIsNotThereIsFound) {
  Scenario s = with_two_targets();
  const auto found = [&](std::string_view code) {
    return std::ranges::any_of(validate(s, nullptr), [code](const Finding& f) { return f.code == code; });
  };
  EXPECT_FALSE(found("target_missing"));
  s.rubric.criteria.back().metric = "depth_mean@distal_pit";
  EXPECT_TRUE(found("target_missing"));
  s = with_two_targets();
  s.title["de"] = "Titel";
  s.briefing["de"] = "Text";
  EXPECT_FALSE(found("language_missing"));
  s.target.parts[4].title.erase("de");
  EXPECT_TRUE(found("language_missing"));
}

TEST(RegionFormat, EveryKeyOfAKindIsNeeded) {
  const json parts = document()["target"]["parts"];
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (const auto& [key, value] : parts[i].items()) {
      if (key == "taper_deg" || key == "box_size_mm") continue;
      json out = document();
      out["target"]["parts"][i].erase(key);
      const FormatFailure failure = failure_of(out.dump());
      EXPECT_EQ(failure.code, FormatError::missing_key) << i << ' ' << key;
      EXPECT_FALSE(check_schema(out.dump()).empty()) << "the schema takes part " << i << " without " << key;
    }
}

TEST(RegionFormat, TheDepthOfADamageNeedsARegion) {
  json out = document();
  out["protected"][0]["severity"] = "depth";
  out["protected"][0]["depth_mm"] = 1;
  EXPECT_EQ(failure_of(out.dump()).where, "/protected/0/region");
}

TEST(RegionFormat, NumbersThatAreNoneAreRefused) {
  std::string text = write_scenario(composed());
  const std::string from = "\"end_radius_mm\": 1";
  for (const char* number : {"NaN", "1e999", "-Infinity"}) {
    std::string out = text;
    out.replace(out.find(from), from.size(), std::string("\"end_radius_mm\": ") + number);
    EXPECT_EQ(failure_of(out).code, FormatError::not_finite) << number;
  }
}

TEST(RegionFormat, ATreeThatIsTooDeepOrTooWideIsRefused) {
  const json ball = document()["target"]["parts"][4];
  json out = document();
  out["target"] = "here";
  // As text: dump() of so deep a tree takes more stack than a sanitizer has.
  std::string text = out.dump(), deep = ball.dump();
  for (int i = 0; i < 2000; ++i) deep = R"({"kind":"offset","by_mm":0.1,"parts":[)" + deep + "]}";
  const std::string here = R"("here")";
  text.replace(text.find(here), here.size(), deep);
  EXPECT_EQ(failure_of(text).code, FormatError::too_large);
  json wide{{"kind", "union"}, {"parts", json::array()}};
  for (int i = 0; i < 32; ++i) wide["parts"].push_back(ball);
  json wider{{"kind", "union"}, {"parts", {wide, wide}}};
  out["target"] = wide;
  EXPECT_TRUE(read_scenario(out.dump())) << "33 parts";
  out["target"] = wider;
  EXPECT_EQ(failure_of(out.dump()).code, FormatError::out_of_range) << "67 parts";
}

std::vector<std::string> codes(const Region& target) {
  Scenario s = sound_scenario();
  s.target = target;
  std::vector<std::string> out;
  for (const Finding& f : validate(s)) out.push_back(f.path + ' ' + f.code);
  return out;
}

TEST(RegionFormat, ShapesWithoutDirectionSizeOrEndAreFound) {
  const Region all = region_with_every_kind();
  Region box = all.parts[1];
  EXPECT_THAT(codes(box), testing::IsEmpty());
  box.z_axis = Vec3(0.0);
  EXPECT_THAT(codes(box), Contains("/target/z_axis no_direction"));
  box.z_axis = {2, 0, 0};
  EXPECT_THAT(codes(box), Contains("/target/x_axis no_direction"));
  EXPECT_THAT(codes(all.parts[7]), Contains("/target target_endless"));
  Region cylinder = all.parts[2];
  cylinder.to_mm = cylinder.from_mm;
  EXPECT_THAT(codes(cylinder), Contains("/target/to_mm empty_target"));
  Region common;
  common.kind = RegionKind::common;
  common.parts = {all.parts[7], all.parts[4]};
  EXPECT_THAT(codes(common), testing::Not(Contains("/target target_endless"))) << "the ball ends it";
  Region outline = all;
  outline.parts[0].outline.paths.clear();
  EXPECT_THAT(codes(outline), Contains("/target/parts/0/paths no_target"));
}

TEST(RegionFormat, ALeafOfVoxelsNeedsItsTissueOrLesion) {
  const Region all = region_with_every_kind();
  EXPECT_THAT(codes(all.parts[8]), testing::IsEmpty()) << "the exercise's own plastic";
  Region pulp = all.parts[8];
  pulp.tissue = Tissue::pulp;
  EXPECT_THAT(codes(pulp), Contains("/target/tissue target_tissue_missing"));
  EXPECT_THAT(codes(all.parts[9]), Contains("/target lesion_missing"));
  Scenario tooth = sound_scenario();
  tooth.target = all.parts[9];
  tooth.specimen.generator = "tooth";
  tooth.specimen.fdi = 36;
  const auto lesion_missing = [&] {
    const auto found = validate(tooth);
    return std::ranges::find(found, "lesion_missing", &Finding::code) != found.end();
  };
  EXPECT_TRUE(lesion_missing());
  tooth.specimen.lesions = {{}};
  EXPECT_FALSE(lesion_missing());
  tooth.specimen.typodont = true;
  EXPECT_TRUE(lesion_missing()) << "none is grown in plastic";
  Scenario s = sound_scenario();
  s.target = all.parts[8];
  SpecimenFacts facts;
  facts.voxel_mm = s.specimen.voxel_mm;
  facts.tissues = {Tissue::enamel};
  const auto found = validate(s, &facts);
  EXPECT_NE(std::ranges::find(found, "target_tissue_missing", &Finding::code), found.end()) << "the specimen has none of it";
}

TEST(RegionFormat, DamageCannotFailAnAttemptThatProtectsNothing) {
  Scenario s = sound_scenario();
  s.rubric.critical = {"protected_damage"};
  std::vector<std::string> found;
  for (const Finding& f : validate(s)) found.push_back(f.code);
  EXPECT_THAT(found, Contains("nothing_protected"));
}

}  // namespace
}  // namespace cusp::test
