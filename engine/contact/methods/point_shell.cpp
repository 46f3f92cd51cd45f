#include "engine/contact/methods/point_shell.h"

#include <algorithm>
#include <cmath>

#include "engine/tool/swept.h"

namespace cusp::engine {

namespace {

/// A cube's faces cut into m x m squares and blown up to the sphere; a square's share is its solid angle.
void ball_points(double radius_mm, double spacing_mm, std::vector<PointShell::HeadPoint>& out) {
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
        p /= length;
        out.push_back({p * radius_mm, p, 1.0 / (square * length)});
        sum += out.back().share;
      }
  for (PointShell::HeadPoint& p : out) p.share /= sum;
}

/// Calls visit(direction, part of the turn) round the axis: the outline of a square of 8 m points blown up to the circle.
template <class Visit>
void around(Vec3 a, Vec3 b, int m, Visit&& visit) {
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < 2 * m; ++i) {
      double x = 1.0, y = (i + 0.5) / m - 1.0;
      const double square = x * x + y * y;
      for (int turn = 0; turn < side; ++turn) {
        const double t = x;
        x = -y;
        y = t;
      }
      visit((a * x + b * y) / std::sqrt(x * x + y * y), 1.0 / square);
    }
}

/// How many an eighth of a ring takes.
int points_of(double radius, double spacing) {
  return std::clamp(static_cast<int>(6.2831853 * radius / spacing / 8.0 + 0.5), 1, 16);
}

/// An outline's pieces in rings about as wide as the spacing; an arc by its chord, blown up to the circle.
void head_points(const Profile& head, Vec3 axis, Vec3 a, Vec3 b, double spacing,
                 std::vector<PointShell::HeadPoint>& out) {
  double sum = 0.0;
  for (int i = 0; i < head.size(); ++i) {
    const OutlinePiece& p = head.piece(i);
    const double dt = p.to.t - p.from.t, dr = p.to.rho - p.from.rho;
    const double chord = std::sqrt(dt * dt + dr * dr);
    const int rings = std::clamp(static_cast<int>(chord / spacing + 0.5), 1, 200);
    const auto at_part = [&](double part, OnHalf& normal) {
      OnHalf at{p.from.t + dt * part, p.from.rho + dr * part};
      normal = {-dr / chord, dt / chord};
      if (p.radius == 0.0) return at;
      const double t = at.t - p.centre.t, rho = at.rho - p.centre.rho;
      const double away = std::sqrt(t * t + rho * rho);
      normal = {t / away, rho / away};
      return OnHalf{p.centre.t + p.radius * normal.t, p.centre.rho + p.radius * normal.rho};
    };
    OnHalf ignored, last = p.from;
    for (int k = 0; k < rings; ++k) {
      const OnHalf next = at_part((k + 1.0) / rings, ignored);
      OnHalf normal;
      const OnHalf at = at_part((k + 0.5) / rings, normal);
      const double t = next.t - last.t, rho = next.rho - last.rho;
      const double area = std::sqrt(t * t + rho * rho) * (next.rho + last.rho);
      last = next;
      const std::size_t first = out.size();
      double whole = 0.0;
      around(a, b, points_of(at.rho, spacing), [&](Vec3 round, double part) {
        out.push_back({axis * at.t + round * at.rho, axis * normal.t + round * normal.rho, part});
        whole += part;
      });
      for (std::size_t j = first; j < out.size(); ++j) {
        out[j].share *= area / whole;
        sum += out[j].share;
      }
    }
  }
  for (PointShell::HeadPoint& p : out) p.share /= sum;
}

}  // namespace

PointShell shell_of(const Bur& bur, Vec3 axis, double head_spacing_mm, double holder_spacing_mm) {
  PointShell out;
  out.axis = axis;
  out.reach_mm = head_reach(bur);
  out.holder_radius_mm = std::max(bur.neck_radius_mm, bur.shank_radius_mm);
  const Vec3 a = across(axis), b = glm::cross(axis, a);
  if (bur.head.ball())
    ball_points(bur.radius_mm, head_spacing_mm, out.head);
  else
    head_points(bur.head, axis, a, b, head_spacing_mm, out.head);
  const auto ring = [&](double along, double radius, Vec3 normal_along, double outward) {
    around(a, b, points_of(radius, holder_spacing_mm), [&](Vec3 round, double) {
      const Vec3 offset = axis * along + round * radius;
      const bool in_head = bur.head.ball() ? glm::dot(offset, offset) <= bur.radius_mm * bur.radius_mm
                                           : head_distance(bur, axis, offset) <= 0.0;
      if (!in_head) out.holder.push_back({offset, normal_along + round * outward, along});
    });
  };
  const auto tube = [&](double from, double to, double radius) {
    const int rings = std::max(1, static_cast<int>((to - from) / holder_spacing_mm + 0.5));
    for (int i = 0; i <= rings; ++i) ring(from + (to - from) * i / rings, radius, Vec3(0.0), 1.0);
  };
  tube(0.0, bur.neck_length_mm, bur.neck_radius_mm);
  const double wide = bur.shank_radius_mm - bur.neck_radius_mm;
  if (bur.shank_length_mm > 0.0 && wide > 0.0) {
    // The shoulder between neck and shank looks back to the ball.
    const int rings = std::max(1, static_cast<int>(wide / holder_spacing_mm + 0.5));
    for (int i = 1; i <= rings; ++i) ring(bur.neck_length_mm, bur.neck_radius_mm + wide * i / rings, -axis, 0.0);
  }
  if (bur.shank_length_mm > 0.0)
    tube(bur.neck_length_mm, bur.neck_length_mm + bur.shank_length_mm, bur.shank_radius_mm);
  return out;
}

}  // namespace cusp::engine
