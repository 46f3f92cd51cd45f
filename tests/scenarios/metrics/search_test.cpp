// Searches that measurements ask millions of times: each answers bit for bit what the plain way answers.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "scenarios/metrics/near_cache.h"
#include "scenarios/metrics/surface_search.h"
#include "scenarios/metrics/triangle_index.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

struct Draw {
  std::mt19937_64 random;
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  Vec3 place(double reach) { return {operator()(-reach, reach), operator()(-reach, reach), operator()(-reach, reach)}; }
};

/// Triangles of a level floor, where many lie equally near, and of a ragged wall.
std::vector<Triangle> floor_and_wall(Draw& draw) {
  std::vector<Triangle> out;
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 30; ++j) {
      const Vec3 at(0.1 * i - 1.5, 0.1 * j - 1.5, -2.0);
      out.push_back({at, at + Vec3(0.1, 0, 0), at + Vec3(0.1, 0.1, 0)});
      out.push_back({at, at + Vec3(0.1, 0.1, 0), at + Vec3(0, 0.1, 0)});
      out.push_back({Vec3(1.5 + draw(0, 0.1), 0.1 * i, 0.1 * j), Vec3(1.5, 0.1 * i + 0.1, 0.1 * j), Vec3(1.5, 0.1 * i, 0.1 * j + 0.1)});
    }
  return out;
}

TEST(TriangleIndex, AnswersTheLeastDistanceOfAllInWhateverOrder) {
  constexpr std::uint64_t kSeed = 5;
  Draw draw{std::mt19937_64(kSeed)};
  const std::vector<Triangle> all = floor_and_wall(draw);
  std::vector<Triangle> shuffled = all;
  std::ranges::shuffle(shuffled, draw.random);
  const TriangleIndex index(all, 0.2), other(shuffled, 0.05);
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", place " << i);
    const Vec3 p = draw.place(3.0);
    double least = 400.0;
    for (const Triangle& t : all) least = std::min(least, triangle_gap_squared(p, t));
    EXPECT_EQ(index.distance_mm(p, 20.0), std::sqrt(least));
    EXPECT_EQ(other.distance_mm(p, 20.0), std::sqrt(least));
    EXPECT_EQ(index.distance_mm(p, std::sqrt(least) + 0.01), std::sqrt(least)) << "a near bound changes nothing";
    EXPECT_EQ(index.distance_mm(p, 0.25 * std::sqrt(least)), 0.25 * std::sqrt(least)) << "a nearer one is the answer";
  }
}

TEST(NearestVoxel, IsTheDividedOneAtEveryBorderToo) {
  constexpr std::uint64_t kSeed = 6;
  Draw draw{std::mt19937_64(kSeed)};
  Grid grid;
  grid.size = IVec3(100);
  for (const double voxel_mm : {0.1, 0.078125, 0.03}) {
    grid.voxel_mm = voxel_mm;
    grid.origin_mm = draw.place(5.0);
    const NearestVoxel voxels(grid);
    for (int i = 0; i < 20000; ++i) {
      Vec3 p = draw.place(6.0);
      // Half of them on a border between voxels, to the last bits.
      if (i % 2 == 0) p[i / 2 % 3] = grid.origin_mm[i / 2 % 3] + grid.voxel_mm * (i / 6 % 100 - 0.5);
      EXPECT_EQ(voxels.of(p), nearest_voxel(grid, p)) << "seed " << kSeed << ", place " << i;
    }
  }
}

TEST(PlaceCache, AnswersWhatIsAskedNowAfterWhateverWasAskedBefore) {
  constexpr std::uint64_t kSeed = 7;
  Draw draw{std::mt19937_64(kSeed)};
  std::vector<Vec3> places;
  for (int i = 0; i < 400; ++i) places.push_back(draw.place(1.0));
  PlaceCache<Vec3, double, 64> cache;
  int asked = 0;
  const auto sum = [](Vec3 p) { return p.x + 10.0 * p.y + 100.0 * p.z; };
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = places[static_cast<std::size_t>(draw.random() % places.size())];
    for (int again = 0; again < 2; ++again)
      EXPECT_EQ(cache.at(p, [&] { return ++asked, sum(p); }), sum(p)) << "seed " << kSeed;
  }
  EXPECT_LE(asked, 20000) << "the second time nobody is asked";
  // Places that are equal as numbers and differ in a bit are two.
  EXPECT_EQ(cache.at(Vec3(0.0), [] { return 1.0; }), 1.0);
  EXPECT_EQ(cache.at(Vec3(-0.0), [] { return 2.0; }), 2.0);
}

}  // namespace
}  // namespace cusp::test
