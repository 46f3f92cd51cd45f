#include "scenarios/metrics/target_surface.h"

#include "engine/volume/cut_volume.h"
#include "scenarios/metrics/region_shares.h"

namespace cusp::scenarios {

namespace {

class PatchSink final : public SolidSink {
 public:
  std::vector<SurfacePatch> patches;
  void cell(Vec3, Vec3) override {}
  void box(Vec3, Vec3, Tissue) override {}
  void tetrahedron(const std::array<Vec3, 4>&, double, Tissue) override {}
  void face(const std::array<Vec3, 3>& corners, double mm2, Tissue) override {
    if (mm2 > 0.0) patches.push_back({corners, mm2});
  }
};

void carve_brick(Volume& volume, int brick, const TargetShape& target) {
  const Grid& grid = volume.grid();
  const IVec3 corner = volume.specimen().brick_at(brick) * kBrickEdge;
  std::uint16_t* cut = nullptr;
  for (int o = 0; o < kBrickVoxels; ++o) {
    const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
    const std::uint16_t value = solid_from_distance(-target.distance_mm(grid.centre_mm(v)) / grid.voxel_mm);
    if (value == kSolid) continue;
    if (cut == nullptr) cut = volume.cut_for_writing(brick);
    if (cut == nullptr) return;
    cut[o] = value;
  }
  if (cut != nullptr) volume.touched(brick);
}

}  // namespace

std::vector<SurfacePatch> target_surface(const TargetShape& target, std::shared_ptr<const Specimen> specimen) {
  if (specimen->reading() == Reading::filled) return {};
  const IVec3 bricks = specimen->brick_count();
  const Grid& grid = specimen->grid();
  const double reach = (kBandVoxels + 1.0) * grid.voxel_mm;
  Volume volume(std::move(specimen));
  for (int b = 0; b < bricks.x * bricks.y * bricks.z; ++b) {
    const Vec3 low = grid.centre_mm(volume.specimen().brick_at(b) * kBrickEdge) - reach;
    const Vec3 high = low + kBrickEdge * grid.voxel_mm + 2.0 * reach;
    if (!volume.cuttable(b) || high.z < target.floor_mm() || high.x < target.low().x || high.y < target.low().y ||
        low.x > target.high().x || low.y > target.high().y)
      continue;
    carve_brick(volume, b, target);
  }
  PatchSink sink;
  for (const int brick : bricks_to_measure(volume)) emit_removed(volume, brick, sink);
  return std::move(sink.patches);
}

}  // namespace cusp::scenarios
