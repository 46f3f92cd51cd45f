// The one file that knows OpenVDB (and takes half a minute to compile for it).
#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>

#include <mutex>
#include <vector>

#include "scenarios/import/mesh_distance.h"

namespace cusp {
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

void mesh_distance(const TriangleMesh& mesh, const Grid& grid, const DistanceRow& row) {
  static std::once_flag once;
  std::call_once(once, [] { openvdb::initialize(); });

  const auto transform = openvdb::math::Transform::createLinearTransform(1.0);
  // Renormalising smooths the distances by up to a tenth of a voxel; they are exact without.
  const openvdb::FloatGrid::Ptr field = openvdb::tools::meshToVolume<openvdb::FloatGrid>(
      IndexSpaceMesh{mesh, grid}, *transform, kDistanceReach, kDistanceReach, openvdb::tools::DISABLE_RENORMALIZATION);

  const openvdb::CoordBBox box = field->evalActiveVoxelBoundingBox();
  auto accessor = field->getConstAccessor();
  std::vector<float> values(static_cast<std::size_t>(grid.size.x));
  for (int z = std::max(0, box.min().z()); z <= std::min(grid.size.z - 1, box.max().z()); ++z)
    for (int y = std::max(0, box.min().y()); y <= std::min(grid.size.y - 1, box.max().y()); ++y) {
      for (int x = 0; x < grid.size.x; ++x)
        values[static_cast<std::size_t>(x)] = accessor.getValue(openvdb::Coord(x, y, z));
      row(y, z, values);
    }
}

}  // namespace cusp
