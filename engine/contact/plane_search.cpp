#include "engine/contact/plane_search.h"

#include <cmath>

namespace cusp {

namespace {

/// r = (N^T N)^-1 N^T n for up to three active normals; z = n - N r, the part of n that no active plane holds.
struct Split {
  double r[3] = {0, 0, 0};
  Vec3 z{0.0};
};

Split split(const Vec3* normals, int count, Vec3 n) noexcept {
  Split out;
  if (count == 0) {
    out.z = n;
    return out;
  }
  const double b0 = glm::dot(normals[0], n);
  if (count == 1) {
    out.r[0] = b0;
    out.z = n - normals[0] * b0;
    return out;
  }
  const double b1 = glm::dot(normals[1], n);
  const double g01 = glm::dot(normals[0], normals[1]);
  if (count == 2) {
    const double det = 1.0 - g01 * g01;
    out.r[0] = (b0 - g01 * b1) / det;
    out.r[1] = (b1 - g01 * b0) / det;
    out.z = n - normals[0] * out.r[0] - normals[1] * out.r[1];
    return out;
  }
  // Three independent normals span the space: solve by cross products, nothing is left over.
  const Vec3 c12 = glm::cross(normals[1], normals[2]);
  const Vec3 c20 = glm::cross(normals[2], normals[0]);
  const Vec3 c01 = glm::cross(normals[0], normals[1]);
  const double det = glm::dot(normals[0], c12);
  out.r[0] = glm::dot(n, c12) / det;
  out.r[1] = glm::dot(n, c20) / det;
  out.r[2] = glm::dot(n, c01) / det;
  return out;
}

/// Independence of a new normal from the active ones: squared sine of the angle to their span.
/// 1e-10 for a pair and 1e-14 for a triple: larger bounds reject neighbouring planes of a smooth surface.
constexpr double kPair = 1e-10;
constexpr double kTriple = 1e-14;

}  // namespace

PlaneSearch closest_point(Vec3 q, std::span<const Plane> planes, double tolerance_mm) noexcept {
  PlaneSearch out;
  out.y = q;
  Vec3 normal[3];
  const int n_planes = static_cast<int>(planes.size());
  for (int round = 0; round < 48; ++round) {
    int worst = -1;
    double most = -tolerance_mm;
    for (int i = 0; i < n_planes; ++i) {
      const Plane& p = planes[static_cast<std::size_t>(i)];
      const double slack = p.n.x * out.y.x + p.n.y * out.y.y + p.n.z * out.y.z - p.c;
      if (slack < most) {
        bool is_active = false;
        for (int a = 0; a < out.active; ++a) is_active = is_active || out.index[a] == i;
        if (is_active) continue;
        most = slack;
        worst = i;
      }
    }
    if (worst < 0) return out;

    const Plane& add = planes[static_cast<std::size_t>(worst)];
    double gained = 0.0;
    for (int inner = 0; inner < 4; ++inner) {
      const Split s = split(normal, out.active, add.n);
      const double room = glm::dot(s.z, s.z);
      const bool dependent = out.active == 3 || room < (out.active == 2 ? kTriple : kPair);
      // Longest step that keeps every multiplier from turning negative.
      int drop = -1;
      double t_drop = 0.0;
      for (int a = 0; a < out.active; ++a) {
        if (s.r[a] > 1e-12) {
          const double t = out.weight[a] / s.r[a];
          if (drop < 0 || t < t_drop) {
            drop = a;
            t_drop = t;
          }
        }
      }
      if (dependent && drop < 0) {
        out.feasible = false;
        return out;
      }
      const double slack = glm::dot(add.n, out.y) - add.c;
      const double t_full = dependent ? 0.0 : -slack / room;
      const bool full = !dependent && (drop < 0 || t_full <= t_drop);
      const double t = full ? t_full : t_drop;
      if (!dependent) out.y += s.z * t;
      for (int a = 0; a < out.active; ++a) out.weight[a] -= t * s.r[a];
      gained += t;
      if (full) {
        normal[out.active] = add.n;
        out.index[out.active] = worst;
        out.weight[out.active] = gained;
        ++out.active;
        break;
      }
      for (int a = drop; a + 1 < out.active; ++a) {
        normal[a] = normal[a + 1];
        out.index[a] = out.index[a + 1];
        out.weight[a] = out.weight[a + 1];
      }
      --out.active;
    }
  }
  out.feasible = false;
  return out;
}

}  // namespace cusp
