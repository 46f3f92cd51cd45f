#include "scenarios/metrics/patch_faces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/volume/cut_volume.h"
#include "scenarios/metrics/region_shares.h"
#include "scenarios/metrics/surface_search.h"

namespace cusp::scenarios {

namespace {

class KeptFaces final : public SolidSink {
 public:
  explicit KeptFaces(IsKept is_kept) : is_kept_(std::move(is_kept)) {}
  std::vector<Triangle> kept;
  void cell(Vec3, Vec3) override {}
  void box(Vec3, Vec3, Tissue) override {}
  void tetrahedron(const std::array<Vec3, 4>&, double, Tissue) override {}
  void face(const Triangle& corners, double, Tissue tissue) override {
    if (is_kept_(corners, tissue)) kept.push_back(corners);
  }

 private:
  IsKept is_kept_;
};

/// Bricks whose cells may have a face of these voxels, ascending.
std::vector<int> bricks_about(const Specimen& specimen, const std::vector<IVec3>& voxels) {
  std::vector<int> out;
  for (const IVec3 v : voxels)
    for (int i = 0; i < 8; ++i) {
      const IVec3 at = v + IVec3(i & 1 ? 1 : -2, i >> 1 & 1 ? 1 : -2, i >> 2 ? 1 : -2);
      const int brick = specimen.brick_index(IVec3(at.x >> 3, at.y >> 3, at.z >> 3));
      if (brick >= 0 && (out.empty() || out.back() != brick)) out.push_back(brick);
    }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace

std::optional<IVec3> voxel_under(const Volume& volume, const Triangle& t) noexcept {
  const Grid& grid = volume.grid();
  const Vec3 cross = glm::cross(t[1] - t[0], t[2] - t[0]), at = middle_of(t);
  const double length = std::sqrt(glm::dot(cross, cross));
  if (!(length > 0.0)) return std::nullopt;
  for (const double voxels : {0.0, 0.5, -0.5, 1.0, -1.0}) {
    const IVec3 v = nearest_voxel(grid, at + voxels * grid.voxel_mm / length * cross);
    if (volume.occupied(v)) return v;
  }
  return std::nullopt;
}

std::vector<Triangle> cut_where(const Volume& volume, const IsKept& is_kept) {
  KeptFaces sink(is_kept);
  for (const int brick : bricks_to_measure(volume)) emit_removed(volume, brick, sink);
  return std::move(sink.kept);
}

std::vector<Triangle> standing_where(const Volume& volume, const IsKept& is_kept) {
  const Grid& grid = volume.grid();
  KeptFaces sink([&](const Triangle& t, Tissue tissue) {
    const Vec3 cross = glm::cross(t[1] - t[0], t[2] - t[0]), at = middle_of(t);
    const double length = glm::length(cross);
    if (!(length > 0.0) || !is_kept(t, tissue)) return false;
    const auto solid = [&](double mm) { return volume.occupied(IVec3(glm::floor((at + mm / length * cross - grid.origin_mm) / grid.voxel_mm + 0.5))); };
    return solid(grid.voxel_mm) || solid(-grid.voxel_mm);  // whichever side is within
  });
  const Specimen& specimen = volume.specimen();
  const IVec3 bricks = specimen.brick_count();
  for (int b = 0; b < bricks.x * bricks.y * bricks.z; ++b) emit_specimen(specimen, b, sink);
  return std::move(sink.kept);
}

std::vector<Triangle> surface_of(const Volume& volume, const std::vector<IVec3>& voxels) {
  const VoxelSet set(volume.grid(), voxels);
  KeptFaces sink([&](const Triangle& t, Tissue) { return set.has(voxel_under(volume, t)); });
  for (const int brick : bricks_about(volume.specimen(), voxels)) {
    emit_removed(volume, brick, sink);
    emit_specimen(volume.specimen(), brick, sink);
  }
  return std::move(sink.kept);
}

std::vector<IVec3> top_above(const Volume& volume, const std::vector<IVec3>& voxels) {
  std::vector<IVec3> out;
  for (IVec3 v : voxels) {
    while (volume.occupied(v + IVec3(0, 0, 1))) ++v.z;
    out.push_back(v);
  }
  const auto order = [](IVec3 v) { return std::array{v.z, v.y, v.x}; };
  std::ranges::sort(out, {}, order);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace cusp::scenarios
