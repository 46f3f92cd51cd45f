/// Distance to a set of triangles. Millimetres. Immutable; any thread.
#pragma once

#include <array>
#include <vector>

#include "engine/base/vec.h"
#include "scenarios/modules.h"
#include "scenarios/shapes/box_tree.h"

namespace cusp::scenarios {

using Triangle = std::array<Vec3, 3>;

/// Square of the distance from a place to the nearest place of the triangle. Pre: the triangle has an area.
[[nodiscard]] double triangle_gap_squared(Vec3 p, const Triangle& t) noexcept;

class TriangleIndex {
 public:
  /// Triangles that follow each other within boxes of `together_mm` share a leaf: those of a cell of voxels do.
  TriangleIndex(std::vector<Triangle> triangles, double together_mm);
  bool empty() const noexcept { return triangles_.empty(); }
  /// At most `at_most_mm`, which is also the answer where there is no triangle. Else bit for bit the least of all triangles'
  /// distances, in whatever order they were given.
  double distance_mm(Vec3 p, double at_most_mm) const noexcept;

 private:
  std::vector<Triangle> triangles_;
  BoxTree tree_;
};

}  // namespace cusp::scenarios
