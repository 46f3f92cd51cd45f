/// Distance to a set of triangles. Millimetres. Immutable; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

using Triangle = std::array<Vec3, 3>;

/// Square of the distance from a place to the nearest place of the triangle. Pre: the triangle has an area.
[[nodiscard]] double triangle_gap_squared(Vec3 p, const Triangle& t) noexcept;

class TriangleIndex {
 public:
  explicit TriangleIndex(std::vector<Triangle> triangles);
  bool empty() const noexcept { return triangles_.empty(); }
  /// At most `at_most_mm`, which is also the answer where there is no triangle.
  double distance_mm(Vec3 p, double at_most_mm) const noexcept;

 private:
  static constexpr std::size_t kLeaf = 8;
  struct Node {
    Vec3 low{0.0}, high{0.0};           // round the triangles below
    std::size_t first = 0, last = 0;    // leaf: in triangles_
    std::int32_t left = -1, right = -1; // branch: in nodes_
  };
  std::int32_t grow(std::size_t first, std::size_t last);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
  std::int32_t root_ = -1;
};

}  // namespace cusp::scenarios
