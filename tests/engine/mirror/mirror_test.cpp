#include "engine/mirror/mirror.h"

#include <gtest/gtest.h>

#include <map>

#include "engine/loop/haptic_loop.h"
#include "engine/mirror/fragment_finder.h"
#include "engine/volume/fragments.h"
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

/// Mills a slot along y through the whole block, at x = 1.2: the part beyond it is severed.
class SeveringPort final : public DrillingPort {
 public:
  explicit SeveringPort(std::uint64_t ticks) : DrillingPort(ticks), end_(ticks) {}
  Sample wait(std::chrono::steady_clock::time_point) noexcept override {
    Sample sample;
    if (at_ >= end_) return sample;
    const double t = static_cast<double>(at_++) * 1e-3;
    const double pass = std::fmod(t, 1.2) / 1.2;
    sample.status = Sample::Status::fresh;
    sample.position_mm = {1.2, pass < 0.5 ? 10.0 * pass - 2.5 : 7.5 - 10.0 * pass, 0.4 - 0.45 * t};
    sample.buttons = StepInput::kCut;
    return sample;
  }

 private:
  std::uint64_t at_ = 0, end_;
};

std::shared_ptr<const Scene> slotted_scene() {
  auto scene = std::make_shared<Scene>(*test::block_scene());
  scene->tissues[index_of(Tissue::plastic)].speed_mm_s = 40.0;
  scene->full_force_n = 0.2;
  return scene;
}
bool anything_beyond(const Volume& volume, double x_mm) {
  const Grid& grid = volume.grid();
  IVec3 v;
  for (v.z = 0; v.z < grid.size.z; ++v.z)
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x)
        if (volume.occupied(v) && grid.centre_mm(v).x > x_mm) return true;
  return false;
}

TEST(SeveredFragments, what_is_milled_off_a_block_goes_within_100_ms_and_in_the_mirror_alike) {
  const auto scene = slotted_scene();
  SeveringPort port(9000);
  VirtualLoop loop(port, StepState(scene));
  Mirror mirror(StepState(scene), loop.hand_over());
  FragmentFinder finder(loop.hand_over());
  mirror.add(finder);
  std::uint64_t severed_at = 0, gone_at = 0;
  while (loop.run(5) == 5 && gone_at == 0) {
    mirror.pump();
    const Volume& volume = loop.state().volume();
    if (severed_at == 0 && !find_severed_fragments(volume, volume.cut_bricks()).empty()) severed_at = loop.state().last().tick;
    if (severed_at != 0 && !anything_beyond(volume, 1.65)) gone_at = loop.state().last().tick;
  }
  mirror.finish();
  ASSERT_GT(severed_at, 0u) << "the slot never went through";
  ASSERT_GT(gone_at, 0u) << "the fragment is still there";
  EXPECT_LT(gone_at - severed_at, 100u);
  EXPECT_EQ(mirror.state().hash(), loop.state().hash());
  EXPECT_FALSE(mirror.mismatch());
}

TEST(SeveredFragments, without_a_mirror_the_same_inputs_give_the_same_record) {
  std::uint64_t hash[2];
  for (std::uint64_t& h : hash) {
    SeveringPort port(6000);
    VirtualLoop loop(port, StepState(slotted_scene()));
    FragmentFinder finder(loop.hand_over());
    while (loop.run(25) == 25) {
      finder.search(loop.state());
      StepInput input;
      while (loop.hand_over().inputs.pop(input)) {
      }
    }
    h = loop.state().hash();
    EXPECT_FALSE(anything_beyond(loop.state().volume(), 1.65));
  }
  EXPECT_EQ(hash[0], hash[1]);
}

}  // namespace
}  // namespace cusp::test
