// The store of balls' sweeps, and what a cell makes of those that its voxels name, against the swept balls themselves.
#include "engine/contact/cavity/sweeps.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "engine/contact/cavity/cavity_walls.h"
#include "engine/removal/carve.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

constexpr double kSweptMm = 0.4;

/// A hand's way: rows over a floor, trembling, a tick each.
Vec3 hand(int k) {
  const double along = 0.005 * (k % 400), row = 0.12 * (k / 400);
  return {k / 400 % 2 == 0 ? along : 2.0 - along, row + 0.03 * std::sin(0.31 * k), 0.02 * std::sin(0.23 * k + 1.0)};
}
constexpr int kHandTicks = 2000;

Sweeps hand_sweeps(int ticks = kHandTicks) {
  Sweeps sweeps(Vec3(1.0, 0.3, 0.0), 10000);
  for (int k = 0; k < ticks; ++k) sweeps.add(hand(k), hand(k + 1), kSweptMm);
  return sweeps;
}

double length_to(const Sweep& s, Vec3 p) { return length(s.nearest_on(p) - p); }

/// How deep a place lies in all that is swept; positive in the void.
double depth(const Sweeps& sweeps, Vec3 p) {
  double deepest = -1e300;
  for (std::int32_t id = 0; id < sweeps.size(); ++id)
    if (!sweeps.gap(id)) deepest = std::max(deepest, sweeps[id].radius_mm - length_to(sweeps[id], p));
  return deepest;
}

TEST(Sweeps, no_place_of_the_way_is_further_than_a_tenth_of_a_micrometre_from_the_stored_one) {
  const Sweeps sweeps = hand_sweeps();
  EXPECT_LT(sweeps.size(), kHandTicks);
  for (int k = 0; k <= kHandTicks; ++k) EXPECT_GT(depth(sweeps, hand(k)), kSweptMm - 1e-4) << k;
}

TEST(Sweeps, drop_unmarked_keeps_the_marked_ones_and_what_lies_beside_them_on_their_ways) {
  Sweeps sweeps(Vec3(1.0, 0.3, 0.0), 10000);
  std::mt19937 random(5);
  for (int k = 0; k < kHandTicks; ++k) {
    if (k % 97 == 0) sweeps.break_path();
    sweeps.add(hand(k), hand(k + 1), k % 388 < 200 ? kSweptMm : 0.3);
  }
  for (int round = 0; round < 20; ++round) {
    const std::vector<std::byte> before = sweeps.save();
    Sweeps fewer(Vec3(1.0, 0.3, 0.0), 10000);
    ASSERT_TRUE(fewer.load(before));
    fewer.clear_marks();
    std::vector<std::int32_t> marked;
    for (int k = 0; k < 1 + 3 * round; ++k) {
      const auto id = static_cast<std::int32_t>(random() % static_cast<unsigned>(sweeps.size()));
      if (sweeps.gap(id)) continue;
      marked.push_back(id);
      fewer.mark(id);
    }
    fewer.drop_unmarked();
    EXPECT_LT(fewer.size(), sweeps.size());
    for (const std::int32_t id : marked) {
      const SweepRun was = sweeps.about(id, Sweeps::kBeside, Sweeps::kBeside);
      for (std::int32_t near = was.from; near <= was.to; ++near) {
        const Sweep a = sweeps[near], b = fewer[fewer.renumbered(near)];
        EXPECT_TRUE(a.a == b.a && a.b == b.b && a.radius_mm == b.radius_mm) << id << " " << near;
      }
      const SweepRun is = fewer.about(fewer.renumbered(id), Sweeps::kBeside, Sweeps::kBeside);
      EXPECT_EQ(is.to - is.from, was.to - was.from) << "one way without a gap";
    }
    Sweeps again(Vec3(1.0, 0.3, 0.0), 10000);
    ASSERT_TRUE(again.load(fewer.save()));
    EXPECT_EQ(again.hash(), fewer.hash());
  }
}

TEST(Sweeps, of_several_runs_all_are_kept_that_are_nearly_as_deep_as_the_deepest) {
  const Sweeps sweeps = hand_sweeps();
  std::mt19937 random(11);
  std::uniform_int_distribution<std::int32_t> any(0, sweeps.size() - 1);
  std::uniform_real_distribution<double> off(-0.5, 0.5);
  constexpr double kWithinMm = 0.05;
  int left_out = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<SweepRun> runs;
    for (int k = 0; k < 1 + i % 7; ++k) runs.push_back(sweeps.about(any(random), 3, 4));
    const Vec3 p = sweeps[runs[0].from].a + Vec3(off(random), off(random), off(random));
    std::vector<Sweeps::Deepest> one, kept(runs.size());
    double most = -1e300;
    for (const SweepRun& run : runs) most = std::max(most, one.emplace_back(sweeps.deepest(run, p)).depth_mm);
    std::erase_if(one, [&](const Sweeps::Deepest& d) { return d.depth_mm < most - kWithinMm - 1e-4; });
    kept.resize(static_cast<std::size_t>(sweeps.deepest_each(runs, p, kWithinMm, kept.data())));
    ASSERT_EQ(kept.size(), one.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
      EXPECT_EQ(kept[k].sweep, one[k].sweep);
      EXPECT_EQ(kept[k].depth_mm, one[k].depth_mm);
      EXPECT_EQ(kept[k].on, one[k].on);
      EXPECT_EQ(kept[k].inwards, one[k].inwards);
    }
    left_out += static_cast<int>(runs.size() - kept.size());
  }
  EXPECT_GT(left_out, 1000);
}

TEST(Sweeps, the_nearest_of_a_run_is_the_nearest_of_all_its_sweeps) {
  const Sweeps sweeps = hand_sweeps();
  std::mt19937 random(5);
  std::uniform_int_distribution<std::int32_t> any(0, sweeps.size() - 1);
  std::uniform_real_distribution<double> off(-0.5, 0.5);
  for (int i = 0; i < 2000; ++i) {
    const SweepRun run = sweeps.about(any(random), 7, 9);
    const Vec3 p = sweeps[run.from].a + Vec3(off(random), off(random), off(random));
    double least = 1e300;
    for (std::int32_t id = run.from; id <= run.to; ++id) least = std::min(least, length_to(sweeps[id], p));
    const Sweeps::Nearest found = sweeps.nearest(run, p);
    EXPECT_NEAR(found.distance_mm, least, 1e-6);
    EXPECT_EQ(sweeps.holds(run, p, 2e-6), kSweptMm - least > 2e-6);
  }
}

TEST(Sweeps, a_way_is_broken_where_it_does_not_go_on_and_a_run_ends_there) {
  Sweeps sweeps(Vec3(0.0), 100);
  EXPECT_EQ(sweeps.add({0, 0, 0}, {0.01, 0, 0}, kSweptMm), 0);
  EXPECT_EQ(sweeps.add({0.01, 0, 0}, {0.02, 0, 0}, kSweptMm), 0) << "lengthened";
  sweeps.seal();
  EXPECT_EQ(sweeps.add({0.02, 0, 0}, {0.03, 0, 0}, kSweptMm), 1);
  EXPECT_EQ(sweeps.add({0.5, 0, 0}, {0.51, 0, 0}, kSweptMm), 3);
  EXPECT_TRUE(sweeps.gap(2));
  EXPECT_EQ(sweeps.about(1, 5, 5).to, 1);
  EXPECT_EQ(sweeps.about(3, 5, 5).from, 3);
  sweeps.break_path();
  EXPECT_EQ(sweeps.add({0.51, 0, 0}, {0.52, 0, 0}, kSweptMm), 5);
  EXPECT_EQ(sweeps.add({0.52, 0, 0}, {0.53, 0, 0}, 0.25), 7) << "another ball";
}

TEST(Sweeps, a_full_store_refuses_and_keeps_what_it_has) {
  Sweeps sweeps(Vec3(0.0), 50);
  std::int32_t last = 0;
  for (int k = 0; k < 200; ++k) {
    sweeps.break_path();
    const std::int32_t id = sweeps.add(hand(k), hand(k + 1), kSweptMm);
    if (id >= 0) last = id;
  }
  EXPECT_LT(last, 50);
  EXPECT_GT(last, 40);
  EXPECT_LT(length(sweeps[0].a - hand(0)), 1e-6);
}

TEST(Sweeps, what_is_loaded_is_what_was_saved_and_goes_on_alike) {
  Sweeps sweeps = hand_sweeps(700), loaded(Vec3(1.0, 0.3, 0.0), 10000);
  ASSERT_TRUE(loaded.load(sweeps.save()));
  EXPECT_EQ(loaded.hash(), sweeps.hash());
  for (int k = 700; k < 900; ++k) {
    ASSERT_EQ(sweeps.add(hand(k), hand(k + 1), kSweptMm),
              loaded.add(hand(k), hand(k + 1), kSweptMm));
    ASSERT_EQ(loaded.hash(), sweeps.hash()) << k;
  }
  EXPECT_EQ(loaded.save(), sweeps.save());
}

TEST(Sweeps, bytes_that_are_no_store_are_refused) {
  const std::vector<std::byte> good = hand_sweeps(50).save();
  Sweeps loaded(Vec3(0.0), 1000);
  for (std::size_t size = 0; size < good.size(); ++size) {
    const std::vector<std::byte> cut(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(loaded.load(cut)) << size;
    EXPECT_EQ(loaded.size(), 0);
  }
  std::vector<std::byte> named = good;
  named.back() = std::byte{7};  // a radius that there is not
  EXPECT_FALSE(loaded.load(named));
  for (const double radius_mm : {0.0, -0.4, 1e9, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    std::vector<std::byte> of_no_bur = good;
    std::memcpy(&of_no_bur[2], &radius_mm, sizeof radius_mm);
    EXPECT_FALSE(loaded.load(of_no_bur)) << radius_mm;
  }
  Sweeps small(Vec3(0.0), 10);
  EXPECT_FALSE(small.load(good));
}

/// A block that the hand above has milled.
class Milled : public testing::Test {
 protected:
  Milled() : volume(carved(1)) {}
  /// By so many sweeps at a time.
  Volume carved(std::int32_t at_once) const {
    Volume out(Specimen::build(from_distance(3.0, kPaperVoxelMm, [](Vec3 p) { return p.z - 0.9; }), Reading::banded));
    out.keep_sweeps();
    for (std::int32_t id = 0; id < sweeps.size(); id += at_once)
      carve_run(out, sweeps, {id, std::min(id + at_once, sweeps.size()) - 1});
    return out;
  }
  Sweeps sweeps = hand_sweeps();
  Volume volume;
};

TEST_F(Milled, is_the_same_of_sweeps_that_are_carved_together) {
  for (const std::int32_t at_once : {2, 5, kMostAtOnce}) {
    const Volume together = carved(at_once);
    ASSERT_EQ(together.cut_bricks().size(), volume.cut_bricks().size());
    int others = 0;
    for (const std::int32_t brick : volume.cut_bricks())
      for (int o = 0; o < kBrickVoxels; ++o) others += volume.cut_in(brick, o) != together.cut_in(brick, o);
    EXPECT_EQ(others, 0) << at_once;
  }
}

TEST_F(Milled, each_voxel_in_the_band_names_its_nearest_sweep) {
  int named = 0;
  for (const std::int32_t brick : volume.cut_bricks()) {
    const IVec3 corner = volume.specimen().brick_at(brick) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; o += 7) {
      const std::uint16_t s = volume.cut_in(brick, o);
      if (s == 0 || s == kSolid) continue;
      const Vec3 p = volume.grid().centre_mm(corner + IVec3(o & 7, o >> 3 & 7, o >> 6));
      const std::int32_t id = volume.sweeps_of(brick)[o];
      ASSERT_GE(id, 0);
      // To a quantum of the field and the rounding of single precision.
      EXPECT_NEAR(kSweptMm - length_to(sweeps[id], p), depth(sweeps, p), 2e-5);
      ++named;
    }
  }
  EXPECT_GT(named, 500);
}

/// A sweep that none of a cell's eight voxels names may take a piece of its surface: 11 um deep at most in the trials of a
/// cavity of two minutes (facts/cavity-trials.md, "node keeps the id, 8 nodes, h").
constexpr double kUnnamedMm = 0.012;

TEST_F(Milled, what_a_cell_names_is_as_deep_as_all_that_is_swept) {
  SweptVoid swept(volume, sweeps);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> x(0.1, 1.9), y(0.0, 0.5);
  double sum = 0.0;
  constexpr int kPlaces = 1000;
  for (int i = 0; i < kPlaces; ++i) {
    // Straight down from inside to the floor.
    Vec3 p(x(random), y(random), 0.0);
    for (int pass = 0; pass < 40; ++pass) p.z -= std::max(0.0, depth(sweeps, p)) * 0.9;
    const SweptRuns& runs = swept.runs_at(volume, p, sweeps.size());
    ASSERT_TRUE(runs.known);
    const double named = sweeps.deepest({runs.run, static_cast<std::size_t>(runs.count)}, p).depth_mm;
    EXPECT_LT(named, depth(sweeps, p) + 1e-6);
    EXPECT_GT(named, depth(sweeps, p) - kUnnamedMm);
    EXPECT_NEAR(swept.about_mm(volume, p), depth(sweeps, p), SweptVoid::kOffMm);
    sum += depth(sweeps, p) - named;
  }
  EXPECT_LT(sum / kPlaces, 2e-4) << "mm";
}

TEST_F(Milled, kept_cells_give_what_new_ones_give_while_the_cutting_goes_on) {
  SweptVoid kept(volume, sweeps);
  std::uniform_real_distribution<double> x(0.1, 1.9), y(0.0, 0.5), z(-0.45, -0.3);
  for (std::int32_t end = sweeps.size() - 40; end <= sweeps.size(); end += 4) {
    SweptVoid made(volume, sweeps);
    std::mt19937 same(33);
    for (int i = 0; i < 300; ++i) {
      const Vec3 p(x(same), y(same), z(same));
      const SweptRuns a = kept.runs_at(volume, p, end), b = made.runs_at(volume, p, end);
      ASSERT_EQ(a.known, b.known);
      ASSERT_EQ(a.count, b.count);
      for (int k = 0; k < a.count; ++k) {
        EXPECT_EQ(a.run[k].from, b.run[k].from);
        EXPECT_EQ(a.run[k].to, b.run[k].to);
      }
    }
  }
}

TEST_F(Milled, constraints_hold_a_ball_off_the_floor_and_off_nothing_else) {
  CavityWalls walls(volume, sweeps);
  std::mt19937 random(13);
  std::uniform_real_distribution<double> x(0.2, 1.8), y(0.0, 0.45);
  constexpr double kBall = 0.25;
  int held = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 at(x(random), y(random), -0.14);
    walls.start({{0, -1}, sweeps.size()});
    walls.build(volume, {at, kBall, 0.05});
    for (const CavityConstraint& c : walls.constraints()) {
      ++held;
      EXPECT_NEAR(length(c.n), 1.0, 1e-9);
      // Its foot is surface, as far from the ball's centre as the constraint says.
      EXPECT_NEAR(depth(sweeps, c.foot), 0.0, kUnnamedMm);
      EXPECT_NEAR(glm::dot(c.n, at) - c.c, length(at - c.foot) - kBall, 1e-9);
    }
  }
  EXPECT_GT(held, 300);
}

}  // namespace
}  // namespace cusp::test
