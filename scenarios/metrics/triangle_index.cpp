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

double to_box_squared(Vec3 p, Vec3 low, Vec3 high) noexcept { return square(glm::max(glm::max(low - p, p - high), Vec3(0.0))); }

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

TriangleIndex::TriangleIndex(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
  if (!triangles_.empty()) root_ = grow(0, triangles_.size());
}

std::int32_t TriangleIndex::grow(std::size_t first, std::size_t last) {
  Node node{triangles_[first][0], triangles_[first][0], first, last, -1, -1};
  for (std::size_t i = first; i < last; ++i)
    for (const Vec3& p : triangles_[i]) {
      node.low = glm::min(node.low, p);
      node.high = glm::max(node.high, p);
    }
  if (last - first > kLeaf) {
    const Vec3 size = node.high - node.low;
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const auto at = [this](std::size_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t half = first + (last - first) / 2;
    std::nth_element(at(first), at(half), at(last), [axis](const Triangle& a, const Triangle& b) {
      return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis];
    });
    node.left = grow(first, half);
    node.right = grow(half, last);
  }
  nodes_.push_back(node);
  return static_cast<std::int32_t>(nodes_.size()) - 1;
}

double TriangleIndex::distance_mm(Vec3 p, double at_most_mm) const noexcept {
  if (root_ < 0) return at_most_mm;
  double best = at_most_mm * at_most_mm;
  struct Waiting {
    std::int32_t node;
    double gap;
  };
  std::array<Waiting, 64> stack;  // a balanced tree of 2^32 triangles is not deeper than 32
  std::size_t waiting = 0;
  const auto gap_of = [&](std::int32_t node) {
    const Node& n = nodes_[static_cast<std::size_t>(node)];
    return to_box_squared(p, n.low, n.high);
  };
  stack[waiting++] = {root_, gap_of(root_)};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.gap >= best) continue;
    const Node& node = nodes_[static_cast<std::size_t>(next.node)];
    if (node.left < 0) {
      for (std::size_t i = node.first; i < node.last; ++i) best = std::min(best, triangle_gap_squared(p, triangles_[i]));
      continue;
    }
    Waiting a{node.left, gap_of(node.left)}, b{node.right, gap_of(node.right)};
    if (a.gap < b.gap) std::swap(a, b);
    if (a.gap < best) stack[waiting++] = a;
    if (b.gap < best) stack[waiting++] = b;
  }
  return std::sqrt(best);
}

}  // namespace cusp::scenarios
