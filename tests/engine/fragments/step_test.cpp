// Severed fragments in the step: crumbs go with the cut, named fragments within a tenth of a second, in a replay alike.
#include <gtest/gtest.h>

#include "engine/volume/fragments.h"
#include "tests/engine/step/cut_along.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {


/// A thin wall on a base: 0.12 mm of it, on voxels of 0.1 mm, turned so that it lies obliquely to them.
VoxelVolume wall() {
  return from_distance(4.0, 0.1, [](Vec3 p) {
    const double along = (p.x * 0.93 + p.y * 0.37);
    const Vec3 turned(along, p.y * 0.93 - p.x * 0.37, p.z);
    const double thin = box_distance(turned - Vec3(0.0, 0.0, 0.2), Vec3(0.11, 1.4, 1.0));
    const double base = box_distance(turned - Vec3(0.0, 0.0, -1.3), Vec3(1.2, 1.4, 0.6));
    return std::min(thin, base);
  });
}

/// The cutting bur crosses the wall again and again, lower each time.
std::vector<StepInput> wearing_through() {
  std::vector<StepInput> out;
  for (int k = 0; k < 9000; ++k) {
    const double y = 1.1 * std::sin(0.011 * k), x = 0.25 * std::sin(0.0371 * k);
    out.push_back(input_at({x - 0.4 * y, y, 1.6 - 0.00025 * k}, k > 50 ? CutButton::pressed : CutButton::up));
  }
  return out;
}

/// Number of crumbs, by a search of the whole volume.
int crumbs_in(const Volume& volume) {
  int count = 0;
  const IVec3 size = volume.grid().size;
  Crumb crumb;
  IVec3 v;
  for (v.z = 0; v.z < size.z; ++v.z)
    for (v.y = 0; v.y < size.y; ++v.y)
      for (v.x = 0; v.x < size.x; ++v.x)
        if (crumb_at(volume, v, crumb) && crumb.voxel[0] == v) {
          bool first = true;
          for (const IVec3& other : crumb.voxels())
            first = first && !(other.z < v.z || (other.z == v.z && (other.y < v.y || (other.y == v.y && other.x < v.x))));
          count += first ? 1 : 0;
        }
  return count;
}

class EveryMethod : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Fragments, EveryMethod,
                         testing::Values(Method::surface, Method::occupancy, Method::ray, Method::penalty, Method::gradient),
                         [](const auto& i) { return std::string(key_of(i.param)); });

TEST_P(EveryMethod, a_wall_worn_through_leaves_no_floating_crumb) {
  StepState state(scene_of(wall(), GetParam(), 0.25, 6.0));
  approach(state, {0, 0, 2.0}, {0, 0, 1.6});
  int k = 0;
  std::size_t cut = 0;
  for (const StepInput& input : wearing_through()) {
    step(state, input);
    if (++k % 1500 != 0) continue;
    EXPECT_EQ(crumbs_in(state.volume()), 0) << "after " << k << " ticks";
    cut = state.volume().cut_bricks().size();
  }
  EXPECT_GT(cut, 5u) << "the wall was cut";
}

/// A cube of 0.8 mm beside the main block, on a neck that a bur goes through.
VoxelVolume cube_on_a_neck() {
  return from_distance(4.0, 0.1, [](Vec3 p) {
    const double main = box_distance(p - Vec3(-0.9, 0, 0), Vec3(0.7, 1.2, 1.2));
    const double neck = box_distance(p - Vec3(0.2, 0, 0), Vec3(0.6, 0.2, 0.2));
    const double cube = box_distance(p - Vec3(0.9, 0, 0), Vec3(0.4, 0.4, 0.4));
    return std::min(main, std::min(neck, cube));
  });
}
int in_the_cube(const Volume& volume) {
  int count = 0;
  const IVec3 size = volume.grid().size;
  IVec3 v;
  for (v.z = 0; v.z < size.z; ++v.z)
    for (v.y = 0; v.y < size.y; ++v.y)
      for (v.x = 0; v.x < size.x; ++v.x)
        if (volume.occupied(v) && volume.grid().centre_mm(v).x > 0.55) ++count;
  return count;
}

TEST_P(EveryMethod, a_severed_cube_disappears_within_100_ms_and_in_the_replay_alike) {
  const auto scene = scene_of(cube_on_a_neck(), GetParam(), 0.25, 20.0);
  StepState state(scene);
  std::vector<StepInput> record;
  const auto tick = [&](StepInput input) {
    record.push_back(input);
    step(state, input);
  };
  // Through the neck along y, between the block and the cube, low enough to take all of it.
  for (int k = 0; k <= 60; ++k) tick(input_at({0.14, -1.0 + 0.01 * k, 0.05}));
  std::vector<std::uint32_t> names;
  int severed_at = -1, gone_at = -1;
  std::size_t sent = 0;
  for (int k = 0; k < 3000 && gone_at < 0; ++k) {
    const double y = -0.4 + 0.8 * std::min(1.0, k / 400.0), z = 0.2 * std::sin(0.05 * k);
    StepInput input = input_at({0.14, y, z}, CutButton::pressed);
    // As the loop does: a search every 25 ms, then a name in two inputs.
    if (names.empty() && k % 25 == 0) {
      const auto bricks = state.volume().cut_bricks();
      names = find_severed_fragments(state.volume(), bricks);
      if (!names.empty()) severed_at = k;
    }
    if (!names.empty() && sent < 2) {
      input.fragment = sent == 0 ? static_cast<std::uint16_t>(0x8000u | names[0] >> 15) : static_cast<std::uint16_t>(names[0] & 0x7fffu);
      ++sent;
    }
    tick(input);
    if (severed_at >= 0 && in_the_cube(state.volume()) == 0) gone_at = k;
  }
  ASSERT_GE(severed_at, 0) << "the neck was cut through";
  ASSERT_GE(gone_at, 0);
  // At most 25 ms to the search, and as much after it.
  EXPECT_LT(gone_at - severed_at, 75);
  EXPECT_FALSE(state.last().overflow);

  StepState replay(scene);
  for (const StepInput& input : record) step(replay, input);
  EXPECT_EQ(replay.hash(), state.hash());
}

TEST(Fragments, a_state_saved_while_a_fragment_is_removed_goes_on_alike) {
  const auto scene = scene_of(cube_on_a_neck(), Method::surface, 0.3, 20.0);
  StepState state(scene);
  step(state, input_at({0, 0, 3.0}));
  ASSERT_TRUE(cut_along(state, 0, {0.14, -0.6, -0.2}, {0.14, 0.6, -0.2}));
  ASSERT_TRUE(cut_along(state, 0, {0.14, -0.6, 0.2}, {0.14, 0.6, 0.2}));
  const auto bricks = state.volume().cut_bricks();
  const auto names = find_severed_fragments(state.volume(), bricks);
  ASSERT_EQ(names.size(), 1u);
  StepInput first = input_at({0, 0, 3.0}), second = first;
  first.fragment = static_cast<std::uint16_t>(0x8000u | names[0] >> 15);
  second.fragment = static_cast<std::uint16_t>(names[0] & 0x7fffu);
  step(state, first);
  auto half = StepState::restore(scene, state.save());
  ASSERT_TRUE(half);
  step(state, second);
  step(*half, second);
  auto leaving = StepState::restore(scene, state.save());
  ASSERT_TRUE(leaving);
  for (int k = 0; k < 100; ++k)
    for (StepState* s : {&state, &*half, &*leaving}) step(*s, input_at({0, 0, 3.0}));
  EXPECT_EQ(in_the_cube(state.volume()), 0);
  EXPECT_EQ(half->hash(), state.hash());
  EXPECT_EQ(leaving->hash(), state.hash());
}

TEST_P(EveryMethod, an_overhang_that_hangs_on_stays) {
  const auto scene = scene_of(from_distance(4.0, 0.1, [](Vec3 p) { return box_distance(p, Vec3(1.2)); }), GetParam(), 0.3, 8.0);
  StepState state(scene);
  step(state, input_at({0, 0, 3.0}));
  // A slot from the side under the top, open on three sides.
  for (int k = 0; k < 6; ++k)
    ASSERT_TRUE(cut_along(state, 0, {-0.4 + 0.3 * k, -2.0, 0.5}, {-0.4 + 0.3 * k, 2.0, 0.5}));
  EXPECT_TRUE(find_severed_fragments(state.volume(), state.volume().cut_bricks()).empty());
  const Grid& grid = state.volume().grid();
  const Vec3 roof = (Vec3(1.0, 0.0, 1.05) - grid.origin_mm) / grid.voxel_mm + 0.5;
  EXPECT_TRUE(state.volume().occupied(IVec3(glm::floor(roof))));
}

}  // namespace
}  // namespace cusp::test
