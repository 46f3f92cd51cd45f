#include "scenarios/import/triangle_distance.h"

#include <algorithm>
#include <cmath>

namespace cusp::scenarios {
namespace {

/// Squared distance of a point to a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
double squared_distance(Vec3 p, const std::array<Vec3, 3>& t) noexcept {
  const auto& [a, b, c] = t;
  const auto to = [&](Vec3 q) { return glm::dot(p - q, p - q); };
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return to(a);
  const Vec3 bp = p - b;
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return to(b);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return d1 == d3 ? to(a) : to(a + d1 / (d1 - d3) * ab);
  const Vec3 cp = p - c;
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return to(c);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return d2 == d6 ? to(a) : to(a + d2 / (d2 - d6) * ac);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double span = (d4 - d3) + (d5 - d6);
    return span == 0.0 ? to(b) : to(b + (d4 - d3) / span * (c - b));
  }
  const double all = va + vb + vc;
  return to(a + vb / all * ab + vc / all * ac);
}

}  // namespace

void stamp_triangle(const std::array<Vec3, 3>& t, const Grid& grid, std::vector<float>& squared) {
  constexpr double reach = kDistanceReach;
  const Vec3 low = glm::min(glm::min(t[0], t[1]), t[2]) - reach;
  const Vec3 high = glm::max(glm::max(t[0], t[1]), t[2]) + reach;
  const IVec3 first = glm::max(IVec3(glm::ceil(glm::max(low, Vec3(-1.0)))), IVec3(0));
  const IVec3 last = glm::min(IVec3(glm::floor(glm::min(high, Vec3(grid.size)))), grid.size - 1);
  Vec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length = std::sqrt(glm::dot(n, n));
  n = length > 0.0 ? n / length : Vec3(0.0);  // a sliver without a plane: every voxel of its box is asked
  for (int z = first.z; z <= last.z; ++z)
    for (int y = first.y; y <= last.y; ++y) {
      // Along the row the plane's distance changes by n.x a voxel: only where it is within reach can the triangle's be.
      const double at_zero = glm::dot(n, Vec3(0.0, y, z) - t[0]);
      int x0 = first.x, x1 = last.x;
      if (std::abs(n.x) > 1e-6) {
        const double p = (-reach - at_zero) / n.x, q = (reach - at_zero) / n.x;
        x0 = std::max(x0, static_cast<int>(std::ceil(std::max(std::min(p, q) - 1e-6, -1.0))));
        x1 = std::min(x1, static_cast<int>(std::floor(std::min(std::max(p, q) + 1e-6, static_cast<double>(grid.size.x)))));
      } else if (std::abs(at_zero) > reach + 1e-3) {
        continue;
      }
      float* row = &squared[grid.index({0, y, z})];
      for (int x = x0; x <= x1; ++x) {
        const double plane = at_zero + n.x * x;
        const double best = static_cast<double>(row[x]);
        if (plane * plane > best) continue;
        const double d = squared_distance(Vec3(x, y, z), t);
        if (d < best) row[x] = static_cast<float>(d);
      }
    }
}

}  // namespace cusp::scenarios
