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
#include "scenarios/shapes/outline.h"
#include "scenarios/specimens/specimens.h"
#include "scenarios/teeth/tooth.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

TEST(Library, HoldsTheExercisesThatTheProgramComesWith) {
  const auto keys = builtin_scenarios();
  std::set<std::string> wanted = {"paper-block", "class-1-36", "class-1-36-wet", "class-1-36-jaw"};
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
  for (const std::string_view key : {"", "class-1-37", "../class-1-36", "Channel-1"}) {
    const auto scenario = load_builtin(key);
    ASSERT_FALSE(scenario) << key;
    EXPECT_EQ(scenario.error().code, FormatError::unknown_builtin);
    EXPECT_TRUE(builtin_scenario_text(key).empty());
  }
}

TEST(Library, WhatIsBuiltInIsTheFileAsTheProgramWritesIt) {
  for (const std::string_view key : builtin_scenarios()) {
    std::ifstream file(std::string(CUSP_SOURCE_DIR "/scenarios/library/") + std::string(key) + "/scenario.json",
                       std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    EXPECT_EQ(builtin_scenario_text(key), text) << key;
    EXPECT_EQ(write_scenario(*load_builtin(key)), text) << key;
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
  EXPECT_GT(s.target.depth_mm, 2 * 10.0 / 3) << "the pit ends before the third material";
}

TEST(Library, TheClassOneFollowsTheFissuresAndSparesPulpAndRidges) {
  const Scenario s = *load_builtin("class-1-36");
  const auto tooth = grow_tooth({s.specimen.fdi, s.specimen.seed, s.specimen.voxel_mm});
  ASSERT_TRUE(tooth);
  const ToothLandmarks& marks = tooth->landmarks;

  // Every point of the outline lies within 0.1 mm of the bottom of a fissure.
  for (const auto& path : s.target.paths) {
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
    EXPECT_LT(shape.distance_mm(pit.at_mm), 0) << "the " << pit.name << " pit is left standing";
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

TEST(Library, TheHashOfAPublishedExerciseStaysWhatItIs) {
  // A change of any value is a new version: raise `version` in the file and take the new hash from here.
  const std::pair<std::string_view, std::string_view> hashes[] = {
      {"channel-1", "a2c613018c7411850333640b96871b531ddc164333e05e2ddbf8ff9f45df61be"},
      {"class-1-36", "61bcca482db25a3a6518de54380f155408ca85f492dbfa5f7a99f4bec3e04896"},
      {"class-1-36-wet", "ed841b8ea69c003cb63670c2b0fe7f342a3249a368d771b6783e4543af182f7d"},
      {"class-1-36-jaw", "85e191ccc8bf6b483fed9827567a40c4b703742961385bac2ebb8b7f04e8e53f"},
      {"paper-block", "ff3254c1c17b1207b314575e3846469d0e81af1dcfbfe2a5ff19aafcb275fe47"},
      {"channel-2", "37d9bd3081f20782c20dd2c6c1879c407d9c6dd95368103c184bdbf641274bd2"},
      {"channel-3", "ec3506ecbb866153bf3ea1409056f8497650082739b23c59ca2d85cb39cb145e"},
      {"circle-1", "f6213101593b9916fd47eeb3a95a8a1e86180ceae2a581af3ae4c97e5eee31a4"},
      {"circle-2", "1424d1107f94126f1b4c49bd5f86179484b62efc4970f4d4ec5631fa2542eec1"},
      {"circle-3", "b068b52cab36873352fd7ac54e2282a46a56d23a3906cd2d01e8b6a1dddaea64"},
      {"cross-1", "fc251cf6f09e9813ca7347dc59cf78edf3361778ff8dacb377b24329170c28bd"},
      {"cross-2", "a18d52f5dfa005160917e3c785b358a940f1e1c337e60bb277de629368df2127"},
      {"cross-3", "ea9cfef0178b5561367afef4fb65dd642b99340ca08e0f5f9210729dbccf11c4"},
      {"line-1", "924f72358917e73d045c7b85df3752cae4ab20568b03973a8ad05dbc4c0f1159"},
      {"line-2", "810b1ef3513efcbb44be79abf446aaa8701a73fd3dce06eeb15a08d5548751b4"},
      {"line-3", "6d25c39fffdbfb158d10f6516a67523b02e174cc0058cb5fb3500f3af1a47d6e"},
      {"ring-1", "e99959fea734a881def192512918717217368dd821bc970b7028641bb132b04b"},
      {"ring-2", "285b0d18a601e2646c986890f14992142f8c4492e9295363f3ceba0103336586"},
      {"ring-3", "8a39c01a9537f3236c1a750576bca8233f0223d87b5553678f9add05d6c916e8"},
  };
  for (const auto& [key, hash] : hashes) EXPECT_EQ(content_hash(*load_builtin(key)).hex(), hash) << key;
}

}  // namespace
}  // namespace cusp::test
