// The catalogue holds the rows of the facts' table, each a convex head of the size it says; a broken table is refused.
#include "scenarios/burrs/burr_catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace cusp {
namespace {

using Json = nlohmann::json;

TEST(BurrCatalogue, holds_every_row_of_the_facts_table) {
  struct Row {
    const char* shape;
    const char* iso;
    std::vector<std::pair<const char*, double>> numbers;  // and diameter, mm
  };
  // facts, dental 3.4.
  const std::vector<Row> rows = {
      {"round", "001", {{"1/4", 0.5}, {"1/2", 0.6}, {"1", 0.8}, {"2", 1.0}, {"4", 1.4}, {"6", 1.8}, {"8", 2.3}}},
      {"inverted_cone", "010", {{"33 1/2", 0.6}, {"34", 0.8}, {"35", 1.0}, {"37", 1.2}}},
      {"straight_fissure", "107", {{"56", 0.9}, {"57", 1.0}, {"58", 1.2}}},
      {"cross_cut_fissure", "107", {{"556", 0.9}, {"557", 1.0}, {"558", 1.2}}},
      {"dome_fissure", "137", {{"1156", 0.9}, {"1157", 1.0}, {"1158", 1.2}}},
      {"tapered_fissure", "168", {{"169", 0.9}, {"170", 1.0}, {"171", 1.2}}},
      {"cross_cut_tapered_fissure", "168", {{"699", 0.9}, {"700", 1.0}, {"701", 1.2}}},
      {"pear", "237", {{"329", 0.7}, {"330", 0.8}, {"331", 1.0}}},
      {"long_pear", "234", {{"245", 0.9}}},
      {"round_end_taper", "198", {{"856-014", 1.4}, {"856-016", 1.6}, {"856-018", 1.8}}},
      {"flat_end_taper", "172", {{"847-016", 1.6}}},
      {"flame", "249", {{"862-012", 1.2}}},
      {"football", "257", {{"368-023", 2.3}}}};
  std::size_t count = 0;
  for (const Row& row : rows)
    for (const auto& [number, diameter] : row.numbers) {
      const CatalogueBurr* one = catalogue_burr(number);
      ASSERT_NE(one, nullptr) << number;
      EXPECT_EQ(one->shape, row.shape);
      EXPECT_EQ(one->iso_shape, row.iso);
      EXPECT_DOUBLE_EQ(2 * one->burr.radius_mm, diameter) << number;
      EXPECT_EQ(shape_of(one->burr), row.shape);
      ++count;
    }
  EXPECT_EQ(burr_catalogue().size(), count) << "and nothing else";
  EXPECT_EQ(catalogue_burr("330L"), catalogue_burr("245"));
  EXPECT_EQ(catalogue_burr("57L"), nullptr);
}

TEST(BurrCatalogue, has_heads_of_the_size_it_says_with_an_fg_shank_behind) {
  for (const CatalogueBurr& one : burr_catalogue()) {
    const Burr& b = one.burr;
    EXPECT_DOUBLE_EQ(b.shank_radius_mm, 0.8) << b.name;
    EXPECT_LT(b.neck_radius_mm, b.radius_mm) << b.name;
    EXPECT_FALSE(one.use.empty()) << b.name;
    EXPECT_EQ(one.material == "diamond", !one.ring.empty()) << b.name << ": diamonds have a grit ring";
    EXPECT_FALSE(one.verified("neck_radius_mm")) << "nobody measured one";
    if (b.head.ball()) continue;
    EXPECT_TRUE(b.head.closed()) << b.name;
    EXPECT_NEAR(b.head.widest(), b.radius_mm, 1e-9) << b.name;
    EXPECT_NEAR(b.head.low(), -b.radius_mm, 1e-12) << b.name;
    EXPECT_NEAR(b.head.high() - b.head.low(), one.head_length_mm, 1e-9) << b.name;
    EXPECT_GT(b.neck_length_mm, b.head.high()) << b.name << ": the shank begins above the head";
    for (double t = 0.0; t < b.head.high(); t += 0.01) {
      OnHalf gradient;
      EXPECT_LE(b.head.distance({t, b.neck_radius_mm}, gradient), 0.0) << b.name << ": the neck lies within the head up to its end";
    }
  }
  EXPECT_TRUE(catalogue_burr("330")->verified("iso_shape"));
  EXPECT_TRUE(catalogue_burr("330")->verified("head_length_mm"));
  EXPECT_FALSE(catalogue_burr("330")->verified("diameter_mm"));
}

TEST(BurrCatalogue, knows_its_own_burrs_from_an_authors) {
  Burr burr = catalogue_burr("57")->burr;
  EXPECT_EQ(catalogue_entry_of(burr), catalogue_burr("57"));
  burr.neck_radius_mm += 0.01;
  EXPECT_EQ(catalogue_entry_of(burr), nullptr);
  EXPECT_EQ(shape_of(burr), "straight_fissure") << "the head is still the catalogue's";
  burr.name = "mine";
  EXPECT_EQ(shape_of(burr), "other");
  burr.head = Profile();
  EXPECT_EQ(shape_of(burr), "round");
}

Json good() {
  return Json::parse(R"({"about": "", "sources": {"M": ""},
    "shank": {"radius_mm": 0.8, "length_mm": 12, "sources": {"other": "M"}},
    "burrs": [{"number": "57", "shape": "straight_fissure", "iso_shape": "107", "diameter_mm": 1.0, "head_length_mm": 4.0,
      "outline": {"kind": "flat", "tip_radius_mm": 0.5, "top_radius_mm": 0.5}, "neck_radius_mm": 0.4,
      "neck_length_mm": 6.5, "material": "carbide", "use": ["walls"], "sources": {"other": "M"}}]})");
}

TEST(BurrCatalogue, refuses_what_is_not_a_table_of_burrs) {
  ASSERT_TRUE(read_burr_table(good().dump()));
  const auto refused = [](auto&& change) {
    Json table = good();
    change(table);
    const auto read = read_burr_table(table.dump());
    EXPECT_FALSE(read);
    return read ? std::string("taken") : std::to_string(static_cast<int>(read.error().code)) + " " + read.error().where;
  };
  const auto says = [](BurrTableError code, const char* where) {
    return std::to_string(static_cast<int>(code)) + " " + where;
  };
  using E = BurrTableError;
  EXPECT_EQ(refused([](Json& t) { t["burrs"][0].erase("diameter_mm"); }), says(E::missing, "/burrs/0/diameter_mm"));
  EXPECT_EQ(refused([](Json& t) { t["burrs"][0]["diameter_mm"] = -1; }), says(E::bad_value, "/burrs/0/diameter_mm"));
  EXPECT_EQ(refused([](Json& t) { t["burrs"][0]["diameter_mm"] = 1.2; }), says(E::bad_value, "/burrs/0/outline"))
      << "a head that is not as wide as it says";
  EXPECT_EQ(refused([](Json& t) { t["burrs"][0]["outline"]["kind"] = "star"; }), says(E::unknown_word, "/burrs/0/outline/kind"));
  EXPECT_EQ(refused([](Json& t) { t["burrs"][0]["outline"]["depth_mm"] = 1; }), says(E::unknown_key, "/burrs/0/outline/depth_mm"));
  EXPECT_EQ(refused([](Json& t) { t["burrs"][0]["shape"] = "star"; }), says(E::unknown_word, "/burrs/0/shape"));
  EXPECT_EQ(refused([](Json& t) { t["burrs"][0]["use"] = {"nothing"}; }), says(E::unknown_word, "/burrs/0/use"));
  EXPECT_EQ(refused([](Json& t) { t["burrs"][0]["sources"]["other"] = "hearsay"; }),
            says(E::unknown_source, "/burrs/0/sources/other"));
  EXPECT_EQ(refused([](Json& t) { t["burrs"].push_back(t["burrs"][0]); }), says(E::twice, "/burrs/1/number"));
  EXPECT_EQ(refused([](Json& t) { t["burrs"] = 3; }), says(E::missing, "/burrs"));
  EXPECT_EQ(refused([](Json& t) { t = 3; }), says(E::bad_json, ""));
  EXPECT_FALSE(read_burr_table("{"));
}

}  // namespace
}  // namespace cusp
