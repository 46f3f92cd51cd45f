#include "scenarios/blocks/block_exercises.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// Content hashes of the exercises as they stood in files, two versions earlier, with the former English briefings, and without
/// level and expected time.
const std::map<std::string_view, std::string_view> kEarlierHashes = {
    {"channel-1", "a2c613018c7411850333640b96871b531ddc164333e05e2ddbf8ff9f45df61be"},
    {"channel-2", "37d9bd3081f20782c20dd2c6c1879c407d9c6dd95368103c184bdbf641274bd2"},
    {"channel-3", "ec3506ecbb866153bf3ea1409056f8497650082739b23c59ca2d85cb39cb145e"},
    {"line-1", "924f72358917e73d045c7b85df3752cae4ab20568b03973a8ad05dbc4c0f1159"},
    {"line-2", "810b1ef3513efcbb44be79abf446aaa8701a73fd3dce06eeb15a08d5548751b4"},
    {"line-3", "6d25c39fffdbfb158d10f6516a67523b02e174cc0058cb5fb3500f3af1a47d6e"},
    {"cross-1", "fc251cf6f09e9813ca7347dc59cf78edf3361778ff8dacb377b24329170c28bd"},
    {"cross-2", "a18d52f5dfa005160917e3c785b358a940f1e1c337e60bb277de629368df2127"},
    {"cross-3", "ea9cfef0178b5561367afef4fb65dd642b99340ca08e0f5f9210729dbccf11c4"},
    {"circle-1", "f6213101593b9916fd47eeb3a95a8a1e86180ceae2a581af3ae4c97e5eee31a4"},
    {"circle-2", "1424d1107f94126f1b4c49bd5f86179484b62efc4970f4d4ec5631fa2542eec1"},
    {"circle-3", "b068b52cab36873352fd7ac54e2282a46a56d23a3906cd2d01e8b6a1dddaea64"},
    {"ring-1", "e99959fea734a881def192512918717217368dd821bc970b7028641bb132b04b"},
    {"ring-2", "285b0d18a601e2646c986890f14992142f8c4492e9295363f3ceba0103336586"},
    {"ring-3", "8a39c01a9537f3236c1a750576bca8233f0223d87b5553678f9add05d6c916e8"},
};

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != text.npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
  return text;
}

/// The exercise as its file stood: two versions before, without level and time, and with the terms that the briefing had then.
Scenario earlier(Scenario s) {
  s.version -= 2;
  s.level.reset();
  s.expected_time_s = 0;
  std::string& en = s.briefing["en"];
  en = replaced(en, "anything beyond is over-cut", "beyond that is cut too far");
  en = replaced(en, "than the bur.", "than the burr.");
  en = replaced(en, "feel the bur break", "feel the burr break");
  return s;
}

TEST(BlockExercise, EqualsItsFormerFileApartFromTermsLevelAndTime) {
  ASSERT_EQ(block_exercises().size(), kEarlierHashes.size());
  for (const BlockExercise& e : block_exercises())
    EXPECT_EQ(content_hash(earlier(block_exercise(e.shape, e.level))).hex(), kEarlierHashes.at(e.key)) << e.key;
}

TEST(BlockExercise, HasItsKeyAndAnIdOfItsOwn) {
  std::set<ScenarioId> ids;
  for (const BlockExercise& e : block_exercises()) {
    const Scenario s = block_exercise(e.shape, e.level);
    EXPECT_EQ(s.key, e.key);
    EXPECT_TRUE(ids.insert(s.id).second) << e.key;
  }
}

TEST(BlockExercise, ReadsBackAsItIsWritten) {
  for (const BlockExercise& e : block_exercises()) {
    const Scenario s = block_exercise(e.shape, e.level);
    const auto back = read_scenario(write_scenario(s));
    ASSERT_TRUE(back) << e.key << " " << back.error().where;
    EXPECT_EQ(*back, s) << e.key;
  }
}

TEST(BlockExercise, HigherLevelsTolerateLess) {
  for (const BlockShape shape : {BlockShape::channel, BlockShape::line, BlockShape::cross, BlockShape::circle, BlockShape::ring}) {
    const std::array levels = {block_exercise(shape, BlockLevel::first), block_exercise(shape, BlockLevel::second),
                               block_exercise(shape, BlockLevel::third)};
    for (std::size_t i = 1; i < levels.size(); ++i) {
      EXPECT_LT(levels[i].leeway.side_mm, levels[i - 1].leeway.side_mm);
      for (std::size_t c = 3; c < levels[i].rubric.criteria.size(); ++c)
        EXPECT_LT(levels[i].rubric.criteria[c].bands.fail_hi, levels[i - 1].rubric.criteria[c].bands.fail_hi);
    }
  }
}

}  // namespace
}  // namespace cusp::test
