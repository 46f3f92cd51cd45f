#include "engine/contact/point_shell.h"

#include <algorithm>
#include <cmath>

namespace cusp {

namespace {

/// A cube's faces cut into m x m squares and blown up to the sphere; a square's share is its solid angle.
void ball_points(double radius_mm, double spacing_mm, std::vector<PointShell::BallPoint>& out) {
  const double side = std::sqrt(4.0 * 3.14159265358979 / 6.0) * radius_mm;  // of a face's share as a square
  const int m = std::clamp(static_cast<int>(side / spacing_mm + 0.5), 2, 40);
  double sum = 0.0;
  for (int face = 0; face < 6; ++face)
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < m; ++j) {
        const double u = (2.0 * i + 1.0) / m - 1.0;
        const double v = (2.0 * j + 1.0) / m - 1.0;
        const double square = 1.0 + u * u + v * v;
        const double length = std::sqrt(square);
        Vec3 p(0.0);
        p[face % 3] = face < 3 ? 1.0 : -1.0;
        p[(face + 1) % 3] = u;
        p[(face + 2) % 3] = v;
        out.push_back({p / length, 1.0 / (square * length)});
        sum += out.back().share;
      }
  for (PointShell::BallPoint& p : out) p.share /= sum;
}

/// Round the axis: the outline of a square of 8 m points blown up to the circle.
void ring(Vec3 axis, Vec3 a, Vec3 b, double along, double radius, Vec3 normal_along, double outward, double spacing,
          double ball_radius, std::vector<PointShell::HolderPoint>& out) {
  const int m = std::clamp(static_cast<int>(6.2831853 * radius / spacing / 8.0 + 0.5), 1, 16);
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < 2 * m; ++i) {
      double x = 1.0, y = (i + 0.5) / m - 1.0;
      for (int turn = 0; turn < side; ++turn) {
        const double t = x;
        x = -y;
        y = t;
      }
      const Vec3 round = (a * x + b * y) / std::sqrt(x * x + y * y);
      const Vec3 offset = axis * along + round * radius;
      if (glm::dot(offset, offset) <= ball_radius * ball_radius) continue;
      out.push_back({offset, normal_along + round * outward, along});
    }
}

}  // namespace

PointShell shell_of(const Burr& burr, Vec3 axis, double ball_spacing_mm, double holder_spacing_mm) {
  PointShell out;
  ball_points(burr.radius_mm, ball_spacing_mm, out.ball);
  int least = 0;
  for (int i = 1; i < 3; ++i)
    if (std::fabs(axis[i]) < std::fabs(axis[least])) least = i;
  Vec3 a(0.0);
  a[least] = 1.0;
  a -= axis * glm::dot(a, axis);
  a /= std::sqrt(glm::dot(a, a));
  const Vec3 b = glm::cross(axis, a);
  const auto tube = [&](double from, double to, double radius) {
    const int rings = std::max(1, static_cast<int>((to - from) / holder_spacing_mm + 0.5));
    for (int i = 0; i <= rings; ++i)
      ring(axis, a, b, from + (to - from) * i / rings, radius, Vec3(0.0), 1.0, holder_spacing_mm, burr.radius_mm,
           out.holder);
  };
  tube(0.0, burr.neck_length_mm, burr.neck_radius_mm);
  const double wide = burr.shank_radius_mm - burr.neck_radius_mm;
  if (burr.shank_length_mm > 0.0 && wide > 0.0) {
    // The shoulder between neck and shank looks back to the ball.
    const int rings = std::max(1, static_cast<int>(wide / holder_spacing_mm + 0.5));
    for (int i = 1; i <= rings; ++i)
      ring(axis, a, b, burr.neck_length_mm, burr.neck_radius_mm + wide * i / rings, -axis, 0.0, holder_spacing_mm,
           burr.radius_mm, out.holder);
  }
  if (burr.shank_length_mm > 0.0)
    tube(burr.neck_length_mm, burr.neck_length_mm + burr.shank_length_mm, burr.shank_radius_mm);
  return out;
}

}  // namespace cusp
