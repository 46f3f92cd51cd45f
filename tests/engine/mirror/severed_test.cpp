// Fragments that a slot severs go at once, in the mirror as in the loop. One thread runs all of it.

#include <gtest/gtest.h>

#include "engine/loop/haptic_loop.h"
#include "engine/mirror/fragment_finder.h"
#include "engine/mirror/mirror.h"
#include "engine/volume/fragments.h"
#include "tests/engine/loop/block_scene.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

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

TEST(SeveredFragments, for_whose_names_the_ring_had_no_room_are_named_by_the_next_search) {
  SeveringPort port(9000);
  VirtualLoop loop(port, StepState(slotted_scene()));
  const auto severed = [&] { return find_severed_fragments(loop.state().volume(), loop.state().volume().cut_bricks()); };
  StepInput input;
  while (loop.run(25) == 25 && severed().empty())
    while (loop.hand_over().inputs.pop(input)) continue;
  ASSERT_FALSE(severed().empty());
  HandOver full(64);
  FragmentFinder finder(full);
  while (full.fragments.push(0)) continue;
  finder.search(loop.state());
  std::uint32_t name = 0;
  while (full.fragments.pop(name)) EXPECT_EQ(name, 0u);
  finder.search(loop.state());
  ASSERT_TRUE(full.fragments.pop(name)) << "the volume has not changed since";
  EXPECT_EQ(name, severed().front());
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
