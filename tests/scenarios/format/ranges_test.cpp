#include "scenarios/format/ranges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "scenarios/burs/bur_catalogue.h"
#include "scenarios/format/schema.h"
#include "scenarios/format/validate.h"
#include "scenarios/format/write.h"
#include "scenarios/tissues/tissue_facts.h"
#include "tests/modules.h"
#include "tests/scenarios/format/changed_scenario.h"

namespace cusp::test {
namespace {

using nlohmann::json;

struct SchemaNumber {
  double least = -1e300, most = 1e300;
  bool or_zero = false;
};

/// Every number of the schema by its path, "*" for the items of a list.
class SchemaWalk {
 public:
  SchemaWalk() : schema_(json::parse(scenario_schema())) { walk(schema_, ""); }
  std::map<std::string, SchemaNumber> found;

 private:
  void walk(const json& node, const std::string& path) {
    if (node.contains("$ref")) {
      const std::string ref = node["$ref"].get<std::string>();
      if (ref.ends_with("/region") && path != "/target") return;  // the same rows hold at every depth of a tree
      walk(schema_.at(json::json_pointer(ref.substr(1))), path);
    }
    if (node.contains("oneOf")) {
      for (const json& one : node["oneOf"]) walk(one, path);
    }
    if (node.contains("properties")) {
      for (const auto& [key, value] : node["properties"].items()) walk(value, path + "/" + key);
    }
    if (node.contains("items")) walk(node["items"], path + "/*");
    take(node, path);
  }
  void take(const json& node, const std::string& path) {
    SchemaNumber number;
    if (node.contains("enum") && node["enum"].front().is_number()) {
      number.least = node["enum"].front().get<double>();
      number.most = node["enum"].back().get<double>();
    } else if (node.contains("type") && (node["type"] == "number" || node["type"] == "integer")) {
      EXPECT_TRUE(node.contains("minimum") && node.contains("maximum")) << path << " has an open end";
      EXPECT_FALSE(node.contains("exclusiveMinimum") || node.contains("exclusiveMaximum")) << path;
      number.least = node.value("minimum", number.least);
      number.most = node.value("maximum", number.most);
      if (node.contains("anyOf")) {
        EXPECT_EQ(node["anyOf"][0], json({{"maximum", 0}})) << path;
        number.or_zero = true;
        number.least = node["anyOf"][1]["minimum"].get<double>();
      }
    } else {
      return;
    }
    const auto [at, fresh] = found.try_emplace(path, number);
    EXPECT_TRUE(fresh || (at->second.least == number.least && at->second.most == number.most)) << path << " stands twice";
  }

  json schema_;
};

TEST(Ranges, AreTheSchemasBothWays) {
  const SchemaWalk schema;
  std::set<std::string> rows;
  for (const NumberRange& row : number_ranges()) {
    SCOPED_TRACE(row.path);
    EXPECT_TRUE(rows.insert(std::string(row.path)).second) << "stands twice";
    EXPECT_FALSE(row.reason.empty());
    const auto at = schema.found.find(std::string(row.path));
    ASSERT_TRUE(at != schema.found.end()) << "the schema has no such number";
    EXPECT_EQ(at->second.least, row.least);
    EXPECT_EQ(at->second.most, row.most);
    EXPECT_EQ(at->second.or_zero, row.or_zero);
  }
  for (const auto& [path, _] : schema.found) EXPECT_TRUE(rows.contains(path)) << path << " has no range";
  EXPECT_GT(rows.size(), 35u);
}

/// A scenario in which every number of the table stands.
json with_everything() {
  Scenario s = test::sound_scenario();
  s.specimen.generator = "tooth";
  s.specimen.fdi = 36;
  s.made_with = {"class-1-adhesive", {{"depth", 1.6}}};
  s.specimen.lesions = {{}};
  s.tissues = {{Tissue::enamel, 3, 1}};
  s.instruments = {catalogue_bur("245")->bur};
  s.tool_turn_deg = 10;
  s.time_limit_s = 60;
  s.expected_time_s = 60;
  s.rubric.criteria[0].needs_dof = 5;
  for (std::size_t face = 0; face < kFaceNames; ++face) s.leeway.faces[static_cast<FaceName>(face)] = 0.2;
  s.target = region_with_every_kind();
  s.protected_parts = {Protected(s.target.parts[1], Damage::depth)};
  s.protected_parts[0].depth_mm = 1;
  json out = json::parse(write_scenario(s));
  out["target"]["parts"][1]["x_axis"] = {1, 1, 0};
  return out;
}

/// The scenario in which a number of that path stands: landmarks are of a file, all else of a grown tooth.
json with_everything_at(std::string_view path) {
  return path.starts_with("/specimen/landmarks") ? json::parse(write_scenario(marked_scenario())) : with_everything();
}

/// The first place of with_everything() that a path means; of a region's numbers that in the first part that has it.
std::string first_place(std::string path) {
  for (std::size_t at; (at = path.find('*')) != std::string::npos;) path[at] = '0';
  constexpr std::string_view kTarget = "/target";
  if (!path.starts_with(kTarget) || path == "/target/rounding_mm") return path;
  const json document = with_everything();
  for (std::size_t part = 0; part < kRegionKeys.size(); ++part) {
    const std::string place = "/target/parts/" + std::to_string(part) + path.substr(kTarget.size());
    if (document.contains(json::json_pointer(place))) return place;
  }
  return path;
}

std::vector<Finding> findings_with(const std::string& place, const json& value) {
  json document = with_everything_at(place);
  document[json::json_pointer(place)] = value;
  return validate_text(document.dump());
}

bool refuses(const std::vector<Finding>& findings, const std::string& place) {
  return std::ranges::any_of(findings, [&](const Finding& f) {
    if (f.severity != Severity::error || f.path != place || f.detail.empty()) return false;
    // The reader refuses a head's outline as a whole, the schema refuses the number.
    return f.code == "out_of_range" || f.code == "newer_format" || (f.code == "schema" && place.starts_with("/instruments/0/"));
  });
}

TEST(Ranges, TheLastValueInsideIsTakenAndTheFirstOutsideRefusedWithItsPlaceAndRange) {
  for (const NumberRange& row : number_ranges()) {
    const std::string place = first_place(std::string(row.path));
    SCOPED_TRACE(place);
    const bool whole = with_everything_at(place).at(json::json_pointer(place)).is_number_integer() &&
                       (place == "/format" || place == "/version" || place.ends_with("/needs_dof") || place.ends_with("/fdi") ||
                        place == "/specimen/seed");
    const auto value = [&](double v) { return whole ? json(static_cast<std::int64_t>(v)) : json(v); };
    const double step = whole ? 1.0 : 1e-6 * std::max(1.0, std::fabs(row.most - row.least));
    for (const double inside : {row.least, row.most, row.or_zero ? 0.0 : row.least})
      EXPECT_FALSE(refuses(findings_with(place, value(inside)), place)) << inside;
    if (place == "/format") continue;  // an older one is migrated, a newer one refused: migrate_test.cpp
    for (const double outside : {row.least - (row.least > 0 && !whole ? std::min(step, 0.5 * row.least) : step), row.most + step})
      EXPECT_TRUE(refuses(findings_with(place, value(outside)), place)) << outside;
  }
}

TEST(Ranges, WhatWasAcceptedAndWasNonsenseIsRefused) {
  for (const auto& [place, value] : {std::pair<const char*, double>{"/tissues/0/stiffness_n_per_mm", 1e-300},
                                     {"/device/full_force_n", 1e-12},
                                     {"/tissues/0/speed_mm_s", 1e-300},
                                     {"/rubric/pass", 0},
                                     {"/instruments/0/shank_radius_mm", 1e-9}}) {
    EXPECT_TRUE(refuses(findings_with(place, value), place)) << place;
  }
}

TEST(Ranges, ANumberThatIsNoneIsNamedWhereItStands) {
  Scenario s = test::sound_scenario();
  s.device.full_force_n = std::numeric_limits<double>::quiet_NaN();
  s.target.outline.depth_mm = std::numeric_limits<double>::infinity();
  std::set<std::string> places;
  for (const Finding& f : validate(s))
    if (f.code == "not_finite") places.insert(f.path);
  EXPECT_EQ(places, (std::set<std::string>{"/device/full_force_n", "/target/depth_mm"}));
}

TEST(Ranges, KnowEveryNumberThatAScenarioHolds) {
  const auto walk = [](auto& self, const json& node, const std::string& at) -> void {
    if (node.is_structured()) {
      for (const auto& [key, value] : node.items()) self(self, value, at + "/" + key);
    } else if (node.is_number()) {
      EXPECT_NE(range_of(at), nullptr) << at;
    }
  };
  walk(walk, with_everything(), "");
  walk(walk, json::parse(write_scenario(marked_scenario())), "");
  EXPECT_EQ(range_of("/tissues/x/speed_mm_s"), nullptr);
  EXPECT_EQ(range_of("/tissues"), nullptr);
  EXPECT_EQ(range_of(""), nullptr);
}

TEST(Ranges, HoldEveryBurOfTheCatalogueAndEveryTissuesUsualFigures) {
  for (const CatalogueBur& one : bur_catalogue()) {
    Scenario s = test::sound_scenario();
    s.instruments = {one.bur};
    for (const Finding& f : validate(s)) EXPECT_NE(f.code, "out_of_range") << one.bur.name << " " << f.path;
  }
  for (std::size_t code = 1; code < kTissueKeys.size(); ++code) {
    const TissueFacts& usual = tissue_facts(static_cast<Tissue>(code));
    EXPECT_TRUE(range_of("/tissues/0/stiffness_n_per_mm")->holds(usual.stiffness_n_per_mm.value)) << code;
    EXPECT_TRUE(range_of("/tissues/0/speed_mm_s")->holds(usual.speed_mm_s.value)) << code;
  }
}

}  // namespace
}  // namespace cusp::test
