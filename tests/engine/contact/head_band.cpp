// The band of a head against its exact distance: what it leaves out cannot hold the head off.
#include "engine/contact/features/head_band.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/engine/tool/heads.h"

namespace cusp::test {
namespace {

constexpr double kBandSlackMm = 0.01, kBandSideMm = 0.06, kBandVoxelMm = 0.08;

/// Points in voxels about a pivot, laid out as a band reads them.
struct BandPoints {
  std::vector<float> x, y, z;
  void add(Vec3 mm) {
    x.push_back(static_cast<float>(mm.x / kBandVoxelMm));
    y.push_back(static_cast<float>(mm.y / kBandVoxelMm));
    z.push_back(static_cast<float>(mm.z / kBandVoxelMm));
  }
  Vec3 operator[](std::size_t i) const { return Vec3(x[i], y[i], z[i]) * kBandVoxelMm; }
  /// 0: left out, 1: only for what is no surface, 2: for all.
  std::vector<int> by(const HeadBand& band) const {
    std::vector<int> out(x.size(), 0);
    std::vector<float> px = x, py = y, pz = z;
    for (std::vector<float>* p : {&px, &py, &pz}) p->resize(p->size() + 7, 0.0f);
    for_band(px.data(), py.data(), pz.data(), static_cast<int>(x.size()), band,
             [&](int i, bool surface) { out[static_cast<std::size_t>(i)] = surface ? 2 : 1; });
    return out;
  }
};

TEST(HeadBand, has_every_place_within_slack_and_side_and_few_beyond) {
  Random random(5);
  for (const Bur& bur : all_shapes()) {
    const Vec3 axis = glm::normalize(Vec3(0.2, -0.3, 0.9));
    BandPoints points;
    for (int i = 0; i < 4001; ++i) points.add(3.0 * bur.head.reach() * random.vector());
    const std::vector<int> found = points.by({bur.head, axis, kBandSlackMm, kBandSideMm, 1.0 / kBandVoxelMm});
    int beyond = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double distance = head_distance(bur, axis, points[i]);
      EXPECT_TRUE(found[i] > 0 || distance > kBandSlackMm + kBandSideMm) << bur.name << " " << distance;
      // A corner of two lines is further off than its lines are.
      beyond += distance > 1.5 * (kBandSlackMm + kBandSideMm) + Profile::kOffArcMm && found[i] > 0 ? 1 : 0;
    }
    EXPECT_LT(beyond, 8) << bur.name;
  }
}

TEST(HeadBand, has_the_point_of_every_plane_on_which_the_head_stands) {
  Random random(6);
  int narrower = 0, all = 0;
  for (const Bur& bur : all_shapes()) {
    const Vec3 axis = glm::normalize(Vec3(-0.5, 0.1, 0.6));
    BandPoints points;
    for (int i = 0; i < 4000; ++i) {
      const Vec3 normal = random.direction();
      const Vec3 foot = head_furthest(bur, axis, -normal);
      const Vec3 sideways = glm::cross(normal, random.direction());
      points.add(foot - normal * (kBandSlackMm * std::fabs(random())) + sideways * kBandSideMm);
    }
    const HeadBand band(bur.head, axis, kBandSlackMm, kBandSideMm, 1.0 / kBandVoxelMm);
    for (const int found : points.by(band)) EXPECT_EQ(found, 2) << bur.name;
    narrower += band.narrow < 0.5f * band.wide ? 1 : 0;
    ++all;
  }
  EXPECT_GT(2 * narrower, all) << "most heads are blunt enough to gain by it";
}

}  // namespace
}  // namespace cusp::test
