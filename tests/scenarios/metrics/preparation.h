/// Preparations whose walls and floor are known by analysis, and their form.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "scenarios/shapes/distance.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/known.h"

namespace cusp::test {

inline constexpr double kRadians = std::numbers::pi / 180.0;
/// Radius of a rounded line angle between wall and floor, mm.
inline constexpr double kCorner = 0.3;

/// Cosine and sine.
inline Vec2 direction(double deg) { return {std::cos(deg * kRadians), std::sin(deg * kRadians)}; }

enum class Kind : std::uint8_t { tapered, rounded, slot };

/// A preparation with walls at angles of its own and a tilted floor, turned about the axis.
struct Preparation {
  Kind kind = Kind::tapered;
  double half_x = 1.2, half_y = 0.9, depth = 1.8;
  Vec2 turn{1, 0};                                                       // cosine and sine
  std::array<Vec2, 4> lean = {Vec2(1, 0), Vec2(1, 0), Vec2(1, 0), Vec2(1, 0)};  // of the walls towards +x, -x, +y, -y
  double tilt_x = 0, tilt_y = 0;     // slopes of the floor
  Vec3 place{0.0};                   // where the axis meets the plane that depth is from

  double distance(Vec3 p) const {
    p -= place;
    const Vec2 q(turn.x * p.x + turn.y * p.y, turn.x * p.y - turn.y * p.x);
    const double length = std::sqrt(1.0 + tilt_x * tilt_x + tilt_y * tilt_y);
    const double below_floor = (-depth + tilt_x * q.x + tilt_y * q.y - p.z) / length;
    if (kind == Kind::slot) {
      const double u = segment_distance(q, {half_y - half_x, 0.0}, {half_x - half_y, 0.0}) - half_y;
      return rounded_corner(u, below_floor, kCorner);
    }
    // Through the floor's edge, opening upwards by the wall's angle.
    const auto wall = [&](double out, double half, std::size_t i) { return (out - half) * lean[i].x - (p.z + depth) * lean[i].y; };
    const double along = std::max(wall(q.x, half_x, 0), wall(-q.x, half_x, 1)), across = std::max(wall(q.y, half_y, 2), wall(-q.y, half_y, 3));
    const double u = rounded_corner(along, across, 0.5);  // the vertical corners that a bur of 1 mm leaves
    return kind == Kind::rounded ? rounded_corner(u, below_floor, kCorner) : std::max(u, below_floor);
  }
  /// The wall's place at a height above the floor, in a direction from the axis.
  Vec3 wall_at(double z, double deg) const {
    const Vec3 axis(place.x, place.y, z), way(std::cos(deg * kRadians), std::sin(deg * kRadians), 0.0);
    double in = 0, out = 3.4;
    for (int i = 0; i < 36; ++i) {
      const double middle = 0.5 * (in + out);
      (distance(axis + middle * way) < 0.0 ? in : out) = middle;
    }
    return axis + in * way;
  }
  /// Of all heights from the floor up to where depth is from, a line angle included.
  double furthest_x(double direction) const {
    double best = 0;
    for (double z = -depth - 0.3; z <= 0.0; z += 0.01)
      for (double y = -1.6; y <= 1.6; y += 0.02) {
        const auto is_void = [&](double x) { return distance(place + Vec3(direction * x, y, z)) < 0.0; };
        double in = best, out = 3.4;
        for (int i = 0; is_void(best) && i < 36; ++i) {
          const double middle = 0.5 * (in + out);
          (is_void(middle) ? in : out) = middle;
        }
        best = in;
      }
    return best;
  }
};

/// Walks the wall between two heights in cells, in the order of their direction: visit(deg, middle, area vector into the void).
template <class Visit>
void for_wall(const Preparation& p, double low, double high, int levels, double step_deg, Visit&& visit) {
  std::vector<Vec3> last(static_cast<std::size_t>(levels) + 1), next(last);
  for (double deg = -step_deg; deg < 360.0; deg += step_deg) {
    for (std::size_t k = 0; k < next.size(); ++k) next[k] = p.wall_at(low + (high - low) * static_cast<double>(k) / levels, deg);
    for (std::size_t k = 0; deg >= 0.0 && k + 1 < next.size(); ++k)
      visit(deg, 0.25 * (last[k] + last[k + 1] + next[k] + next[k + 1]), 0.5 * glm::cross(last[k + 1] - next[k], next[k + 1] - last[k]));
    last = next;
  }
}

/// Which wall a normal into the void is of: towards +x, -x, +y, -y.
inline std::size_t wall_of(Vec3 n) {
  return std::fabs(n.x) >= std::fabs(n.y) ? (n.x < 0.0 ? 0u : 1u) : (n.y < 0.0 ? 2u : 3u);
}

/// The definition of wall_angle_<side>, by integration over the wall's cells that lie in the tooth: a wall takes half of the
/// rounded vertical corners beside it.
struct WallAngles {
  std::array<double, 4> rise{}, run{};
  void add(Vec3 into_void) {
    rise[wall_of(into_void)] += into_void.z;
    run[wall_of(into_void)] += std::hypot(into_void.x, into_void.y);
  }
  double deg(std::size_t wall) const { return std::atan2(rise[wall], run[wall]) / kRadians; }
};

/// Names of the walls towards +x, -x, +y, -y in a tooth whose mesial side lies along mesial_x.
inline std::array<const char*, 4> sides(int mesial_x) {
  return mesial_x > 0 ? std::array{"mesial", "distal", "buccal", "lingual"} : std::array{"distal", "mesial", "buccal", "lingual"};
}

inline void add_walls(const WallAngles& walls, int mesial_x, std::map<std::string, double>& truth) {
  for (std::size_t i = 0; i < 4; ++i) truth[std::string("wall_angle_") + sides(mesial_x)[i]] = walls.deg(i);
  truth["convergence_mesiodistal"] = -(walls.deg(0) + walls.deg(1));
  truth["convergence_buccolingual"] = -(walls.deg(2) + walls.deg(3));
}

inline Preparation random_preparation(Kind kind, Draw& draw) {
  Preparation p;
  p.kind = kind;
  p.half_x = draw(1.3, 1.6);
  p.half_y = draw(0.9, 1.1);
  p.depth = draw(1.5, 2.2);
  p.turn = direction(draw(-20, 20));
  if (kind != Kind::slot)
    for (Vec2& lean : p.lean) lean = direction(draw(-8, 10));
  const double tilt = std::tan(draw(0, 5) * kRadians), way = draw(0, 360) * kRadians;
  p.tilt_x = tilt * std::cos(way);
  p.tilt_y = tilt * std::sin(way);
  return p;
}

}  // namespace cusp::test
