// The one file that knows OpenVDB; the library holds the instance that it uses.
#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>

#include <mutex>

#include "scenarios/import/mesh_distance.h"

namespace cusp::scenarios {
namespace {

/// Points in voxels from the grid's first. Single precision rounds by 0.0001 voxel at most: max_edge_voxels is 2,048.
std::vector<openvdb::Vec3s> points_in_voxels(const TriangleMesh& mesh, const Grid& grid) {
  std::vector<openvdb::Vec3s> out;
  out.reserve(mesh.points.size());
  for (const Vec3& point : mesh.points) {
    const Vec3 p = (point - grid.origin_mm) / grid.voxel_mm;
    out.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
  }
  return out;
}

std::vector<openvdb::Vec3I> triangles_of(const TriangleMesh& mesh) {
  std::vector<openvdb::Vec3I> out;
  out.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) out.emplace_back(t[0], t[1], t[2]);
  return out;
}

}  // namespace

std::vector<bool> mesh_inside(const TriangleMesh& shell, const Grid& grid) {
  static std::once_flag once;
  std::call_once(once, [] { openvdb::initialize(); });

  // The narrowest band that is not widened by guesses; beyond it the sign is filled in.
  constexpr float band = 2.0f;
  const auto transform = openvdb::math::Transform::createLinearTransform(1.0);
  const std::vector<openvdb::Vec3s> points = points_in_voxels(shell, grid);
  const std::vector<openvdb::Vec3I> triangles = triangles_of(shell);
  const openvdb::tools::QuadAndTriangleDataAdapter<openvdb::Vec3s, openvdb::Vec3I> mesh(points, triangles);
  openvdb::util::NullInterrupter interrupter;
  const openvdb::FloatGrid::Ptr field = openvdb::tools::meshToVolume<openvdb::FloatGrid>(
      interrupter, mesh, *transform, band, band, openvdb::tools::DISABLE_RENORMALIZATION, nullptr);

  std::vector<bool> inside(grid.voxels());
  auto accessor = field->getConstAccessor();
  std::size_t i = 0;
  for (int z = 0; z < grid.size.z; ++z)
    for (int y = 0; y < grid.size.y; ++y)
      for (int x = 0; x < grid.size.x; ++x, ++i) inside[i] = accessor.getValue(openvdb::Coord(x, y, z)) < 0.0f;
  return inside;
}

}  // namespace cusp::scenarios
