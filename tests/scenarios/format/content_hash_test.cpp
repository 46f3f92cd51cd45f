#include "scenarios/format/content_hash.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "scenarios/format/write.h"
#include "tests/modules.h"
#include "tests/scenarios/format/make_scenario.h"

namespace cusp::test {
namespace {

using test::ScenarioMaker;
using test::sound_scenario;

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto view = std::as_bytes(std::span(text));
  return {view.begin(), view.end()};
}

TEST(ContentHash, IsBlake2b256) {
  // python3 -c "import hashlib; print(hashlib.blake2b(b'', digest_size=32).hexdigest())", and of b'abc'.
  EXPECT_EQ(hash_of_bytes({}).hex(), "0e5751c026e543b2e8ab2eb06099daa1d1e5df47778f7787faab45cdf12fe3a8");
  EXPECT_EQ(hash_of_bytes(bytes_of("abc")).hex(), "bddd813c634239723171ef3fee98579b94964e3bb1cb3e427262c8c068d52319");
}

TEST(ContentHash, IsOverSortedLinesOfHashAndPath) {
  const Scenario scenario = sound_scenario();
  const std::map<std::string, std::vector<std::byte>> beside{{"z.nrrd", bytes_of("z")}, {"a.nrrd", bytes_of("a")}};
  const std::string lines = hash_of_bytes(bytes_of("a")).hex() + "  a.nrrd\n" +
                            hash_of_bytes(bytes_of(hashed_json(scenario))).hex() + "  scenario.json\n" +
                            hash_of_bytes(bytes_of("z")).hex() + "  z.nrrd\n";
  EXPECT_EQ(content_hash(scenario, beside), hash_of_bytes(bytes_of(lines)));
}

TEST(ContentHash, ChangesWithEveryValueAndWithNothingElse) {
  const Scenario scenario = sound_scenario();
  std::set<ContentHash> seen{content_hash(scenario)};
  const auto differs = [&](auto change) {
    Scenario other = scenario;
    change(other);
    EXPECT_TRUE(seen.insert(content_hash(other)).second);
  };
  differs([](Scenario& s) { s.version = 2; });
  differs([](Scenario& s) { s.title["en"] += "."; });
  differs([](Scenario& s) { s.level = Level::beginner; });
  differs([](Scenario& s) { s.expected_time_s = 600; });
  differs([](Scenario& s) { s.self_assessment = true; });
  differs([](Scenario& s) { s.target.outline.depth_mm = std::nextafter(2.0, 3.0); });
  differs([](Scenario& s) { s.rubric.criteria[0].weight += 1e-9; });
  differs([](Scenario& s) { std::swap(s.rubric.criteria[0], s.rubric.criteria[1]); });
  differs([](Scenario& s) { s.tolerance_points = 0; });
  EXPECT_NE(content_hash(scenario), content_hash(scenario, {{"x", {}}}));

  Scenario same = scenario;
  same.target.outline.top_mm = -0.0;
  EXPECT_EQ(content_hash(same), content_hash(scenario));
}

TEST(ContentHash, ChangesWithEveryValueOfALandmark) {
  const Scenario scenario = marked_scenario();
  std::set<ContentHash> seen{content_hash(scenario)};
  const auto differs = [&](auto change) {
    Scenario other = scenario;
    change(other.specimen.landmarks);
    EXPECT_TRUE(seen.insert(content_hash(other)).second);
  };
  differs([](SpecimenLandmarks& l) { l.fdi = 0; });
  differs([](SpecimenLandmarks& l) { l.fdi = 46; });
  differs([](SpecimenLandmarks& l) { l.marks.pop_back(); });
  differs([](SpecimenLandmarks& l) { std::swap(l.marks[0], l.marks[1]); });
  differs([](SpecimenLandmarks& l) { l.marks[2].kind = MarkKind::contour; });
  differs([](SpecimenLandmarks& l) { l.marks[3].name = "mesial"; });
  differs([](SpecimenLandmarks& l) { l.marks[3].state = MarkState::proposed; });
  differs([](SpecimenLandmarks& l) { l.marks[8].points_mm[2].y = 1e-9; });
  Scenario without = scenario;
  without.specimen.landmarks = {};
  EXPECT_EQ(hashed_json(without).find("landmarks"), std::string::npos) << "an exercise without them keeps its hash";
  EXPECT_TRUE(seen.insert(content_hash(without)).second);
}

TEST(CanonicalJson, IsSortedWithoutBlanksAndShortest) {
  EXPECT_EQ(
      *canonical_json(R"( {"b" : [1.0, 0.10, 1e2, -0.0, 1E-7, 18446744073709551615], "a": {"ü": "\u00fc\n\/"}} )"),
      R"({"a":{"ü":"ü\n/"},"b":[1,0.1,100,0,1e-07,18446744073709551615]})");
  EXPECT_EQ(*canonical_json("[]"), "[]");
  EXPECT_EQ(canonical_json("{").error().code, FormatError::broken_json);
}

TEST(CanonicalJson, OfCanonicalJsonIsItself) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const Scenario scenario = ScenarioMaker(seed).make();
    const std::string once = canonical_json(scenario);
    ASSERT_EQ(*canonical_json(once), once);
    ASSERT_EQ(*canonical_json(write_scenario(scenario)), once);  // layout does not matter
  }
}

}  // namespace
}  // namespace cusp::test
