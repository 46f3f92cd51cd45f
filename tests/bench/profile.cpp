#include "tests/bench/profile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace cusp::bench {

namespace {

constexpr double kMeet = 1e-12;  // mm: ends this close to a line lie on it

double size(Vec2 v) { return std::sqrt(glm::dot(v, v)); }
double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
Vec2 left_of(Vec2 d) { return {-d.y, d.x}; }
Vec2 on_circle(Vec2 middle, double radius, double angle) {
  return middle + radius * Vec2(std::cos(angle), std::sin(angle));
}
/// The same angle, in (-pi, pi].
double wrapped(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }

}  // namespace

PlaneProfile::PlaneProfile(std::vector<Vec2> corners, double radius_mm) : corners_(std::move(corners)), radius_(radius_mm) {
  for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
    const Vec2 d = (corners_[i + 1] - corners_[i]) / size(corners_[i + 1] - corners_[i]);
    Segment next;
    next.normal = left_of(d);
    next.a = corners_[i] + radius_ * next.normal;
    next.b = corners_[i + 1] + radius_ * next.normal;
    if (i == 0) {
      segments_.push_back(next);
      continue;
    }
    const Vec2 before = corners_[i] - corners_[i - 1];
    const Vec2 old_normal = left_of(before / size(before));
    if (cross(before, d) < 0.0) {  // an outer corner: the bur rolls about it
      Segment arc;
      arc.arc = true;
      arc.middle = corners_[i];
      arc.from = std::atan2(old_normal.y, old_normal.x);
      arc.to = arc.from - wrapped(arc.from - std::atan2(next.normal.y, next.normal.x));
      arc.a = corners_[i] + radius_ * old_normal;
      arc.b = next.a;
      segments_.push_back(arc);
    } else {
      // An inner corner: the last segment ends on the line of the new one.
      const double level = glm::dot(next.normal, next.a);
      for (;;) {
        assert(!segments_.empty());
        Segment& last = segments_.back();
        const double ha = glm::dot(next.normal, last.a) - level, hb = glm::dot(next.normal, last.b) - level;
        if (ha > kMeet && hb <= kMeet) {
          if (last.arc) {
            // Clockwise along the arc the height falls: once to the line.
            double high = last.from, low = last.to;
            for (int k = 0; k < 80; ++k) {
              const double middle = 0.5 * (high + low);
              (glm::dot(next.normal, on_circle(last.middle, radius_, middle)) > level ? high : low) = middle;
            }
            last.to = low;
            last.b = on_circle(last.middle, radius_, low);
          } else {
            last.b = last.a + (last.b - last.a) * std::min(1.0, ha / (ha - hb));
          }
          next.a = last.b;
          break;
        }
        segments_.pop_back();
      }
    }
    segments_.push_back(next);
  }
}

double PlaneProfile::distance_mm(Vec2 p) const {
  double best = 1e300, side = 1.0;
  for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
    const Vec2 d = corners_[i + 1] - corners_[i];
    const double t = std::clamp(glm::dot(p - corners_[i], d) / glm::dot(d, d), 0.0, 1.0);
    const double far = size(p - (corners_[i] + t * d));
    if (far > best + 1e-12) continue;
    // At a corner both segments are equally near; the sum of their normals points out of the tissue.
    Vec2 normal = left_of(d / size(d));
    Vec2 at = corners_[i];
    if (t == 1.0 && i + 2 < corners_.size()) {
      const Vec2 next = corners_[i + 2] - corners_[i + 1];
      normal += left_of(next / size(next));
      at = corners_[i + 1];
    } else if (t == 0.0 && i > 0) {
      const Vec2 before = corners_[i] - corners_[i - 1];
      normal += left_of(before / size(before));
    }
    best = std::min(best, far);
    side = glm::dot(p - at, normal);
  }
  return side >= 0.0 ? best : -best;
}

PlaneProfile::On PlaneProfile::foot(std::size_t i, Vec2 q, Vec2 from) const {
  const Segment& p = segments_[i];
  if (!p.arc) {
    const Vec2 d = p.b - p.a;
    const double t = std::clamp(glm::dot(q - p.a, d) / glm::dot(d, d), 0.0, 1.0);
    return {i, t == 1.0 ? p.b : p.a + t * d, p.normal};
  }
  // Downhill: towards the direction of the device point, the shorter turn, within the arc.
  const Vec2 at = from - p.middle, to = q - p.middle;
  const double here = p.from - wrapped(p.from - std::atan2(at.y, at.x));
  const double turn = wrapped(std::atan2(to.y, to.x) - here);
  const double angle = std::clamp(here + turn, p.to, p.from);
  const Vec2 n(std::cos(angle), std::sin(angle));
  return {i, p.middle + radius_ * n, n};
}

bool PlaneProfile::downhill(const Segment& p, End end, Vec2 q) const {
  const Vec2 at = end == End::start ? p.a : p.b;
  Vec2 along;
  if (p.arc) {
    const Vec2 n = (at - p.middle) / radius_;
    along = {n.y, -n.x};  // clockwise
  } else {
    along = p.b - p.a;
  }
  if (end == End::end) along = -along;
  return glm::dot(q - at, along) > 0.0;
}

PlaneProfile::On PlaneProfile::slide(On on, Vec2 q) const {
  for (std::size_t pass = 0; pass < 2 * segments_.size(); ++pass) {
    on = foot(on.segment, q, on.at);
    const Segment& p = segments_[on.segment];
    const bool at_start = size(on.at - p.a) < 1e-12, at_end = size(on.at - p.b) < 1e-12;
    if (at_end && on.segment + 1 < segments_.size() && downhill(segments_[on.segment + 1], End::start, q)) {
      ++on.segment;
      on.at = segments_[on.segment].a;
    } else if (at_start && on.segment > 0 && downhill(segments_[on.segment - 1], End::end, q)) {
      --on.segment;
      on.at = segments_[on.segment].b;
    } else {
      break;
    }
  }
  return on;
}

PlaneProfile::On PlaneProfile::nearest(Vec2 q) const {
  On best;
  double least = 1e300;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    for (const Vec2 from : {segments_[i].a, segments_[i].b}) {
      const On on = foot(i, q, from);
      const double far = size(q - on.at);
      if (far < least) {
        least = far;
        best = on;
      }
    }
  }
  return best;
}

}  // namespace cusp::bench
