/// Meshes of shapes with a known distance, and the files they are written to. Tests make their own: none is shipped.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::test {

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
/// A prism about the z axis with a regular polygon of `sides` corners at `radius`; either end may be left open.
struct Prism {
  double radius = 1.0, bottom = 0.0, top = 1.0;
  bool open_bottom = false;
  int sides = 64;
  double area() const;  // of the polygon
  double mm3() const { return area() * (top - bottom); }
};
Mesh prism(std::string name, const Prism& shape);
/// Both as one mesh, under the first one's name.
Mesh joined(Mesh a, const Mesh& b);
/// A body without any symmetry: a box of 6 x 4 x 3 mm from (1, 2, -1) on, an off-centre bump of 1.5 x 1 x 1 mm on its upper
/// face and one of 0.5 x 1 x 1.5 mm on its right; no plane and no turn maps it to itself.
inline constexpr double kLopsidedMm3 = 6.0 * 4.0 * 3.0 + 1.5 * 1.0 * 1.0 + 0.5 * 1.0 * 1.5;
/// Whether a place, in mm, is inside.
bool in_lopsided(Vec3 mm);
/// Its whole surface as one closed mesh of squares of half a millimetre.
Mesh lopsided(std::string name);
/// Turned about an axis that is none of the grid's, so that no facet lies along it.
Mesh turned(Mesh mesh);

/// A folder that the test removes.
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
/// OFF, 9 digits.
void write_off(const std::filesystem::path& file, const Mesh& mesh);
void write_text(const std::filesystem::path& file, const std::string& text);
std::string read_text(const std::filesystem::path& file);

}  // namespace cusp::test
