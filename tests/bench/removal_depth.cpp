// The paper's figure 15: a perforation through three materials.
#include <algorithm>
#include <cmath>

#include "tests/bench/motions.h"
#include "tests/bench/removal.h"
#include "tests/bench/tasks.h"
#include "tests/engine/volume/carved.h"

namespace cusp::bench {

namespace {

constexpr double kAheadMm = 0.3;      // of the device point ahead of the bur: full wear
constexpr double kDepthVoxelMm = 10.0 / 128;
constexpr double kEndMm = 9.6;        // before the bur leaves the block

/// A cube of 10 mm, dentine over bone over enamel, its top at z = 0.
std::shared_ptr<Scene> layered_scene(Method method) {
  constexpr int kPadding = 4, kVoxels = 128;
  constexpr int n = kVoxels + 2 * kPadding;
  const Grid grid{IVec3(n), kDepthVoxelMm, {-0.5 * (n - 1) * kDepthVoxelMm, -0.5 * (n - 1) * kDepthVoxelMm, (0.5 - kVoxels - kPadding) * kDepthVoxelMm}};
  const auto cube = [](Vec3 p) { return std::max({std::fabs(p.x) - 5.0, std::fabs(p.y) - 5.0, p.z, -10.0 - p.z}); };
  const auto tissue = [](Vec3 p) {
    return kRemovalMaterials[static_cast<std::size_t>(std::clamp(-p.z / kLayerMm, 0.0, 2.999))].tissue;
  };
  auto scene = std::make_shared<Scene>();
  scene->method = method;
  scene->specimen = carved::specimen(grid, reading_of(method), cube, tissue);
  Bur bur;
  bur.name = "bench";
  bur.radius_mm = kDepthBurMm;
  bur.neck_radius_mm = bur.shank_radius_mm = 0.4 * kDepthBurMm;
  bur.neck_length_mm = 12.0;
  scene->burs = {bur};
  for (const RemovalTissue& m : kRemovalMaterials) scene->tissues[index_of(m.tissue)] = {1.0, m.speed_mm_s};
  scene->full_force_n = kFullForceN;
  scene->guard = unguarded();
  return scene;
}

}  // namespace

void add_depths(Method method, std::vector<Row>& rows) {
  StepState state(layered_scene(method));
  const Vec3 off{0.0137, -0.0211, 0.0};  // off the grid's own lines
  const auto at = [&](double z) { return input_at(off + Vec3(0.0, 0.0, z), Button::down); };
  lead(state, step, off + Vec3(0.0, 0.0, kDepthBurMm + 0.5), 0.05);
  lead(state, step, off + Vec3(0.0, 0.0, kDepthBurMm - 0.1), 0.02);
  StepOutput out = state.last();
  const auto each = static_cast<int>(kSampleS * 1000.0 + 0.5);
  double depth = kDepthBurMm - out.proxy_mm.z;
  for (int k = 0; depth < kEndMm && k < 40000; ++k) {
    if (k % each == 0) {
      Row& row = rows.emplace_back();
      row.method = key_of(method);
      row.measure = "depth";
      const auto layer = static_cast<std::size_t>(std::clamp(depth / kLayerMm, 0.0, 2.999));
      row.tissue = kRemovalTissues[layer];
      row.target_mm_s = kRemovalMaterials[layer].speed_mm_s;
      row.bur_radius_mm = kDepthBurMm;
      row.voxel_mm = kDepthVoxelMm;
      row.time_s = k * 1e-3;
      row.depth_mm = depth;
    }
    out = step(state, at(out.proxy_mm.z - kAheadMm));
    depth = kDepthBurMm - out.proxy_mm.z;
  }
}

}  // namespace cusp::bench
