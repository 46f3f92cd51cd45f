// Landmarks of a tooth from a file in scenario.json.
#include "scenarios/format/landmark.h"

#include <gtest/gtest.h>

#include "scenarios/format/schema.h"
#include "scenarios/format/validate.h"
#include "tests/modules.h"
#include "tests/scenarios/format/changed_scenario.h"

namespace cusp::test {
namespace {

json marked() { return json::parse(write_scenario(marked_scenario())); }

FormatFailure marked_with(const char* pointer, const json& value) {
  json document = marked();
  document[json::json_pointer(pointer)] = value;
  return failure_of(document.dump());
}

TEST(LandmarkFormat, EachKindComesBackAsItWasWritten) {
  const Scenario scenario = marked_scenario();
  const auto again = read_scenario(write_scenario(scenario));
  ASSERT_TRUE(again) << again.error().where;
  EXPECT_EQ(again->specimen.landmarks, scenario.specimen.landmarks);
  EXPECT_TRUE(check_schema(write_scenario(scenario)).empty());
  EXPECT_TRUE(validate(scenario).empty());
}

TEST(LandmarkFormat, RefusesWhatIsNoLandmark) {
  const struct {
    const char* pointer;
    json value;
    FormatError code;
  } cases[] = {
      {"/specimen/landmarks", json::array(), FormatError::wrong_type},
      {"/specimen/landmarks", json::object(), FormatError::missing_key},
      {"/specimen/landmarks/fdi", 19, FormatError::out_of_range},
      {"/specimen/landmarks/teeth", 1, FormatError::unknown_key},
      {"/specimen/landmarks/marks/0/kind", "horn", FormatError::unknown_landmark},
      {"/specimen/landmarks/marks/0/state", "guessed", FormatError::unknown_landmark},
      {"/specimen/landmarks/marks/0/name", "", FormatError::out_of_range},
      {"/specimen/landmarks/marks/0/points_mm", json::array(), FormatError::out_of_range},
      {"/specimen/landmarks/marks/0/points_mm/0/2", 1e6, FormatError::out_of_range},
      {"/specimen/landmarks/marks/0/points_mm/0", {1, 2}, FormatError::wrong_type},
      {"/specimen/landmarks/marks/0/sure", true, FormatError::unknown_key},
      {"/specimen", {{"generator", "tooth"}, {"fdi", 36}, {"landmarks", {{"marks", json::array()}}}}, FormatError::unknown_key},
  };
  for (const auto& one : cases) {
    EXPECT_EQ(marked_with(one.pointer, one.value).code, one.code) << one.pointer << " " << one.value;
    json document = marked();
    document[json::json_pointer(one.pointer)] = one.value;
    EXPECT_FALSE(check_schema(document.dump()).empty()) << "the schema takes " << one.pointer << " " << one.value;
  }
}

TEST(LandmarkFormat, RefusesAKindWithTheWrongNumberOfPoints) {
  const json p = {0, 0, 0};
  EXPECT_EQ(marked_with("/specimen/landmarks/marks/0/points_mm", json::array({p, p, p})).code, FormatError::out_of_range) << "an axis of three";
  EXPECT_EQ(marked_with("/specimen/landmarks/marks/2/points_mm", json::array({p, p})).code, FormatError::out_of_range) << "two tips of one cusp";
  EXPECT_EQ(marked_with("/specimen/landmarks/marks/8/points_mm", json::array({p, p, p})).code, FormatError::out_of_range) << "a CEJ of a line";
  EXPECT_EQ(marked_with("/specimen/landmarks/marks/8/points_mm", json::array({p, p, p, {1, 0, 0}})).code, FormatError::out_of_range) << "an open CEJ";
}

TEST(LandmarkFormat, RefusesOneThatIsNamedTwiceAndALongList) {
  json document = marked();
  json& marks = document["specimen"]["landmarks"]["marks"];
  marks.push_back(marks[3]);
  EXPECT_EQ(failure_of(document.dump()).code, FormatError::duplicate_value);
  EXPECT_EQ(failure_of(document.dump()).where, "/specimen/landmarks/marks/9");
  for (std::size_t i = marks.size(); i <= kMostMarks; ++i) {
    marks.push_back(marks[3]);
    marks.back()["name"] = std::to_string(i);
  }
  EXPECT_EQ(failure_of(document.dump()).code, FormatError::out_of_range);
}

SpecimenLandmarks with_mesial(int fdi, Vec3 way) {
  SpecimenLandmarks out;
  out.fdi = fdi;
  out.marks.push_back({MarkKind::mesial_axis, {}, {Vec3(1, 2, 3), Vec3(1, 2, 3) + way}, MarkState::set});
  return out;
}

TEST(LandmarkFormat, KnowsHowFarAToothIsTurned) {
  EXPECT_NEAR(*turn_deg(with_mesial(36, {2, 0, 0})), 0.0, 1e-12) << "mesial along x in quadrants 1 and 3";
  EXPECT_NEAR(*turn_deg(with_mesial(46, {-2, 0, 0})), 0.0, 1e-12) << "along -x in 2 and 4";
  EXPECT_NEAR(*turn_deg(with_mesial(36, {0, 1, 0})), 90.0, 1e-12);
  EXPECT_NEAR(*turn_deg(with_mesial(46, {0, 1, 0})), -90.0, 1e-12);
  EXPECT_NEAR(std::fabs(*turn_deg(with_mesial(11, {-1, 0, 0}))), 180.0, 1e-12);
  for (const int none : {0, 6, 51}) EXPECT_FALSE(turn_deg(with_mesial(none, {1, 0, 0}))) << none;
  EXPECT_FALSE(turn_deg(with_mesial(36, {0, 0, 0})));
  EXPECT_FALSE(turn_deg(with_mesial(36, {0, 0, 1})));
  EXPECT_FALSE(turn_deg({.fdi = 36, .marks = {}}));
}

TEST(LandmarkFormat, ValidateFindsATurnedToothAndALandmarkBesideIt) {
  Scenario s = marked_scenario();
  const SpecimenFacts facts{Vec3(-10, -10, -10), Vec3(10, 10, 10), 0.1, {Tissue::plastic}};
  EXPECT_TRUE(validate(s, &facts).empty());
  s.specimen.landmarks.marks[1].points_mm = {Vec3(0), Vec3(1, 1, 0)};
  auto found = validate(s, &facts);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "tooth_turned");
  EXPECT_NEAR(found[0].args.at("value"), 45.0, 1e-9);
  s = marked_scenario();
  s.specimen.landmarks.marks[3].points_mm[0].x = 11.5;
  found = validate(s, &facts);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "landmark_outside");
  EXPECT_EQ(found[0].path, "/specimen/landmarks/marks/3");
  EXPECT_TRUE(validate(s).empty()) << "without a specimen nobody knows";
}

/// The marked scenario, its channel's wall at high x called mesial.
Scenario with_mesial_wall(int fdi, Vec3 way) {
  Scenario s = marked_scenario();
  s.target.faces["x_high"] = FaceName::mesial_wall;
  s.specimen.landmarks = with_mesial(fdi, way);
  return s;
}

std::vector<std::string> codes_of(const Scenario& s) {
  std::vector<std::string> out;
  for (const Finding& f : validate(s)) out.push_back(f.code);
  return out;
}

TEST(LandmarkFormat, ValidateFindsAMesialWallOnTheDistalSide) {
  using Codes = std::vector<std::string>;
  EXPECT_EQ(codes_of(with_mesial_wall(36, {1, 0, 0})), Codes{});
  EXPECT_EQ(codes_of(with_mesial_wall(46, {-1, 0, 0})), Codes{"wall_of_other_side"});
  EXPECT_EQ(validate(with_mesial_wall(46, {-1, 0, 0})).front().path, "/target/faces/x_high");
  EXPECT_EQ(codes_of(with_mesial_wall(36, {0, 1, 0})), Codes{"tooth_turned"}) << "nobody knows its side";
  EXPECT_EQ(codes_of(with_mesial_wall(0, {1, 0, 0})), Codes{"sides_unknown"});
  EXPECT_EQ(codes_of(marked_scenario()), Codes{}) << "no wall has a side";
  Scenario grown = with_mesial_wall(0, {1, 0, 0});
  grown.specimen = {};
  grown.specimen.generator = "tooth";
  grown.specimen.fdi = 46;
  EXPECT_EQ(codes_of(grown), Codes{"wall_of_other_side"});
  grown.specimen.fdi = 36;
  EXPECT_EQ(codes_of(grown), Codes{});
}

TEST(LandmarkFormat, ValidateComparesTheSidesOfABoxByItsOwnAxisAndOfADifferenceByItsFirstPart) {
  Scenario s = with_mesial_wall(36, {1, 0, 0});
  Region box;
  box.kind = RegionKind::box;
  box.from_mm = {0, 0, -1};
  box.size_mm = {4, 2, 2};
  box.x_axis = {-1, 0, 0};
  box.faces["x_low"] = FaceName::mesial_wall;
  s.target = box;
  EXPECT_EQ(codes_of(s), std::vector<std::string>{});
  s.target.x_axis = {1, 0, 0};
  EXPECT_EQ(codes_of(s), std::vector<std::string>{"wall_of_other_side"});
  s.target.x_axis = {0, 1, 0};
  EXPECT_EQ(codes_of(s), std::vector<std::string>{}) << "it faces neither side";
  Region difference;
  difference.kind = RegionKind::difference;
  difference.parts = {with_mesial_wall(36, {1, 0, 0}).target, box};
  difference.parts[1].x_axis = {1, 0, 0};
  s.target = difference;
  EXPECT_EQ(codes_of(s), std::vector<std::string>{}) << "what is taken away bounds the cavity from the other side";
}

}  // namespace
}  // namespace cusp::test
