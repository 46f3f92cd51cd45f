// The memory of heads' poses as a ring, and the cells of a brick that a search needs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "engine/contact/cavity/cut_memory.h"
#include "engine/contact/features/cells_near.h"
#include "tests/full_run.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

const CutMemory::Sweeper kHead{1, Vec3(0.0, 0.0, 1.0)}, kOtherAxis{1, Vec3(0.0, 0.6, 0.8)};

/// A stroke that bends at every step, over a box of 4 by 4 by 2 mm.
Vec3 stroke(int k) {
  const double a = 0.037 * k, b = 0.0011 * k;
  return {2.0 * std::sin(a) + 0.03 * std::sin(2.9 * k), 2.0 * std::cos(0.71 * b), std::sin(0.3 * b) + 0.02 * std::cos(1.7 * k)};
}
constexpr int kMore = 500;
constexpr int kSteps = static_cast<int>(CutMemory::kSegments) + kMore;

CutMemory filled() {
  CutMemory memory;
  for (int k = 0; k < kSteps; ++k) memory.add(stroke(k), stroke(k + 1), kHead);
  return memory;
}

TEST(CutMemory, when_it_is_full_each_new_segment_takes_the_oldest_ones_place) {
  CutMemory memory;
  for (int k = 0; k < kSteps; ++k) {
    memory.break_path();
    memory.add(stroke(k), stroke(k + 1), kHead);
    ASSERT_EQ(memory.size(), std::min<std::size_t>(static_cast<std::size_t>(k) + 1, CutMemory::kSegments));
  }
  EXPECT_EQ(memory.segment(0).a, stroke(kMore));
  EXPECT_EQ(memory.segment(memory.size() - 1).b, stroke(kSteps));
}

TEST(CutMemory, full_it_finds_what_a_look_at_all_of_it_finds) {
  const CutMemory memory = filled();
  std::mt19937 random(7);
  std::uniform_int_distribution<int> any(0, kSteps);
  std::array<Vec3, CutMemory::kMost> found;
  int none = 0;
  const int looks = full_run() ? 2000 : 500;
  for (int i = 0; i < looks; ++i) {
    const Vec3 y = stroke(any(random)) + Vec3(0.01, 0.0, 0.005);
    std::size_t ends = 0;
    for (std::size_t k = 0; k < memory.size(); ++k) {
      const Vec3 a = memory.segment(k).a, along = memory.segment(k).b - a;
      const double t = std::clamp(glm::dot(y - a, along) / glm::dot(along, along), 0.0, 1.0);
      ends += glm::length(a + along * t - y) < CutMemory::kReachMm - 1e-9;
    }
    const int count = memory.near(y, kHead, found);
    EXPECT_EQ(count > 0, ends > 0) << i;
    none += count == 0;
    for (int k = 0; k < count; ++k) EXPECT_LE(glm::length(found[static_cast<std::size_t>(k)] - y), CutMemory::kReachMm + 1e-9);
  }
  EXPECT_LT(none, looks / 10) << "forgotten places alone";
}

TEST(CutMemory, a_path_is_nearly_straight_while_no_corner_of_it_leaves_the_line_to_its_end) {
  constexpr double kOff = 0.001;
  // An arc of 1 mm: its chord is off by length^2 / 8 mm.
  const auto arc = [](int k) { return Vec3(std::sin(0.005 * k), 1.0 - std::cos(0.005 * k), 0.0); };
  CutMemory memory;
  EXPECT_FALSE(memory.nearly_straight_from(arc(0), kOff)) << "empty";
  for (int k = 0; k < 40; ++k) {
    memory.add(arc(k), arc(k + 1), kHead);
    const double chord = 0.005 * (k + 1), off = chord * chord / 8.0;
    if (std::fabs(off - kOff) < 0.1 * kOff) continue;
    EXPECT_EQ(memory.nearly_straight_from(arc(0), kOff), off < kOff) << k;
  }
  // From within a segment too, and not from beside the path, nor before another way.
  EXPECT_TRUE(memory.nearly_straight_from(0.5 * (arc(38) + arc(39)), kOff));
  EXPECT_FALSE(memory.nearly_straight_from(arc(39) + Vec3(0.0, 0.01, 0.0), kOff));
  memory.break_path();
  memory.add(arc(60), arc(61), kHead);
  EXPECT_FALSE(memory.nearly_straight_from(arc(38), kOff));
}

TEST(CutMemory, what_is_loaded_answers_as_what_was_added) {
  const CutMemory memory = filled();
  std::vector<CutMemory::Segment> all;
  for (std::size_t i = 0; i < memory.size(); ++i) all.push_back(memory.segment(i));
  CutMemory loaded;
  loaded.load(all, memory.open() ? CutMemory::Newest::open : CutMemory::Newest::closed);
  ASSERT_EQ(loaded.size(), memory.size());
  std::mt19937 random(11);
  std::uniform_int_distribution<int> any(0, kSteps);
  std::array<Vec3, CutMemory::kMost> found, again;
  for (int i = 0; i < 500; ++i) {
    const Vec3 y = stroke(any(random));
    const int count = memory.near(y, kHead, found);
    ASSERT_EQ(loaded.near(y, kHead, again), count);
    for (int k = 0; k < count; ++k) EXPECT_EQ(found[static_cast<std::size_t>(k)], again[static_cast<std::size_t>(k)]);
    EXPECT_EQ(memory.near(y, kOtherAxis, again), 0);
  }
}

TEST(CellsNear, no_point_in_reach_lies_in_a_cell_that_is_left_out) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-6.0f, 14.0f), size(0.5f, 7.0f), in_cell(-0.25f, 1.1f), part(-1.0f, 1.0f);
  std::uniform_int_distribution<int> cell(0, 7);
  int inside = 0, left_out = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3f centre(place(random), place(random), place(random));
    const float reach = size(random);
    TwoCylinders shape;
    shape.at = centre;
    shape.axis = glm::normalize(Vec3f(part(random), part(random), part(random)));
    shape.from = part(random);
    shape.wide_from = shape.from + size(random);
    shape.to = shape.wide_from + 3.0f * size(random);
    shape.narrow2 = 0.25f * reach * reach;
    shape.wide2 = reach * reach;
    const CellsNear ball = CellsNear::ball(centre, reach), cylinders = CellsNear::cylinders(shape);
    for (int k = 0; k < 60; ++k) {
      const IVec3 c(cell(random), cell(random), cell(random));
      const Vec3f p = Vec3f(c) + Vec3f(in_cell(random), in_cell(random), in_cell(random));
      const auto has = [&c](const CellsNear& cells) { return (cells.slice[c.z] >> (c.x | c.y << 3) & 1) != 0; };
      if (glm::length(p - centre) <= reach) {
        ++inside;
        ASSERT_TRUE(has(ball)) << i;
      }
      left_out += !has(ball);
      const float x[8] = {p.x}, y[8] = {p.y}, z[8] = {p.z};
      for_inside(x, y, z, 1, CylinderLanes(shape), [&](int) { ASSERT_TRUE(has(cylinders)) << i; });
    }
  }
  EXPECT_GT(inside, 5000);
  EXPECT_GT(left_out, 50000) << "and not all cells are taken";
}

}  // namespace
}  // namespace cusp::test
