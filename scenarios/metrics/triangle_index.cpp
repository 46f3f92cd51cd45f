#include "scenarios/metrics/triangle_index.h"

#include <algorithm>
#include <cmath>

namespace cusp::scenarios {

namespace {

double square(Vec3 v) noexcept { return glm::dot(v, v); }

double edge_gap_squared(Vec3 p, Vec3 a, Vec3 b) noexcept {
  const Vec3 ab = b - a;
  const double length = square(ab);
  const double t = length > 0.0 ? std::clamp(glm::dot(p - a, ab) / length, 0.0, 1.0) : 0.0;
  return square(p - (a + t * ab));
}

}  // namespace

double triangle_gap_squared(Vec3 p, const Triangle& t) noexcept {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], normal = glm::cross(ab, ac), off = p - t[0];
  const double area = square(normal);
  if (area > 0.0) {
    // Over the triangle the plane is the nearest.
    const double u = glm::dot(glm::cross(off, ac), normal), v = glm::dot(glm::cross(ab, off), normal);
    if (u >= 0.0 && v >= 0.0 && u + v <= area) {
      const double height = glm::dot(off, normal);
      return height * height / area;
    }
  }
  return std::min({edge_gap_squared(p, t[0], t[1]), edge_gap_squared(p, t[1], t[2]), edge_gap_squared(p, t[2], t[0])});
}

TriangleIndex::TriangleIndex(std::vector<Triangle> triangles, double together_mm) : triangles_(std::move(triangles)) {
  constexpr std::size_t kMostTogether = 8;
  constexpr double kRoundingMm = 1e-9;  // a box is never further off than its triangles, as they are computed
  std::vector<BoxTree::Leaf> leaves;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const auto& [a, b, c] = triangles_[i];
    const Vec3 low = glm::min(glm::min(a, b), c) - kRoundingMm, high = glm::max(glm::max(a, b), c) + kRoundingMm;
    if (!leaves.empty() && i - leaves.back().first < kMostTogether) {
      BoxTree::Leaf& last = leaves.back();
      const Vec3 both_low = glm::min(last.low, low), both_high = glm::max(last.high, high);
      if (glm::all(glm::lessThanEqual(both_high - both_low, Vec3(together_mm)))) {
        last = {both_low, both_high, last.first, i + 1};
        continue;
      }
    }
    leaves.push_back({low, high, i, i + 1});
  }
  tree_ = BoxTree(std::move(leaves));
}

double TriangleIndex::distance_mm(Vec3 p, double at_most_mm) const noexcept {
  if (triangles_.empty()) return at_most_mm;
  return std::sqrt(tree_.nearest_squared(p, at_most_mm * at_most_mm, [&](std::size_t i, double) { return triangle_gap_squared(p, triangles_[i]); }));
}

}  // namespace cusp::scenarios
