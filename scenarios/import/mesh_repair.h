/// Where a mesh is open, and what can be mended of it.
#pragma once

#include <vector>

#include "scenarios/import/triangle_mesh.h"

namespace cusp::scenarios {

/// One run of edges with nothing on their other side, in the mesh's own lengths.
struct MeshGap {
  std::size_t edges = 0;
  double length = 0.0;        // of all its edges
  Vec3 low{0.0}, high{0.0};   // bounding box
  Vec3 middle() const noexcept { return 0.5 * (low + high); }
  double width() const noexcept { return glm::length(high - low); }
  friend bool operator==(const MeshGap&, const MeshGap&) = default;
};
/// Widest first; of gaps as wide the one whose box comes first. Pre: welded.
std::vector<MeshGap> gaps_of(const TriangleMesh& mesh);

struct MeshRepair {
  std::size_t points_joined = 0, triangles_dropped = 0, triangles_turned = 0, holes_closed = 0;
  double widest_hole = 0.0;
  /// Caps over closed holes: the mesh's last triangles, which the file does not have. Areas in squared lengths of the mesh.
  std::size_t cap_triangles = 0;
  double cap_area = 0.0, largest_cap = 0.0, own_area = 0.0;
};
/// Joins points nearer than a ten-thousandth of the mesh's size, drops triangles that are there twice, winds neighbours
/// alike (the fewer of each component are turned), closes gaps no wider than max_hole with a cone to their middle, and turns
/// shells that are inside out beside the others. Of a closed mesh no point moves. What is still wrong afterwards is left to
/// check(). The same for any order of triangles but for ties.
MeshRepair repair(TriangleMesh& mesh, double max_hole);

}  // namespace cusp::scenarios
