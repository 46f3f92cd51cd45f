// The catalogue holds the rows of the facts' table, each a convex head of the stated size; a broken table is refused.
#include "scenarios/burs/bur_catalogue.h"
#include "tests/modules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace cusp::test {
namespace {

using Json = nlohmann::json;

TEST(BurCatalogue, holds_every_row_of_the_facts_table) {
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
      const CatalogueBur* one = catalogue_bur(number);
      ASSERT_NE(one, nullptr) << number;
      EXPECT_EQ(one->shape, row.shape);
      EXPECT_EQ(one->iso_shape, row.iso);
      EXPECT_DOUBLE_EQ(2 * one->bur.radius_mm, diameter) << number;
      EXPECT_EQ(shape_of(one->bur), row.shape);
      ++count;
    }
  EXPECT_EQ(bur_catalogue().size(), count) << "and nothing else";
  EXPECT_EQ(catalogue_bur("330L"), catalogue_bur("245"));
  EXPECT_EQ(catalogue_bur("57L"), nullptr);
}

TEST(BurCatalogue, has_heads_of_the_stated_size_with_an_fg_shank_behind) {
  for (const CatalogueBur& one : bur_catalogue()) {
    const Bur& b = one.bur;
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
  EXPECT_TRUE(catalogue_bur("330")->verified("iso_shape"));
  EXPECT_TRUE(catalogue_bur("330")->verified("head_length_mm"));
  EXPECT_FALSE(catalogue_bur("330")->verified("diameter_mm"));
}

TEST(BurCatalogue, names_the_shape_of_a_head_from_the_catalogue_alone) {
  Bur bur = catalogue_bur("57")->bur;
  bur.neck_radius_mm += 0.01;
  EXPECT_EQ(shape_of(bur), "straight_fissure") << "the head is still the catalogue's";
  bur.name = "mine";
  EXPECT_EQ(shape_of(bur), "other");
  bur.head = Profile();
  EXPECT_EQ(shape_of(bur), "round");
}

Json good() {
  return Json::parse(R"({"about": "", "sources": {"M": ""},
    "shank": {"radius_mm": 0.8, "length_mm": 12, "sources": {"other": "M"}},
    "burs": [{"number": "57", "shape": "straight_fissure", "iso_shape": "107", "diameter_mm": 1.0, "head_length_mm": 4.0,
      "outline": {"kind": "flat", "tip_radius_mm": 0.5, "top_radius_mm": 0.5}, "neck_radius_mm": 0.4,
      "neck_length_mm": 6.5, "material": "carbide", "use": ["walls"], "sources": {"other": "M"}}]})");
}

TEST(BurCatalogue, refuses_what_is_not_a_table_of_burs) {
  ASSERT_TRUE(read_bur_table(good().dump()));
  const auto refused = [](auto&& change) {
    Json table = good();
    change(table);
    const auto read = read_bur_table(table.dump());
    EXPECT_FALSE(read);
    return read ? std::string("taken") : std::to_string(static_cast<int>(read.error().code)) + " " + read.error().where;
  };
  const auto failure = [](BurTableError code, const char* where) {
    return std::to_string(static_cast<int>(code)) + " " + where;
  };
  using E = BurTableError;
  EXPECT_EQ(refused([](Json& t) { t["burs"][0].erase("diameter_mm"); }), failure(E::missing, "/burs/0/diameter_mm"));
  EXPECT_EQ(refused([](Json& t) { t["burs"][0]["diameter_mm"] = -1; }), failure(E::bad_value, "/burs/0/diameter_mm"));
  EXPECT_EQ(refused([](Json& t) { t["burs"][0]["diameter_mm"] = 1.2; }), failure(E::bad_value, "/burs/0/outline"))
      << "a head that is not as wide as its diameter";
  EXPECT_EQ(refused([](Json& t) { t["burs"][0]["outline"]["kind"] = "star"; }), failure(E::unknown_value, "/burs/0/outline/kind"));
  EXPECT_EQ(refused([](Json& t) { t["burs"][0]["outline"]["depth_mm"] = 1; }), failure(E::unknown_key, "/burs/0/outline/depth_mm"));
  EXPECT_EQ(refused([](Json& t) { t["burs"][0]["shape"] = "star"; }), failure(E::unknown_value, "/burs/0/shape"));
  EXPECT_EQ(refused([](Json& t) { t["burs"][0]["use"] = {"nothing"}; }), failure(E::unknown_value, "/burs/0/use"));
  EXPECT_EQ(refused([](Json& t) { t["burs"][0]["sources"]["other"] = "hearsay"; }),
            failure(E::unknown_source, "/burs/0/sources/other"));
  EXPECT_EQ(refused([](Json& t) { t["burs"].push_back(t["burs"][0]); }), failure(E::twice, "/burs/1/number"));
  EXPECT_EQ(refused([](Json& t) { t["burs"] = 3; }), failure(E::missing, "/burs"));
  EXPECT_EQ(refused([](Json& t) { t = 3; }), failure(E::bad_json, ""));
  EXPECT_FALSE(read_bur_table("{"));
}

TEST(BurCatalogue, KnowsABurByHeadAndDiameterAndANumberThatIsNotItsOwn) {
  for (const CatalogueBur& one : bur_catalogue()) {
    EXPECT_TRUE(fits_its_number(one.bur)) << one.bur.name;
    const CatalogueBur* like = catalogue_bur_like(one.bur);
    ASSERT_NE(like, nullptr);
    EXPECT_EQ(like->bur.head, one.bur.head) << one.bur.name;
  }
  Bur larger = catalogue_bur("2")->bur;
  larger.radius_mm = 0.55;
  EXPECT_FALSE(fits_its_number(larger));
  EXPECT_EQ(catalogue_bur_like(larger), nullptr);
  larger.name = "own";
  EXPECT_TRUE(fits_its_number(larger));
  Bur other_neck = catalogue_bur("4")->bur;
  other_neck.neck_radius_mm = 0.3;
  EXPECT_TRUE(fits_its_number(other_neck));
  Bur ball = catalogue_bur("330")->bur;
  ball.head = {};
  EXPECT_FALSE(fits_its_number(ball));
}

}  // namespace
}  // namespace cusp::test
