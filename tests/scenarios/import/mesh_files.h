/// Meshes of shapes with a known distance, and the files they are written to. Tests make their own: none is shipped.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::testing {

struct Mesh {
  std::string name;
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise seen from outside
};

/// An icosahedron split `level` times, its points on the sphere: 20 * 4^level triangles.
Mesh sphere(std::string name, Vec3 centre, double radius, int level);
/// Axis z, tube radius `tube`; `n` segments each way.
Mesh torus(std::string name, Vec3 centre, double ring, double tube, int n);
/// All points within `round` of the box of half extents `core`; 2^level steps along each octant and quarter.
Mesh rounded_box(std::string name, Vec3 centre, Vec3 core, double round, int level);
Mesh inside_out(Mesh mesh);
/// Turned about an axis that is none of the grid's, so that no facet lies along it.
Mesh turned(Mesh mesh);

/// A folder that is gone with the test.
class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// OBJ, one group a mesh, 9 digits.
void write_obj(const std::filesystem::path& file, const std::vector<Mesh>& meshes);
/// ASCII STL: triangles that know nothing of each other.
void write_stl(const std::filesystem::path& file, const Mesh& mesh);
void write_text(const std::filesystem::path& file, const std::string& text);
std::string read_text(const std::filesystem::path& file);

}  // namespace cusp::testing
