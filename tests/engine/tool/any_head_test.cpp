// Every contact method with every shape of head: it rests on a face as deep as the head reaches, feels K times the depth,
// and drills at the tissue's speed.
#include <gtest/gtest.h>

#include "engine/contact/methods/point_shell.h"
#include "engine/contact/methods/trilinear_field.h"
#include "tests/engine/step/scenes.h"
#include "tests/engine/tool/heads.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {


constexpr Method kMethods[] = {Method::occupancy, Method::ray, Method::penalty, Method::gradient, Method::surface};
constexpr double kVoxel = 0.1, kFace = 1.5;

VoxelVolume block() {
  return from_distance(5.0, kVoxel, [](Vec3 p) { return box_distance(p, Vec3(2.5, 2.5, kFace)); });
}

/// The block, built once for all that read it alike.
std::shared_ptr<Scene> scene_with(Method method, const Bur& bur, Vec3 axis) {
  static const auto filled = Specimen::build(block(), Reading::filled), banded = Specimen::build(block(), Reading::banded);
  auto scene = scene_of(from_distance(0.5, kVoxel, [](Vec3) { return -1.0; }), method, bur.radius_mm);
  scene->specimen = reading_of(method) == Reading::filled ? filled : banded;
  scene->burs = {bur};
  scene->burs[0].neck_radius_mm = 0.15;
  scene->burs[0].neck_length_mm = bur.head.high() + 3.0;
  scene->tool_axis = axis;
  return scene;
}

/// What the pose may be off by: the filled methods know the surface to a voxel, and their tool is made of voxels too.
double tolerance_of(Method method) {
  switch (method) {
    case Method::occupancy:
    case Method::ray: return 1.2 * kVoxel;
    case Method::penalty: return 0.5 * kVoxel;  // no point of a shell of a point a voxel stands on a rim
    case Method::gradient: return 0.01;
    default: return 0.003;
  }
}

TEST(AnyHead, stands_on_a_face_on_its_furthest_place) {
  for (const Method method : kMethods)
    for (const Bur& bur : all_shapes())
      for (const Vec3 axis : {Vec3(0, 0, 1), Vec3(0.6, 0, 0.8), Vec3(1, 0, 0)}) {
        StepState state(scene_with(method, bur, axis));
        // Where it stands is over the block's middle: of a flat end or flank, its middle.
        const Vec3 middle = axis * (0.5 * (bur.head.high() + bur.head.low()));
        const Vec3 foot = head_support(bur, axis, Vec3(0, 0, -1), middle);
        const Vec3 at(0.013 - foot.x, 0.027 - foot.y, kFace - foot.z);
        constexpr double kPush = 0.25;
        const StepOutput out = approach(state, at + Vec3(0, 0, 0.2), at - Vec3(0, 0, kPush));
        const std::string what = std::string(key_of(method)) + " " + bur.name + " " + std::to_string(axis.z);
        ASSERT_TRUE(out.contact) << what;
        EXPECT_FALSE(out.shank) << what;
        EXPECT_NEAR(out.proxy_mm.z, at.z, tolerance_of(method)) << what;
        EXPECT_NEAR(out.force_raw_n.z, out.proxy_mm.z - (at.z - kPush), 1e-3) << what << ": 1 N/mm";
      }
}

/// Height of the floor under a place, by the trilinear field.
double floor_at(const Volume& volume, Vec3 at) {
  const TrilinearField field(volume);
  for (double z = at.z; z > -kFace; z -= 0.002)
    if (field.at({at.x, at.y, z}) < 0.0) return z;
  return -kFace;
}

TEST(AnyHead, drills_at_the_tissues_speed_and_takes_away_its_own_shape) {
  for (const Method method : {Method::penalty, Method::gradient, Method::surface})
    for (const Bur& bur : all_shapes()) {
      if (bur.name == "flame") continue;  // its point is thinner than a voxel
      const Vec3 axis(0, 0, 1);
      const auto scene = scene_with(method, bur, axis);
      scene->full_force_n = 0.15;  // full wear at 0.15 mm: the penalty sees no deeper than the band
      StepState state(scene);
      const Vec3 at(0.013, 0.027, kFace + bur.radius_mm);
      constexpr double kPush = 0.2;
      approach(state, at + Vec3(0, 0, 0.2), at - Vec3(0, 0, kPush));
      StepOutput out;
      double first = 0.0;
      constexpr int kTicks = 800;
      for (int i = 0; i < kTicks; ++i) {
        out = step(state, input_at(at - Vec3(0, 0, kPush + 0.001 * i), CutButton::pressed));
        if (i == kTicks / 2) first = floor_at(state.volume(), at);
      }
      const double speed = (first - floor_at(state.volume(), at)) / (0.001 * (kTicks - 1 - kTicks / 2));
      // The surface method carves in sweeps of 0.04 mm; the stroke measured is 0.4 mm.
      EXPECT_NEAR(speed, 1.0, 0.1) << key_of(method) << " " << bur.name;
      EXPECT_FALSE(out.overflow);
      EXPECT_GT(state.volume().cut_bricks().size(), 0u);
    }
}

TEST(AnyHead, voxelised_follows_its_distance) {
  for (const Bur& bur : all_shapes()) {
    const Vec3 axis(0.36, 0.48, 0.8);
    const VoxelTool tool = voxelise(bur, axis, kVoxel);
    std::size_t inside = 0;
    for (int z = -90; z <= 90; ++z)
      for (int y = -60; y <= 60; ++y)
        for (int x = -60; x <= 60; ++x) inside += head_distance(bur, axis, Vec3(x, y, z) * kVoxel) <= 0.0;
    EXPECT_EQ(tool.cutting.size(), inside) << bur.name;
    for (const IVec3& v : tool.holder) EXPECT_GT(head_distance(bur, axis, Vec3(v) * kVoxel), 0.0) << bur.name;
    for (const IVec3& v : tool.cutting)
      EXPECT_LE(std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z))), tool.reach) << bur.name;
  }
}

TEST(AnyHead, has_a_shell_on_its_skin_with_even_shares) {
  for (const Bur& bur : all_shapes()) {
    const Vec3 axis(0.36, 0.48, 0.8);
    const PointShell shell = shell_of(bur, axis, 0.1, 0.2);
    double sum = 0.0;
    Vec3 mean(0.0);
    for (const PointShell::HeadPoint& p : shell.head) {
      EXPECT_NEAR(head_distance(bur, axis, p.offset_mm), 0.0, 1e-9) << bur.name;
      Vec3 gradient;
      head_distance(bur, axis, p.offset_mm + p.out * 0.01, gradient);
      EXPECT_GT(glm::dot(gradient, p.out), 1.0 - 1e-9) << bur.name;
      sum += p.share;
      mean += p.out * p.share;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_LT(length(mean), 0.01) << bur.name << ": the skin is closed";
    for (const PointShell::HolderPoint& p : shell.holder) EXPECT_GT(head_distance(bur, axis, p.offset_mm), 0.0);
  }
}

}  // namespace
}  // namespace cusp::test
