// Every field of the state's list is in its hash and in its bytes, and what is restored goes on alike.
#include "engine/step/state_fields.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "engine/tool/heads.h"
#include "engine/volume/fragments.h"
#include "tests/engine/step/cut_along.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// Changes one field of a list, by its place in it.
class ChangeOne {
 public:
  explicit ChangeOne(std::size_t which) : which_(which) {}

  template <class T>
  void operator()(const char* name, T& value) {
    if (!is_next(name)) return;
    if constexpr (std::is_same_v<T, Vec3>) {
      value.y += 1.0;
    } else if constexpr (std::is_floating_point_v<T>) {
      value += T{1};
    } else if constexpr (std::is_same_v<T, bool>) {
      value = !value;
    } else if constexpr (std::is_enum_v<T>) {
      value = static_cast<T>(static_cast<std::underlying_type_t<T>>(value) ^ 1);
    } else {
      value = static_cast<T>(value ^ 1);
    }
  }
  std::size_t size(const char* name, std::size_t now, std::size_t) { return is_next(name) ? now + 1 : now; }
  void cuts(const char* name, Volume& volume) {
    if (!is_next(name)) return;
    const std::int32_t brick = volume.cut_bricks().front();
    ++volume.cut_for_writing(brick)[100];
  }
  void sweeps(const char* name, engine::Sweeps& sweeps, Volume& volume) {
    if (volume.keeps_sweeps() && is_next(name)) sweeps.break_path(), sweeps.add({1, 1, 1}, {1.1, 1, 1}, 0.5);
    if (volume.keeps_sweeps() && is_next("sweeps.ids")) volume.sweeps_for_writing(volume.cut_bricks().front())[100] = 0;
  }
  void refuse() { ADD_FAILURE() << name_; }

  /// Of the field that was changed; empty beyond the last one.
  const std::string& name() const { return name_; }

 private:
  bool is_next(const char* name) {
    if (next_++ != which_) return false;
    name_ = name;
    return true;
  }
  std::size_t which_, next_ = 0;
  std::string name_;
};

VoxelVolume cube_on_a_neck() {
  return from_distance(4.0, 0.1, [](Vec3 p) {
    const double main = box_distance(p - Vec3(-0.9, 0, 0), Vec3(0.7, 1.2, 1.2));
    const double neck = box_distance(p - Vec3(0.2, 0, 0), Vec3(0.6, 0.2, 0.2));
    const double cube = box_distance(p - Vec3(0.9, 0, 0), Vec3(0.4, 0.4, 0.4));
    return std::min(main, std::min(neck, cube));
  });
}

std::shared_ptr<Scene> full_scene(Method method) {
  auto scene = scene_of(cube_on_a_neck(), method, 0.25, 20.0);
  scene->friction = true;
  scene->guard = GuardSettings{};
  scene->phenomena = {Handpiece::turbine, true, true};
  scene->burs.push_back(scene->burs.front());
  scene->burs.back().head = *flat_head(0.2, 0.2, 1.0);
  return scene;
}

/// Slides over the block's top and lifts now and then; the pedal cuts.
StepInput over_the_block(int k) {
  const double a = 0.012 * k;
  const bool lifted = k % 400 > 350;
  StepInput input = input_at({-0.9 + 0.3 * std::sin(a), 0.5 * std::cos(0.7 * a), lifted ? 1.8 : 1.42 - 0.0002 * k});
  input.pedal = lifted ? 0 : 60000;
  return input;
}

/// A state in the middle of everything: a stroke is under way, and a severed cube is leaving with half a name waiting.
StepState busy_state(const std::shared_ptr<const Scene>& scene) {
  StepState state(scene);
  step(state, input_at({-0.9, 0.5, 1.8}));
  EXPECT_TRUE(cut_along(state, 0, {0.14, -0.6, -0.2}, {0.14, 0.6, -0.2}));
  EXPECT_TRUE(cut_along(state, 0, {0.14, -0.6, 0.2}, {0.14, 0.6, 0.2}));
  EXPECT_TRUE(cut_along(state, 1, {-1.2, -0.9, 1.3}, {-1.2, -0.7, 1.3}));
  for (int k = 0; k < 330; ++k) step(state, over_the_block(k));
  const auto names = find_severed_fragments(state.volume(), state.volume().cut_bricks());
  EXPECT_EQ(names.size(), 1u);
  const auto high = static_cast<std::uint16_t>(0x8000u | names.at(0) >> 15);
  const auto low = static_cast<std::uint16_t>(names.at(0) & 0x7fffu);
  int k = 330;
  for (const std::uint16_t half : {high, low, high}) {
    StepInput input = over_the_block(k++);
    input.fragment = half;
    step(state, input);
  }
  return state;
}

class StateFields : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, StateFields,
                         testing::Values(Method::surface, Method::occupancy, Method::occupancy_pivot, Method::ray,
                                         Method::penalty, Method::gradient),
                         [](const auto& i) {
                           std::string name(key_of(i.param));
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

TEST_P(StateFields, hashes_and_saves_every_field_of_the_list) {
  const auto scene = full_scene(GetParam());
  const StepState state = busy_state(scene);
  const std::uint64_t hash = state.hash();
  const std::vector<std::byte> bytes = state.save();
  std::set<std::string> not_hashed, not_saved, fields;
  for (std::size_t i = 0;; ++i) {
    auto changed = StepState::restore(scene, bytes);
    ASSERT_TRUE(changed);
    ChangeOne one(i);
    visit(one, changed->inner());
    if (one.name().empty()) break;
    fields.insert(one.name());
    if (changed->hash() == hash) not_hashed.insert(one.name());
    if (changed->save() == bytes) not_saved.insert(one.name());
  }
  EXPECT_EQ(not_hashed, std::set<std::string>{});
  EXPECT_EQ(not_saved, std::set<std::string>{});
  // What a list has only where there is something: the scene is one that has it.
  EXPECT_TRUE(fields.contains("fragment_removal.entry.voxels"));
  EXPECT_TRUE(fields.contains("phenomena.heat.rise_k"));
  EXPECT_TRUE(fields.contains("volume.cuts"));
  for (const char* name : {"memory.segment.by.axis", "sweeps", "sweeps.ids", "surface.found.centre"})
    EXPECT_EQ(fields.contains(name), GetParam() == Method::surface) << name;
  EXPECT_EQ(fields.contains("surface.resolved"), GetParam() == Method::surface);
}

TEST_P(StateFields, goes_on_alike_for_a_thousand_ticks_once_it_is_restored) {
  const auto scene = full_scene(GetParam());
  StepState whole = busy_state(scene);
  auto restored = StepState::restore(scene, whole.save());
  ASSERT_TRUE(restored);
  EXPECT_EQ(restored->hash(), whole.hash());
  EXPECT_EQ(restored->save(), whole.save());
  for (int k = 333; k < 1333; ++k) {
    step(whole, over_the_block(k));
    step(*restored, over_the_block(k));
    ASSERT_EQ(restored->last().proxy_mm, whole.last().proxy_mm) << k;
    ASSERT_EQ(restored->last().force_n, whole.last().force_n) << k;
    if (k % 100 == 0) {
      ASSERT_EQ(restored->hash(), whole.hash()) << k;
    }
  }
  EXPECT_EQ(restored->save(), whole.save());
}

}  // namespace
}  // namespace cusp::test
