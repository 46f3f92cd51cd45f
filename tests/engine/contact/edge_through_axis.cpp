// A head so deep in a block that the block's edge runs through its axis: the flanks on both ways of the edge are opposite, and no
// direction is left between them. One flank's plane holds there, and leads the head out of the block.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/contact/surface_contact.h"
#include "engine/tool/heads.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

constexpr Vec3 kAxis(0.0, 0.0, 1.0), kHalf(1.8, 1.8, 1.4);  // of the head; of the block, mm

TEST(EdgeThroughAxis, leads_a_head_out_of_the_block) {
  auto scene = scene_of(from_distance(5.0, 0.1, [](Vec3 p) { return box_distance(p, kHalf); }), Method::surface, 0.5);
  scene->burs[0].head = flat_head(0.5, 0.5, 2.0).value();
  const Volume volume(scene->specimen);
  CutMemory memory;
  Sweeps sweeps{Vec3(0.0), 0};
  for (const double along : {1e-12, 0.013, 0.05}) {
    SurfaceContact surface(*scene, volume, memory, sweeps);
    // The upper edge along x is half-way up the head, whose pivot is 0.5 mm over its tip.
    const Vec3 pose(along, kHalf.y, kHalf.z - 0.5);
    surface.start_tick({}, SurfaceContact::kExploring);
    const Contact contact = surface.solve(volume, *scene, 0, kAxis, pose, pose + Vec3(0.002, 0.003, 0.005), Vec3(0.0), 0.02, SurfaceContact::kAnyWay);
    EXPECT_TRUE(contact.active > 0 || contact.infeasible || contact.deferred) << along;
    // Measured 0.099 to 0.17 in a tick; 0 where the plane was divided by nothing.
    EXPECT_GT(contact.pose_mm.y - pose.y, 0.05) << along;
    EXPECT_LT(length(contact.pose_mm - pose), 0.5) << along;
    for (int a = 0; a < contact.active; ++a) EXPECT_NEAR(length(contact.normal[a]), 1.0, 1e-6) << along;
    Vec3 out(0.0);
    EXPECT_FALSE(surface.push_out(volume, *scene, 0, kAxis, pose, 0.0001, out)) << "half a millimetre deep, at " << along;
  }
}

}  // namespace
}  // namespace cusp::test
