/// A triangle mesh between its reader and its voxels, and what is asked of it before it may become tissue.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "scenarios/import/import_error.h"

namespace cusp::scenarios {

struct TriangleMesh {
  std::string name;
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices of points, counter-clockwise seen from outside
};

/// Reads with assimp (mesh_assimp.cpp): node transforms applied, faces triangulated, parts of one name joined into one
/// mesh, points of equal coordinates made one. Names come from the mesh, else its node, else the file.
[[nodiscard]] Result<std::vector<TriangleMesh>, ImportFailure> read_meshes(const std::filesystem::path& path);

/// Makes points of equal coordinates one (bit for bit: a gap, however small, stays a gap) and drops triangles that use a
/// point twice.
void weld(TriangleMesh& mesh);

inline Vec3 middle_of(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& t = mesh.triangles[triangle];
  return (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3.0;
}

struct MeshCheck {
  bool closed = true;    // every edge has an even number of triangles
  bool oriented = true;  // and is run through as often one way as the other
  Vec3 bad_edge{0.0};    // middle of the first edge, in the order of points, where one of the two fails
  double volume = 0.0;   // by the divergence theorem, negative when inside out; 0 unless closed and oriented
  double area = 0.0;
  Vec3 low{0.0}, high{0.0};
};
MeshCheck check(const TriangleMesh& mesh);

/// The shells of a closed mesh: triangles that hang together by their points, parted by what they enclose.
struct Shells {
  std::vector<TriangleMesh> solids;    // with a positive volume
  std::vector<TriangleMesh> cavities;  // with a negative one, turned round: hollows within a solid
};
/// In the order of their first points. Shells without a volume are left out. Pre: closed and oriented. A mesh that is
/// inside out as a whole is turned first.
Shells shells_of(const TriangleMesh& mesh);

/// Triangles of shells that are wound against the rest without being hollows: they lie in none of the solids. In order;
/// empty for a sound mesh. Pre: closed and oriented.
std::vector<std::uint32_t> turned_outside(const TriangleMesh& mesh);

}  // namespace cusp::scenarios
