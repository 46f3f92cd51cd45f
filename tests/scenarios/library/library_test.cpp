#include "scenarios/library/library.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

#include "engine/volume/specimen.h"
#include "scenarios/burs/bur_catalogue.h"
#include "scenarios/format/content_hash.h"
#include "scenarios/format/validate.h"
#include "scenarios/format/write.h"
#include "scenarios/shapes/target.h"
#include "scenarios/specimens/specimens.h"
#include "scenarios/teeth/own_tissues.h"
#include "scenarios/teeth/tooth.h"
#include "tests/full_run.h"
#include "tests/modules.h"
#include "tests/source_dir.h"

namespace cusp::test {
namespace {

TEST(Library, HoldsTheExercisesThatTheProgramComesWith) {
  const auto keys = builtin_scenarios();
  std::set<std::string> wanted = {"paper-block", "class-1-36", "class-1-36-wet",    "class-1-36-jaw", "class-1-35",    "class-1-37",
                                  "class-1-46",  "class-1-25", "class-1-16",        "class-1-17",     "class-2-36-do", "class-2-26-do",
                                  "class-2-46-mo", "class-2-25-mod", "caries-26", "caries-46"};
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
    std::ifstream file(source_dir() / "scenarios/library" / key / "scenario.json",
                       std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    EXPECT_EQ(builtin_scenario_text(key), text) << key;
  }
}

/// One of each kind of specimen and target but the jaw by default.
TEST(Library, EveryExerciseFitsItsSpecimenWithoutAFinding) {
  constexpr std::array<std::string_view, 4> kKinds = {"channel-1", "ring-3", "paper-block", "class-2-25-mod"};
  for (const std::string_view key : builtin_scenarios()) {
    if (!full_run() && std::ranges::find(kKinds, key) == kKinds.end()) continue;
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

TEST(Library, EveryExerciseStatesItsLevelAndTheTimeThatItTakes) {
  for (const std::string_view key : builtin_scenarios()) {
    const Scenario s = *load_builtin(key);
    EXPECT_TRUE(s.level) << key;
    EXPECT_GE(s.expected_time_s, 300) << key;
    EXPECT_LE(s.expected_time_s, 2700) << key << ": longer than half a lesson";
  }
  EXPECT_EQ(load_builtin("line-3")->level, Level::advanced);
  EXPECT_EQ(load_builtin("class-1-36")->level, Level::beginner);
  EXPECT_EQ(load_builtin("class-2-25-mod")->level, Level::advanced);
}

TEST(Library, EveryToothIsCutWithBursOfTheCatalogueAFissureBurAmongThemOrForCariesARoundOne) {
  for (const std::string_view key : builtin_scenarios()) {
    const Scenario s = *load_builtin(key);
    if (s.specimen.generator != "tooth") continue;
    for (const Bur& bur : s.instruments) {
      const CatalogueBur* const listed = catalogue_bur(bur.name);
      ASSERT_NE(listed, nullptr) << key << " " << bur.name;
      EXPECT_EQ(bur, listed->bur) << key << " " << bur.name;
    }
    const auto has = [&](std::string_view number) { return std::ranges::count(s.instruments, number, &Bur::name) == 1; };
    EXPECT_TRUE(s.specimen.lesions.empty() ? has("556") || has("1157") : has("4")) << key;
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
      {"channel-1", "c71ee7bcf09305111c4ff723d673667f82697b79284a9e75e1e67f9d52a52adc"},
      {"class-1-36", "084ac909adabd05e518f802c76772b227cd097bd24f86ea71785dd277fc93ab1"},
      {"class-1-36-wet", "601a1ca8ecc9547f68066c6a122479ff91fd800fbba9f878ca3643cc74d2755e"},
      {"class-1-36-jaw", "9f5bfda96644282fee8a622a6604a9be5b441824635e14e6301b47590be61947"},
      {"class-1-46", "7070a4a8ca6b8361f4d175f947832545e7a2961ae8b9c2c1dfd89379700ff61e"},
      {"class-1-25", "d6bbd19d4db21a0c100540951f7a55de54bab8654df2bf35e83fecbac1be20b8"},
      {"class-1-16", "c5486aafb5e791aafd8a78741c8ddf2ceae4b15f77ee5e56c847b52141c9e22d"},
      {"class-2-46-mo", "7d06fe689b429c16eb9c2620f69792ebc8902a2313e3579095097fc76b3eb1e4"},
      {"class-2-25-mod", "dc7f75dc4971fb37695e798dce83dc24752fdd30cdcec714cd2d6a98ef8efe6f"},
      {"class-2-36-do", "4603c67be4f5089e633158294fdfa4cbf4d2721b680ccff88e200206e80404ec"},
      {"class-2-26-do", "dfafc76e8f92883c46880cf68e9ace08b2541d178540f2a9bfda630d967b923c"},
      {"class-1-35", "e5b6016394f3995b6a15cc8f9d9e7f4becef03159c4046f456094538768f4a97"},
      {"class-1-37", "e53ef42f5996e6a37e8f603242bf4d4427fd34ce07b38f46b90f9617632aebde"},
      {"class-1-17", "ec5b1fadcc3977cdcd8366209b2ff2f080f7f1c2e0ee520a201260f8c202798e"},
      {"caries-46", "681777f99ecce2a40adba034ad4668c8b1d13926a478cf45ae69ec9815fb82d6"},
      {"caries-26", "1b4b1de5de5748a6ea366c3f52191d54d0ecc3c2db1f83dfe895bc09066c5518"},
      {"paper-block", "b88d0e0ff749ef2c5d46c46c644325d1da514768c8bf0fde4849fecada616437"},
      {"channel-2", "8bbe2ac81ca7e6f29b54ea99332cede5db9edc26d4d7a5faf2afbefb9cd8917b"},
      {"channel-3", "2cf086e2d9d1cb0370cc2ddebc00f06d8f81f7fa78603879a59fe6536d061c75"},
      {"circle-1", "0bfa9e9f3454fd2d448bdd85c9ff54281402b1f683f902524b831ce79949d871"},
      {"circle-2", "9b8173ff99fb45b97dc6ef36c36f06c379fc0b1063a0c74d74f48dc60f3db170"},
      {"circle-3", "df3ba6d218c4cc85e8d45f398ce2f2825148c98846298dc640fce2746f2ac95d"},
      {"cross-1", "5a63f0e3cc1cec775f00c983e82ecc4411c79b5f9dd32de5a5de3e1a37698185"},
      {"cross-2", "4449eb07170e71caf2d991f415abd494ea39a98bec685ab0937559833886553d"},
      {"cross-3", "2bc5ff254c3522fe985ce0391ae01b49147efafc4e4bcd838dc208bda6eff0a8"},
      {"line-1", "1283f78191b39361f3c7e90977325913f25c5b655b8b41142b5792bf5cfa795c"},
      {"line-2", "09c7ff04cb15cea15dc410e332df1949ae4e7f425c283e9ae53ea87219f45fc9"},
      {"line-3", "0a3fa58ae171f4cc8978b3bf848497606b0f86eb9a8d274852974b611bd40752"},
      {"ring-1", "6a3e7188abc8e3e1a3315636c51c915b7597a6ebeae5f36d2354dbbff3861154"},
      {"ring-2", "49462d690e5d1e61630335e9f9714ac39a3772e0c9647122f65719aa43891cad"},
      {"ring-3", "62c4345cde6aa8814be0148f3e0d20d110c427d9bc23ae40e584dafa1d74b69e"},
  };
  for (const auto& [key, hash] : hashes) EXPECT_EQ(content_hash(*load_builtin(key)).hex(), hash) << key;
}

}  // namespace
}  // namespace cusp::test
