#include "tests/bench/convex_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cusp::bench {

namespace {

constexpr int kMostPasses = 4000;
constexpr double kLeapRadians = 0.02;  // longest extrapolation: it must not leave the local minimum's basin
constexpr int kArcParts = 12;
constexpr double kBesideEnd = 1e-12;  // radians
constexpr double kExact = 1e-11;      // radians; 0.3 mm of depth turn it into 3e-12 mm

}  // namespace

double ConvexTissue::distance_mm(Vec3 place) const {
  const Vec3 p = frame.to_local(place);
  if (kind == ConvexKind::sphere) return length(p) - radius_mm;
  Vec3 beyond(-1e9, -1e9, p.z);
  if (kind != ConvexKind::face) beyond.y = p.y;
  if (kind == ConvexKind::corner) beyond.x = p.x;
  const double most = std::max({beyond.x, beyond.y, beyond.z});
  return most <= 0.0 ? most : length(glm::max(beyond, Vec3(0.0)));
}

Vec3 ConvexTissue::normal_near(Vec3 n) const {
  if (kind == ConvexKind::sphere) return unit(n);
  if (kind == ConvexKind::face) return frame.z;
  Vec3 local = glm::max(Vec3(glm::dot(n, frame.x), glm::dot(n, frame.y), glm::dot(n, frame.z)), Vec3(0.0));
  if (kind == ConvexKind::edge) local.x = 0.0;
  return frame.direction(unit(local));
}

std::vector<Vec3> ConvexTissue::normals(Vec3 place) const {
  if (kind == ConvexKind::face) return {frame.z};
  if (kind == ConvexKind::sphere) return {unit(place - frame.origin)};
  constexpr int kParts = 6;
  std::vector<Vec3> out;
  for (int i = 0; i <= kParts; ++i)
    for (int j = 0; i + j <= kParts; ++j) {
      const Vec3 local(i, j, kParts - i - j);
      if (kind == ConvexKind::corner || i == 0) out.push_back(frame.direction(unit(local)));
    }
  return out;
}

double ConvexContact::depth_mm(Vec3 n, Vec3 pivot) const {
  const Vec3 lowest = pivot + body_.furthest(-n, axis_);
  return glm::dot(n, tissue_.frame.origin - lowest) + tissue_.radius_mm;
}

Vec3 ConvexContact::from_point(Vec3 point, Vec3 pivot) const {
  const Vec3 place = point - pivot;
  return unit(body_.nearest(place, axis_) - place);
}

/// The normal between two of the tissue's faces (a quarter turn) whose supporting plane is furthest below the body.
Vec3 ConvexContact::best_on_arc(Vec3 first, Vec3 second, Vec3 pivot) const {
  constexpr double kQuarter = std::numbers::pi / 2.0;
  const auto at = [&](double angle) { return first * std::cos(angle) + second * std::sin(angle); };
  /// The height above the plane grows with the angle.
  const auto grows = [&](double angle) {
    const Vec3 n = at(angle), along = second * std::cos(angle) - first * std::sin(angle);
    return glm::dot(along, pivot + body_.furthest(-n, axis_) - tissue_.frame.origin) > 0.0;
  };
  double least = 1e300;
  int best = 0;
  for (int i = 0; i <= kArcParts; ++i) {
    const double depth = depth_mm(at(kQuarter * i / kArcParts), pivot);
    if (depth >= least) continue;
    least = depth;
    best = i;
  }
  double low = kQuarter * std::max(best - 1, 0) / kArcParts,
         high = kQuarter * std::min(best + 1, kArcParts) / kArcParts;
  // Beside the ends, for at a flat's own normal any point of it is furthest.
  if (best == 0 && !grows(kBesideEnd)) return first;
  if (best == kArcParts && grows(kQuarter - kBesideEnd)) return second;
  for (int i = 0; i < 48; ++i) {
    const double middle = 0.5 * (low + high);
    (grows(middle) ? low : high) = middle;
  }
  return at(0.5 * (low + high));
}

Vec3 ConvexContact::separating(Vec3 pivot) const {
  const Frame& f = tissue_.frame;
  if (tissue_.kind == ConvexKind::face) return f.z;
  if (tissue_.kind == ConvexKind::sphere) return from_point(f.origin, pivot);
  if (tissue_.kind == ConvexKind::edge) return best_on_arc(f.y, f.z, pivot);
  // The height above a plane has one maximum over the normals. Outside the corner's normals, it lies on their border.
  const Vec3 n = from_point(f.origin, pivot);
  const Vec3 local(glm::dot(n, f.x), glm::dot(n, f.y), glm::dot(n, f.z));
  if (local.x >= 0.0 && local.y >= 0.0 && local.z >= 0.0) return n;
  Vec3 best = f.z;
  double least = depth_mm(best, pivot);
  const auto take = [&](double part, Vec3 first, Vec3 second) {
    if (part >= 0.0) return;
    const Vec3 other = best_on_arc(first, second, pivot);
    const double depth = depth_mm(other, pivot);
    if (depth >= least) return;
    least = depth;
    best = other;
  };
  take(local.x, f.y, f.z);
  take(local.y, f.z, f.x);
  take(local.z, f.x, f.y);
  return best;
}

Vec3 ConvexContact::settle(Vec3 n, Vec3 device, double precision) const {
  Vec3 last(0.0);
  double depth = depth_mm(n, device);
  if (depth < -kProximalMm) return separating(device);  // outside, the depth has one minimum
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const Vec3 next = separating(device + n * (depth + kProximalMm));
    const Vec3 step = next - n;
    n = next;
    depth = depth_mm(n, device);
    const double moved = length(step), before = glm::dot(last, last);
    if (moved < precision) break;
    // Aitken: steps that shrink by a constant factor sum to a geometric series.
    const double factor = before > 0.0 ? glm::dot(step, last) / before : 0.0;
    last = step;
    if (!(factor > 0.0 && factor < 1.0)) continue;
    const double leap = std::min(factor / (1.0 - factor), kLeapRadians / moved);
    const Vec3 ahead = tissue_.normal_near(n + step * leap);
    const double there = depth_mm(ahead, device);
    if (!(there < depth)) continue;
    n = ahead;
    depth = there;
    last = Vec3(0.0);
  }
  return n;
}

double ConvexContact::clearance_mm(Vec3 pivot, Vec3 near) const {
  Vec3 start = near;
  double least = depth_mm(near, pivot);
  for (const Vec3& n : tissue_.normals(pivot)) {
    const double depth = depth_mm(n, pivot);
    if (depth >= least) continue;
    least = depth;
    start = n;
  }
  const double found = depth_mm(settle(start, pivot, kExact), pivot);
  if (least < 0.0) return -found;  // outside, the depth has one minimum
  return -std::min(found, depth_mm(settle(near, pivot, kExact), pivot));
}

Vec3 ConvexContact::on_ray(Vec3 from, Vec3 towards, double clearance) const {
  // Newton on the distance, which is convex along the ray: from outside it never passes the root.
  double far = 40.0;
  for (int pass = 0; pass < 100; ++pass) {
    const Vec3 pivot = from + towards * far;
    const Vec3 n = separating(pivot);
    const double step = (-depth_mm(n, pivot) - clearance) / glm::dot(n, towards);
    far -= step;
    if (std::fabs(step) < 1e-11) break;
  }
  return from + towards * far;
}

}  // namespace cusp::bench
