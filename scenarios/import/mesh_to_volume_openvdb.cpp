// The one file that knows OpenVDB (and takes half a minute to compile for it).
#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>

#include <mutex>

#include "scenarios/import/mesh_distance.h"

namespace cusp::scenarios {
namespace {

/// The mesh as meshToVolume asks for it: points in voxels from the grid's first.
struct IndexSpaceMesh {
  const TriangleMesh& mesh;
  const Grid& grid;

  std::size_t polygonCount() const { return mesh.triangles.size(); }
  std::size_t pointCount() const { return mesh.points.size(); }
  std::size_t vertexCount(std::size_t) const { return 3; }
  void getIndexSpacePoint(std::size_t n, std::size_t v, openvdb::Vec3d& out) const {
    const Vec3 p = (mesh.points[mesh.triangles[n][v]] - grid.origin_mm) / grid.voxel_mm;
    out = {p.x, p.y, p.z};
  }
};

}  // namespace

std::vector<bool> mesh_inside(const TriangleMesh& shell, const Grid& grid) {
  static std::once_flag once;
  std::call_once(once, [] { openvdb::initialize(); });

  // The narrowest band that is not widened by guesses; beyond it the sign is filled in.
  constexpr float band = 2.0f;
  const auto transform = openvdb::math::Transform::createLinearTransform(1.0);
  const openvdb::FloatGrid::Ptr field = openvdb::tools::meshToVolume<openvdb::FloatGrid>(
      IndexSpaceMesh{shell, grid}, *transform, band, band, openvdb::tools::DISABLE_RENORMALIZATION);

  std::vector<bool> inside(grid.voxels());
  auto accessor = field->getConstAccessor();
  std::size_t i = 0;
  for (int z = 0; z < grid.size.z; ++z)
    for (int y = 0; y < grid.size.y; ++y)
      for (int x = 0; x < grid.size.x; ++x, ++i) inside[i] = accessor.getValue(openvdb::Coord(x, y, z)) < 0.0f;
  return inside;
}

}  // namespace cusp::scenarios
