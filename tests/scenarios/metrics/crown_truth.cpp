#include "tests/scenarios/metrics/crown_truth.h"

#include <optional>

namespace cusp::test {

namespace {

constexpr double kNever = 1e3;
constexpr double kReach = 2.5;      // mm: no preparation reaches further from its axis
constexpr double kStepDeg = 0.5;    // of directions from the axis
constexpr double kChord = 0.3;      // mm, as in the definition of cavosurface_angle
constexpr double kLineAngle = 0.2;  // sine of the turn along a chord at which there is no angle

template <class Field>
Vec3 slope(Field&& field, Vec3 p) {
  constexpr double kStep = 1e-3;
  Vec3 out;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 low = p, high = p;
    low[axis] -= kStep;
    high[axis] += kStep;
    out[axis] = (field(high) - field(low)) / (2 * kStep);
  }
  return out;
}

/// Where a continuous function is 0 between a place above 0 and one below.
template <class Function>
double zero_between(double above, double below, Function&& f) {
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (above + below);
    (f(middle) < 0.0 ? below : above) = middle;
  }
  return 0.5 * (above + below);
}

/// Heights between which a convex void lies under `top`; nullopt where it does not.
std::optional<Vec2> column(const Preparation& p, double x, double y, double low, double top) {
  const auto d = [&](double z) { return p.distance({x, y, z}); };
  double in = top;
  if (d(in) >= 0.0) {
    double a = low, b = top;
    for (int i = 0; i < 24; ++i) {
      const double c = a + 0.382 * (b - a), e = a + 0.618 * (b - a);
      (d(c) < d(e) ? b : a) = d(c) < d(e) ? e : c;
    }
    in = 0.5 * (a + b);
    if (d(in) >= 0.0) return std::nullopt;
  }
  return Vec2(d(low) < 0.0 ? low : zero_between(low, in, d), d(top) < 0.0 ? top : zero_between(top, in, d));
}

}  // namespace

double UprightBox::floor_at(double x, double y) const {
  const double u = rectangle_distance({x, y}, Vec2(0.0), {half_x, half_y});
  if (u >= 0.0) return kNever;
  const double in = std::max(0.0, u + corner);
  return -depth + corner - std::sqrt(corner * corner - in * in);
}

double Heights::at(double x, double y) const {
  const double u = (x - low_.x) / step_, v = (y - low_.y) / step_;
  const int i = static_cast<int>(u), j = static_cast<int>(v);
  const auto z = [&](int a, int b) { return z_[static_cast<std::size_t>(a) + static_cast<std::size_t>(nx_) * static_cast<std::size_t>(b)]; };
  const double fx = u - i, fy = v - j;
  return (1 - fy) * ((1 - fx) * z(i, j) + fx * z(i + 1, j)) + fy * ((1 - fx) * z(i, j + 1) + fx * z(i + 1, j + 1));
}

CrownTruth::CrownTruth(const TurnedCrown& crown, const Preparation& preparation, const UprightBox& target)
    : crown_(crown), p_(preparation), target_(target),
      top_(Vec2(p_.place) - kReach, Vec2(p_.place) + kReach, 0.035, [&](double x, double y) { return crown.top_at(x, y); }), margin_(margin()) {}

std::map<std::string, double> CrownTruth::values(double voxel_mm) const {
  std::map<std::string, double> out;
  add_floor(out);
  add_walls_and_ridges(p_.place.z - out["depth_mean"] + kCorner + 0.5 * voxel_mm, out);
  add_volumes(out);
  add_margin(out);
  add_pulp(out);
  return out;
}

double CrownTruth::floor_z(double x, double y) const {
  return zero_between(p_.place.z - p_.depth - 0.5, p_.place.z - p_.depth + 0.7, [&](double z) { return p_.distance({x, y, z}); });
}

/// Over the target's outline inset by its corner's radius.
void CrownTruth::add_floor(std::map<std::string, double>& out) const {
  constexpr int kSteps = 60;
  const double x = target_.half_x - target_.corner, y = target_.half_y - target_.corner;
  double least = kNever, most = -kNever, sum = 0, all = 0;
  double area = 0, zz = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, mx = 0, my = 0, mz = 0;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j <= kSteps; ++j) {
      const double u = x * (2.0 * i / kSteps - 1.0), v = y * (2.0 * j / kSteps - 1.0);
      const Vec3 at(p_.place.x + u, p_.place.y + v, floor_z(p_.place.x + u, p_.place.y + v));
      const Vec3 n = glm::normalize(slope([&](Vec3 q) { return p_.distance(q); }, at));
      const double w = 1.0 / std::fabs(n.z), z = at.z - p_.place.z;
      least = std::min(least, -z);
      most = std::max(most, -z);
      sum -= z;
      all += 1;
      area += w, mx += w * u, my += w * v, mz += w * z;
      xx += w * u * u, xy += w * u * v, yy += w * v * v, xz += w * u * z, yz += w * v * z, zz += w * z * z;
    }
  mx /= area, my /= area, mz /= area;
  xx = xx / area - mx * mx, xy = xy / area - mx * my, yy = yy / area - my * my;
  xz = xz / area - mx * mz, yz = yz / area - my * mz, zz = zz / area - mz * mz;
  const double determinant = xx * yy - xy * xy, a = (xz * yy - yz * xy) / determinant, b = (yz * xx - xz * xy) / determinant;
  out["depth_least"] = least;
  out["depth_mean"] = sum / all;
  out["depth_most"] = most;
  out["floor_tilt"] = std::atan(std::hypot(a, b)) / kRadians;
  out["floor_flatness"] = std::sqrt(std::max(0.0, zz - a * xz - b * yz) / (1 + a * a + b * b));
}

void CrownTruth::add_walls_and_ridges(double low, std::map<std::string, double>& out) const {
  double high = low;
  for (const MarginPlace& e : margin_) high = std::max(high, e.at.z);
  WallAngles walls;
  for_wall(p_, low, high, 60, kStepDeg, [&](double, Vec3 middle, Vec3 area) {
    if (middle.z < top_.at(middle.x, middle.y)) walls.add(area);
  });
  const int mesial = mesial_x(crown_.fdi());
  add_walls(walls, mesial, out);
  out["isthmus_width"] = isthmus();
  out["ridge_mesial"] = ridge(low, mesial);
  out["ridge_distal"] = ridge(low, -mesial);
}

/// In columns beside each other.
void CrownTruth::add_volumes(std::map<std::string, double>& out) const {
  const double step = 0.03, low = p_.place.z - p_.depth - 0.5;
  const Heights junction(Vec2(p_.place) - kReach, Vec2(p_.place) + kReach - 0.05, 0.1, [&](double x, double y) {
    const double top = top_.at(x, y);
    if (!column(p_, x, y, low, top + 0.2) && !column(p_, x + 0.1, y + 0.1, low, top + 0.2) && !column(p_, x - 0.1, y - 0.1, low, top + 0.2)) return top;
    for (double z = top - 0.1; z > top - 4.0; z -= 0.15)
      if (crown_.dentine({x, y, z}) < 0.0) return zero_between(z + 0.15, z, [&](double h) { return crown_.dentine({x, y, h}); });
    return top - 4.0;
  });
  double enamel = 0, dentine = 0;
  for (double u = -kReach + 0.1; u < kReach - 0.1; u += step)
    for (double v = -kReach + 0.1; v < kReach - 0.1; v += step) {
      const double x = p_.place.x + u, y = p_.place.y + v, top = top_.at(x, y);
      const auto cut = top > low ? column(p_, x, y, low, top) : std::nullopt;
      if (!cut) continue;
      const double change = std::clamp(junction.at(x, y), cut->x, cut->y);
      enamel += cut->y - change;
      dentine += change - cut->x;
    }
  out["removed_enamel"] = enamel * step * step;
  out["removed_dentine"] = dentine * step * step;
  add_target(low, out);
}

/// In columns whose outermost sides are the target's walls.
void CrownTruth::add_target(double low, std::map<std::string, double>& out) const {
  constexpr int kColumns = 120;
  const double along = 2 * target_.half_x / kColumns, aside = 2 * target_.half_y / kColumns;
  double target = 0, removed = 0;
  for (int i = 0; i < kColumns; ++i)
    for (int j = 0; j < kColumns; ++j) {
      const double u = along * (i + 0.5) - target_.half_x, v = aside * (j + 0.5) - target_.half_y;
      const double x = p_.place.x + u, y = p_.place.y + v, top = top_.at(x, y), floor = target_.floor_at(u, v) + p_.place.z;
      target += std::max(0.0, top - floor);
      if (const auto cut = column(p_, x, y, low, top)) removed += std::max(0.0, cut->y - std::max(cut->x, floor));
    }
  out["target_removed"] = 100.0 * removed / target;
  out["uncut_remainder"] = (target - removed) * along * aside;
}

std::vector<MarginPlace> CrownTruth::margin() const {
  std::vector<MarginPlace> out;
  for (double deg = 0.0; deg < 360.0; deg += kStepDeg) {
    const auto above = [&](double z) { return crown_.surface(p_.wall_at(z, deg)); };
    double z = crown_.highest();
    while (z > p_.place.z - p_.depth && above(z) >= 0.0) z -= 0.06;
    if (z <= p_.place.z - p_.depth) continue;  // the crown has fallen off below the floor
    const Vec3 at = p_.wall_at(zero_between(z + 0.06, z, above), deg);
    out.push_back({at, glm::normalize(slope([&](Vec3 q) { return crown_.surface(q); }, at)),
                   -glm::normalize(slope([&](Vec3 q) { return p_.distance(q); }, at)), deg});
  }
  return out;
}

/// Least way in plan from a buccal or lingual place of the margin, at right angles to it, to the margin opposite.
double CrownTruth::isthmus() const {
  constexpr double kOcclusal = 0.5, kOpposite = 0.70710678, kGap = 0.3;  // mm, where the margin ends
  const std::size_t count = margin_.size();
  const auto across = [&](const MarginPlace& e) {
    const Vec3 along = glm::cross(e.out, e.into_void);
    const Vec2 way = glm::normalize(Vec2(-along.y, along.x));
    return way.x * e.into_void.x + way.y * e.into_void.y > 0.0 ? way : -way;
  };
  double best = kNever;
  for (const MarginPlace& from : margin_) {
    const std::size_t side = wall_of(from.into_void);
    if (side < 2 || from.out.z < kOcclusal) continue;
    const Vec2 way = across(from), beside(-way.y, way.x);
    for (std::size_t i = 0; i < count; ++i) {
      const MarginPlace &a = margin_[i], &b = margin_[(i + 1) % count];
      if (wall_of(a.into_void) != 5 - side || a.out.z < kOcclusal || -glm::dot(way, across(a)) < kOpposite) continue;
      const double u = glm::dot(Vec2(a.at - from.at), beside), v = glm::dot(Vec2(b.at - from.at), beside);
      if (u * v > 0.0 || u == v || glm::length(b.at - a.at) > kGap) continue;
      const double mm = glm::dot(Vec2(a.at + u / (u - v) * (b.at - a.at) - from.at), way);
      if (mm > 0.2) best = std::min(best, mm);
    }
  }
  return best;
}

double CrownTruth::contour(double y, double low, double direction) const {
  const auto reach = [&](double z) {
    double x = p_.place.x + direction * 9.0;
    for (int i = 0; i < 200 && direction * (x - p_.place.x) > 0.0; ++i) {
      const double d = crown_.surface({x, y, z});
      if (d < 1e-5) return direction * x;
      x -= direction * 0.7 * std::min(d, 2.0);
    }
    return -kNever;
  };
  double best = -kNever, at = low;
  const auto look = [&](double z) {
    if (z < low) return;
    const double x = reach(z);
    if (x > best) best = x, at = z;
  };
  for (double z = low; z < crown_.highest(); z += 0.2) look(z);
  for (double step = 0.1; step > 0.005; step *= 0.5) {
    const double middle = at;
    look(middle - step);
    look(middle + step);
  }
  return best;
}

/// Least way along x from the wall's outermost place in each strip to the tooth's contour there.
double CrownTruth::ridge(double low, double direction) const {
  constexpr double kStrip = 0.04;
  std::map<int, Vec3> wall;
  const auto offer = [&](Vec3 at) {
    const Vec3 into_void = -slope([&](Vec3 q) { return p_.distance(q); }, at);
    if (wall_of(into_void) != (direction > 0.0 ? 0u : 1u)) return;
    const auto [it, first] = wall.try_emplace(static_cast<int>(std::floor(at.y / kStrip)), at);
    if (!first && direction * (at.x - it->second.x) > 0.0) it->second = at;
  };
  // Below `low`, down to the line angle: of a wall that converges occlusally the outermost.
  const auto offer_foot = [&](double deg) {
    const Vec3 way(std::cos(deg * kRadians), std::sin(deg * kRadians), 0.0);
    for (double z = low; z > p_.place.z - p_.depth - 0.3; z -= 0.02) {
      const auto outside = [&](double r) { return p_.distance(Vec3(p_.place.x, p_.place.y, z) + r * way); };
      double in = 2.2;
      while (in > 0.0 && outside(in) >= 0.0) in -= 0.1;
      if (in <= 0.0) return;
      const Vec3 at = Vec3(p_.place.x, p_.place.y, z) + zero_between(in + 0.1, in, outside) * way;
      const Vec3 normal = glm::normalize(slope([&](Vec3 q) { return p_.distance(q); }, at));
      if (std::fabs(normal.z) < 0.70710678) offer(at);  // no floor
    }
  };
  for (const MarginPlace& m : margin_) {
    if (m.at.z < low) continue;
    offer(m.at);
    offer(p_.wall_at(low, m.deg));
    offer_foot(m.deg);
  }
  double best = kNever;
  for (const auto& [strip, at] : wall) best = std::min(best, contour(at.y, low, direction) - direction * at.x);
  return best;
}

/// Angle between chords from the margin along the wall and along the tooth, at right angles to the margin.
void CrownTruth::add_margin(std::map<std::string, double>& out) const {
  const auto tooth = [&](Vec3 q) { return crown_.surface(q); };
  const auto wall = [&](Vec3 q) { return -p_.distance(q); };
  // The place of a surface that lies a chord off, nearest to the tangent's.
  const auto chord = [&](const MarginPlace& e, Vec3 normal, Vec3 way, auto&& on, auto&& other) -> std::optional<Vec3> {
    const auto turned = [&](double rad) { return kChord * (std::cos(rad) * way + std::sin(rad) * normal); };
    const auto d = [&](double rad) { return on(e.at + turned(rad)); };
    constexpr double kStep = 4 * kRadians;
    for (double rad = 0.0; rad < 75 * kRadians; rad += kStep)
      for (const double sign : {1.0, -1.0}) {
        const double a = sign * rad, b = sign * (rad + kStep);
        if ((d(a) < 0.0) == (d(b) < 0.0)) continue;
        const Vec3 reach = turned(d(a) < 0.0 ? zero_between(b, a, d) : zero_between(a, b, d));
        const Vec3 tangent = glm::normalize(glm::cross(e.out, e.into_void));
        if (std::fabs(glm::dot(glm::normalize(slope(on, e.at + reach)), tangent)) > kLineAngle) return std::nullopt;
        return other(e.at + reach) < 0.0 ? std::optional(reach) : std::nullopt;
      }
    return std::nullopt;
  };
  double sum = 0, all = 0, off = 0;
  const std::size_t count = margin_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const MarginPlace& e = margin_[i];
    const double length = 0.5 * glm::length(margin_[(i + 1) % count].at - margin_[(i + count - 1) % count].at), across = glm::dot(e.out, e.into_void);
    const auto down = chord(e, e.into_void, -glm::normalize(e.out - across * e.into_void), wall, tooth);
    const auto aside = chord(e, e.out, -glm::normalize(e.into_void - across * e.out), tooth, wall);
    if (!down || !aside) continue;
    const double deg = std::acos(std::clamp(glm::dot(*down, *aside) / (kChord * kChord), -1.0, 1.0)) / kRadians;
    sum += length * deg;
    all += length;
    if (deg < 80.0 || deg > 110.0) off += length;
  }
  out["cavosurface_angle"] = sum / all;
  out["cavosurface_off"] = 100.0 * off / all;
}

/// From a place to the pulp's surface, beginning at a place of it.
double CrownTruth::pulp_distance(Vec3 p, Vec3 at) const {
  const auto pulp = [&](Vec3 q) { return crown_.pulp(q); };
  double best = kNever;
  for (int i = 0; i < 30; ++i) {
    const Vec3 g = slope(pulp, at), onto = -pulp(at) / glm::dot(g, g) * g, away = p - at;
    if (glm::length(onto) < 2e-3) best = std::min(best, glm::length(p - at - onto));
    at += onto + 0.5 * (away - glm::dot(away, g) / glm::dot(g, g) * g);
  }
  return best;
}

/// Of the floor and of the walls below the margin.
void CrownTruth::add_pulp(std::map<std::string, double>& out) const {
  struct Pair {
    double mm;
    Vec3 cut, pulp;
  };
  std::vector<Pair> pairs;
  const auto offer = [&](Vec3 at) {
    if (at.z >= top_.at(at.x, at.y) || crown_.pulp_places().empty()) return;
    const Vec3 near = *std::ranges::min_element(crown_.pulp_places(), {}, [&](Vec3 q) { return glm::dot(q - at, q - at); });
    pairs.push_back({glm::length(near - at), at, near});
  };
  const double step = 0.07;
  for (double u = -kReach + 0.2; u < kReach - 0.2; u += step)
    for (double v = -kReach + 0.2; v < kReach - 0.2; v += step) {
      const double x = p_.place.x + u, y = p_.place.y + v;
      if (const auto cut = column(p_, x, y, p_.place.z - p_.depth - 0.5, p_.place.z)) offer({x, y, cut->x});
    }
  for_wall(p_, p_.place.z - p_.depth + 0.05, p_.place.z, 12, 3.0, [&](double, Vec3 middle, Vec3) { offer(middle); });
  std::ranges::sort(pairs, {}, &Pair::mm);
  double best = kNever;
  for (const Pair& one : pairs) {
    if (one.mm > pairs.front().mm + 0.1) break;
    best = std::min(best, pulp_distance(one.cut, one.pulp));
  }
  constexpr double kInBox = 1.5;  // deeper pulp may lie below the crown's box
  if (best < kInBox) out["remaining_over_pulp"] = best;
}

}  // namespace cusp::test
