#include "engine/mirror/mirror.h"

#include <gtest/gtest.h>

#include <map>

#include "engine/loop/haptic_loop.h"
#include "tests/engine/loop/block_scene.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using test::DrillingPort;
using test::eventually;

/// Keeps its own copy of the cut from the bricks of StateNews.
class Sketch final : public MirrorObserver {
 public:
  void on_tick(const StepInput&, const StepState& after) override {
    in_order = in_order && after.last().tick == ticks + 1;
    ticks = after.last().tick;
  }
  void on_state(const StepState& state, const StateNews& news) override {
    ++shows;
    consistent = consistent && state.last().tick == ticks;
    if (news.first) {
      ++firsts;
      cut.clear();
    }
    if (news.last) ++lasts;
    for (const std::int32_t brick : news.changed_bricks) {
      const std::uint16_t* values = state.volume().cut_of(brick);
      cut[brick].assign(values, values + kBrickVoxels);
    }
  }
  bool equals(const Volume& volume) const {
    if (cut.size() != volume.cut_bricks().size()) return false;
    for (const auto& [brick, values] : cut) {
      const std::uint16_t* truth = volume.cut_of(brick);
      if (!truth || !std::equal(values.begin(), values.end(), truth)) return false;
    }
    return true;
  }
  std::map<std::int32_t, std::vector<std::uint16_t>> cut;
  std::uint64_t ticks = 0, shows = 0, firsts = 0, lasts = 0;
  bool in_order = true, consistent = true;
};

TEST(Mirror, WithoutAThreadComesToTheLoopsStateAndShowsEvery25Milliseconds) {
  const auto scene = test::block_scene();
  DrillingPort port(1000);
  VirtualLoop loop(port, StepState(scene));
  Mirror mirror(StepState(scene), loop.hand_over());
  Sketch picture;
  mirror.add(picture);
  while (loop.run(100) > 0) mirror.pump();
  mirror.finish();
  EXPECT_EQ(mirror.state().hash(), loop.state().hash());
  EXPECT_TRUE(picture.equals(loop.state().volume()));
  EXPECT_GT(picture.cut.size(), 0u);
  EXPECT_TRUE(picture.in_order);
  EXPECT_TRUE(picture.consistent);
  EXPECT_EQ(picture.firsts, 1u);
  EXPECT_EQ(picture.lasts, 1u);
  EXPECT_EQ(picture.shows, 1000 / 25 + 2u);  // one at the start, one at the end
  EXPECT_EQ(mirror.compared(), 1u);
  EXPECT_FALSE(mirror.mismatch());
}

TEST(Mirror, OnItsOwnThreadFollowsTheLiveLoop) {
  const auto scene = test::block_scene();
  DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
  LoopSettings settings;
  settings.ask_realtime = false;
  settings.period = std::chrono::microseconds(500);
  HapticLoop loop(port, StepState(scene), settings);
  Mirror mirror(StepState(scene), loop.hand_over());
  Sketch picture;
  mirror.add(picture);
  mirror.start();
  loop.start();
  ASSERT_TRUE(eventually([&] { return mirror.ticks() > 1000 && mirror.compared() >= 1; }));
  loop.stop();
  mirror.stop();
  EXPECT_EQ(mirror.state().hash(), loop.state().hash());
  EXPECT_TRUE(picture.equals(loop.state().volume()));
  EXPECT_TRUE(picture.in_order);
  EXPECT_TRUE(picture.consistent);
  EXPECT_FALSE(mirror.mismatch());
}

TEST(Mirror, FarBehindItStillShowsTwiceASecondOfTheSession) {
  const auto scene = test::block_scene();
  DrillingPort port(6000);
  VirtualLoop loop(port, StepState(scene));
  Mirror mirror(StepState(scene), loop.hand_over());
  Sketch picture;
  mirror.add(picture);
  ASSERT_EQ(loop.run(6000), 6000u) << "all wait before the mirror begins";
  mirror.start();
  mirror.stop();
  EXPECT_EQ(mirror.state().hash(), loop.state().hash());
  EXPECT_GE(picture.shows, 11u);
  EXPECT_LE(picture.shows, 30u) << "it catches up before it shows more often";
}

TEST(Mirror, ARunThatDiffersIsFoundWithinASecond) {
  const auto scene = test::block_scene();
  auto other = std::make_shared<Scene>(*scene);
  other->full_force_n *= 1.001;  // cuts a little less
  DrillingPort port(1000);
  VirtualLoop loop(port, StepState(scene));
  Mirror mirror(StepState(other), loop.hand_over());
  loop.run(1000);
  mirror.finish();
  ASSERT_TRUE(mirror.mismatch());
  EXPECT_EQ(mirror.mismatch()->tick, 1000u);
  EXPECT_NE(mirror.mismatch()->loop_digest, mirror.mismatch()->mirror_digest);
}

TEST(RunningDigest, SeesOneChangedValueOfOneBrickAfterAtMostOneRound) {
  const auto scene = test::block_scene();
  StepState a(scene), b(scene);
  RunningDigest of_a, of_b;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const StepInput input = quantise(test::drilling_sample(i), 1000, {});
    step(a, input);
    step(b, input);
  }
  const auto bricks = a.volume().cut_bricks();
  ASSERT_GT(bricks.size(), 2u);
  auto& volume = const_cast<Volume&>(b.volume());  // NOLINT: the planted fault that a wrong step would make
  volume.cut_for_writing(bricks[bricks.size() / 2])[7] ^= 1;
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    of_a.add(a, a.last());
    of_b.add(b, b.last());
  }
  EXPECT_NE(of_a.value(), of_b.value());
}

}  // namespace
}  // namespace cusp::test
