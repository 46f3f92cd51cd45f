#include "scenarios/import/mesh_distance.h"

#include <array>
#include <cmath>

namespace cusp::scenarios {

std::vector<float> mesh_distance(const TriangleMesh& shell, const Grid& grid, const ImportProgress& progress) {
  constexpr float reach = kDistanceReach;
  std::vector<float> out(grid.voxels(), reach * reach);
  const std::size_t some = shell.triangles.size() / 100 + 1;
  std::size_t n = 0;
  for (const auto& t : shell.triangles) {
    if (progress && n++ % some == 0) progress(static_cast<double>(n) / static_cast<double>(shell.triangles.size()));
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = (shell.points[t[i]] - grid.origin_mm) / grid.voxel_mm;
    stamp_triangle(corners, grid, out);
  }
  const std::vector<bool> inside = mesh_inside(shell, grid);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = inside[i] ? -std::sqrt(out[i]) : std::sqrt(out[i]);
  return out;
}

}  // namespace cusp::scenarios
