#include "scenarios/library/library.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

#include "engine/volume/specimen.h"
#include "scenarios/format/content_hash.h"
#include "scenarios/format/validate.h"
#include "scenarios/format/write.h"
#include "scenarios/shapes/target.h"
#include "scenarios/specimens/specimens.h"
#include "scenarios/teeth/own_tissues.h"
#include "scenarios/teeth/tooth.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

TEST(Library, HoldsTheExercisesThatTheProgramComesWith) {
  const auto keys = builtin_scenarios();
  std::set<std::string> wanted = {"paper-block", "class-1-36", "class-1-36-wet",    "class-1-36-jaw", "class-1-35",    "class-1-37",
                                  "class-1-46",  "class-1-25", "class-1-16",        "class-1-17",     "class-2-36-do", "class-2-26-do",
                                  "class-2-46-mo", "class-2-25-mod"};
  for (const char* shape : {"line", "channel", "cross", "circle", "ring"}) {
    for (const char* level : {"-1", "-2", "-3"}) wanted.insert(std::string(shape) + level);
  }
  EXPECT_EQ(std::set<std::string>(keys.begin(), keys.end()), wanted);
  std::set<ScenarioId> ids;
  for (const std::string_view key : keys) {
    const auto scenario = load_builtin(key);
    ASSERT_TRUE(scenario) << key << ": " << key_of(scenario.error().code) << " " << scenario.error().where;
    EXPECT_EQ(scenario->key, key);
    EXPECT_TRUE(ids.insert(scenario->id).second) << key << " has another's id";
    EXPECT_TRUE(scenario->title.contains("de") && scenario->briefing.contains("de")) << key;
  }
}

TEST(Library, OffersTheLevelsOfAShapeOneAfterAnother) {
  const auto keys = builtin_scenarios();
  const auto place = [&](const std::string& key) { return std::ranges::find(keys, std::string_view(key)) - keys.begin(); };
  for (const std::string shape : {"line", "channel", "cross", "circle", "ring"}) {
    EXPECT_EQ(place(shape + "-2"), place(shape + "-1") + 1);
    EXPECT_EQ(place(shape + "-3"), place(shape + "-1") + 2);
  }
  EXPECT_EQ(keys.front(), "channel-1");
  EXPECT_EQ(place("class-1-36-wet"), place("class-1-36") + 1);
  EXPECT_EQ(place("class-1-36-jaw"), place("class-1-36") + 2);
}

TEST(Library, KnowsNoOtherKey) {
  for (const std::string_view key : {"", "class-1-38", "../class-1-36", "Channel-1"}) {
    const auto scenario = load_builtin(key);
    ASSERT_FALSE(scenario) << key;
    EXPECT_EQ(scenario.error().code, FormatError::unknown_builtin);
    EXPECT_TRUE(builtin_scenario_text(key).empty());
  }
}

TEST(Library, EveryTextStandsAsTheProgramWritesIt) {
  for (const std::string_view key : builtin_scenarios()) EXPECT_EQ(write_scenario(*load_builtin(key)), builtin_scenario_text(key)) << key;
}

TEST(Library, EmbedsTheFilesAsTheyStand) {
  for (const std::string_view key : builtin_scenarios()) {
    if (load_builtin(key)->specimen.generator.ends_with("block") && key != "paper-block") continue;  // generated
    std::ifstream file(std::string(CUSP_SOURCE_DIR "/scenarios/library/") + std::string(key) + "/scenario.json",
                       std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    EXPECT_EQ(builtin_scenario_text(key), text) << key;
  }
}

TEST(Library, EveryExerciseFitsItsSpecimenWithoutAFinding) {
  for (const std::string_view key : builtin_scenarios()) {
    SCOPED_TRACE(key);
    const Scenario scenario = *load_builtin(key);
    const auto volume = make_specimen(scenario.specimen, {});
    ASSERT_TRUE(volume);
    const SpecimenFacts facts = facts_of(*volume);
    for (const Finding& f : validate_text(builtin_scenario_text(key), &facts)) {
      ADD_FAILURE() << f.path << " " << f.code << " " << f.detail;
    }
  }
}

/// Numbers that are the paper's own (section 4), and the force of its Falcon.
TEST(Library, ThePapersBlockHasThePapersNumbers) {
  const Scenario s = *load_builtin("paper-block");
  EXPECT_EQ(s.method, Method::occupancy);
  EXPECT_EQ(s.specimen.voxel_mm, 10.0 / 128);
  EXPECT_EQ(s.device.full_force_n, 8.9);
  EXPECT_EQ(s.instruments.at(0).radius_mm, 0.25);
  ASSERT_EQ(s.tissues.size(), 3u);
  const std::array<double, 3> speeds = {1.2, 0.8, 0.5};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(s.tissues[i].speed_mm_s, speeds[i]);
  EXPECT_GT(s.target.outline.depth_mm, 2 * 10.0 / 3) << "the pit ends before the third material";
}

TEST(Library, TheClassOneFollowsTheFissuresAndSparesPulpAndRidges) {
  const Scenario s = *load_builtin("class-1-36");
  const auto tooth = grow_tooth({s.specimen.fdi, s.specimen.seed, s.specimen.voxel_mm});
  ASSERT_TRUE(tooth);
  const ToothLandmarks& marks = tooth->landmarks;

  // Every point of the outline lies within 0.1 mm of the bottom of a fissure.
  for (const auto& path : s.target.outline.paths) {
    for (const Vec3& point : path) {
      double nearest = 1e9;
      for (const SurfaceLine& line : marks.fissures) {
        for (const Vec3& at : line.points_mm) nearest = std::min(nearest, std::hypot(at.x - point.x, at.y - point.y));
      }
      EXPECT_LT(nearest, 0.1) << point.x << " " << point.y;
    }
  }
  const TargetShape shape(s.target);
  for (const SurfacePlace& pit : marks.pits) {
    EXPECT_LT(shape.distance_mm(pit.at_mm), 0) << "the " << pit.name << " pit is not cut";
  }

  // Remaining ridge: from the cavity's end to the tooth's outermost at the ridge's height; at least 1.6 mm
  // (dental.md 2.2).
  EXPECT_GT(marks.mesial_contact.x - shape.high().x, 1.6);
  EXPECT_GT(shape.low().x - marks.distal_contact.x, 1.6);

  // Voxels as cubes: the nearest of the pulp to the target; above 1.0 mm is safe (dental.md 2.2, [M]).
  const VoxelVolume& v = tooth->volume;
  double to_pulp = 1e9;
  double deepest_enamel = 1e9;  // under the central pit
  std::size_t at = 0;
  for (int z = 0; z < v.grid.size.z; ++z) {
    for (int y = 0; y < v.grid.size.y; ++y) {
      for (int x = 0; x < v.grid.size.x; ++x, ++at) {
        if (v.s[at] < kHalf) continue;
        const Vec3 centre = v.grid.centre_mm({x, y, z});
        if (v.tissue[at] == Tissue::pulp) to_pulp = std::min(to_pulp, shape.distance_mm(centre));
        if (v.tissue[at] == Tissue::enamel &&
            std::hypot(centre.x - marks.central.x, centre.y - marks.central.y) < 0.1) {
          deepest_enamel = std::min(deepest_enamel, centre.z);
        }
      }
    }
  }
  EXPECT_GT(to_pulp, 1.0 + v.grid.voxel_mm);
  // 0.2 to 0.6 mm into dentine under the pit (dental.md 2.2: at least 0.2 to 0.5).
  EXPECT_GT(deepest_enamel - shape.floor_mm(), 0.2);
  EXPECT_LT(deepest_enamel - shape.floor_mm(), 0.6);
}

TEST(Library, CuttingANeighbourFailsAClassTwo) {
  for (const std::string_view key : {"class-2-36-do", "class-2-26-do", "class-2-46-mo", "class-2-25-mod"}) {
    const Scenario s = *load_builtin(key);
    EXPECT_EQ(std::ranges::count(s.rubric.critical, "protected_damage"), 1) << key;
    const auto enamel = std::ranges::find_if(s.protected_parts, [](const Protected& one) { return one.severity == Damage::depth; });
    ASSERT_NE(enamel, s.protected_parts.end()) << key;
    EXPECT_EQ(enamel->region->tissue, kNeighbourEnamel) << key;
    EXPECT_EQ(std::ranges::count(s.rubric.criteria, "protected_removed", &Criterion::metric), 1) << key;
  }
}

TEST(Library, HasTwelveExercisesOnEightTeethOfBothJaws) {
  std::set<int> teeth;
  int exercises = 0;
  for (const std::string_view key : builtin_scenarios()) {
    const SpecimenSource of = load_builtin(key)->specimen;
    if (of.generator != "tooth") continue;
    ++exercises;
    teeth.insert(of.fdi);
  }
  EXPECT_GE(exercises, 12);
  EXPECT_GE(teeth.size(), 8u);
  EXPECT_GE(std::ranges::count_if(teeth, [](int fdi) { return fdi < 30; }), 3);
}

TEST(Library, TheHashOfAPublishedExerciseStaysWhatItIs) {
  // A change of any value is a new version: raise `version` in the file or in block_exercises.cpp, take the new hash from here.
  const std::pair<std::string_view, std::string_view> hashes[] = {
      {"channel-1", "52f195d13b730414064a9905a9734633fd0ac7326b65ee41b3e1875b0193f65d"},
      {"class-1-36", "56d220166baaac98dfc2c7a8641e9b2d1c3c3979d23ecd965b8de08c513c6aa5"},
      {"class-1-36-wet", "48fe35df2775cdeabd10dd7b107112102021fedc756a8a34fff7e91d26f4c748"},
      {"class-1-36-jaw", "62d5275594af5fcea37172622bd597f3b3a03281220856b8514687ba4429ae32"},
      {"class-1-46", "40da3908677afc83e73157c5340776ab2af95b1db113d06c4e19b9887f012150"},
      {"class-1-25", "f853e9cbe4bdc6a069aa925770e9544e450a41f6442f4be74a4cd5c423b7d1bc"},
      {"class-1-16", "f15410071924726dfd0d4e36a8311dbe059140d0cc4cc1c0c121547b2e93e0a9"},
      {"class-2-46-mo", "d6d726d1175322fe5fc916ff4174ae96b7316a54a02ec7e2c77bdff137c8c255"},
      {"class-2-25-mod", "2666a77dacff29baaecaaf46dc01207f4558be8d9c3345c428b90041c3f8e097"},
      {"class-2-36-do", "1a4d5dd72aca5d0ea8d1ebc709ed4ef555e19bc2bd059d63aaa9395f0b9384cd"},
      {"class-2-26-do", "573d84c2154ff2577a3b1f69e5cdc13435a9476aa0886c56137debdec95d00fc"},
      {"class-1-35", "b119ca4bf1b97bcafbe10eaf020083c7d34d81fd9ddc4787c846c648291621a4"},
      {"class-1-37", "38884f1f89edbd4359040aa377b315e891747f709a73688c5cb337ab7e2f108f"},
      {"class-1-17", "1c7739f4d5f1af018ac0cfe3da61d97d5d9863f30b8cb51b91ca2621c088386b"},
      {"paper-block", "ff3254c1c17b1207b314575e3846469d0e81af1dcfbfe2a5ff19aafcb275fe47"},
      {"channel-2", "be02e9086351af9c6700ff3e3317484c0a5e60692f6cc157434c8eb5144b96ae"},
      {"channel-3", "84f71a9fa5df073e7b6f91b172fc44e9d823937eb6f239afe1b538f9efc7e4ab"},
      {"circle-1", "dea097eec683d818b7fb58e10600f8df5cb4c7c34fb25b75fdca719b771d9bfe"},
      {"circle-2", "891dee1efa3c54af5792d16f9fe5f6e2aeea87f884f08d6f0c0eb6f67e0775f0"},
      {"circle-3", "9e94108fa8c160be92f1e58f325e540817149bf32157a9ad150e90a0841bdd7e"},
      {"cross-1", "064a116f8e28c3071a549a75d50ddfd25c8b7b38bfd56d8b55ba73b573aa18b3"},
      {"cross-2", "6b25d6f784c37e99f7cee5d5dfda74008efb435e8e9862ccd5ccd713f9f67adf"},
      {"cross-3", "45bedbaa2bd58c554428b38a303b7538ad968efacf06f5c1417806f6a92d105c"},
      {"line-1", "73831246a207c0da7c210569ed23a4ca9b8fa589cee4738ec73ef47499dfc73c"},
      {"line-2", "6184c6068f22e3b95d4d9f4ba90c072d66e5c68689707d616ba350a6d9d21cb3"},
      {"line-3", "e751fdf60a13dd8789d14926f5f93f354cae12d0a1099c54f23923f9b556ea02"},
      {"ring-1", "0c239a3451551483bb3219590f0cef783dedc55a4f9e9d836aa414cb096d2f42"},
      {"ring-2", "3266e25a6ce2f098db0579ff85ee5a707b1eb9e6e9d1cc51096056345662bf5d"},
      {"ring-3", "4e638f49b804154ba8cccb3972119bd88e0e4570c6c568332d866c34d64b8e2f"},
  };
  for (const auto& [key, hash] : hashes) EXPECT_EQ(content_hash(*load_builtin(key)).hex(), hash) << key;
}

}  // namespace
}  // namespace cusp::test
