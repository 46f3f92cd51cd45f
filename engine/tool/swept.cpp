#include "engine/tool/swept.h"

#include <cmath>

namespace cusp::engine {

namespace {

Vec3 in_space(Vec3 axis, const ByHead& place, OnHalf gradient) noexcept {
  if (place.at.rho > 0.0) return axis * gradient.t + place.off * (gradient.rho / place.at.rho);
  return axis * gradient.t + across(axis) * gradient.rho;
}

double ball_distance(double radius_mm, Vec3 axis, Vec3 from_centre, Vec3& gradient) noexcept {
  const double away = std::sqrt(glm::dot(from_centre, from_centre));
  gradient = away > 0.0 ? from_centre / away : across(axis);
  return away - radius_mm;
}

/// Nearest point of the segment from a to b, as a part of it.
double nearest_part(Vec3 a, Vec3 b, Vec3 place) noexcept {
  const Vec3 along = b - a;
  const double square = glm::dot(along, along);
  if (!(square > 0.0)) return 0.0;
  const double part = glm::dot(place - a, along) / square;
  return part < 0.0 ? 0.0 : part > 1.0 ? 1.0 : part;
}

/// The distance at a part of the way, and its slope along the way. The distance is convex in the part, so the slope
/// only grows.
struct OnTheWay {
  double part = 0.0, distance = 0.0, slope = 0.0;
  ByHead place;
  OnHalf gradient;
};

OnTheWay at_part(const Profile& head, Vec3 axis, Vec3 from_a, Vec3 way, double part) noexcept {
  OnTheWay out;
  out.part = part;
  out.place = by_axis(axis, from_a - way * part);
  out.distance = head.distance(out.place.at, out.gradient);
  // On the axis every direction across is level or rises, so 0 is a slope of the distance there.
  const double across_way = out.place.at.rho > 0.0 ? glm::dot(out.place.off, way) / out.place.at.rho : 0.0;
  out.slope = -(out.gradient.t * glm::dot(axis, way) + out.gradient.rho * across_way);
  return out;
}

double cylinder_distance(double from, double to, double radius, OnHalf at, OnHalf& gradient) noexcept {
  const double end = at.t < 0.5 * (from + to) ? from - at.t : at.t - to;
  const double side = at.rho - radius;
  const double way = at.t < 0.5 * (from + to) ? -1.0 : 1.0;
  if (end > 0.0 && side > 0.0) {
    const double away = std::sqrt(end * end + side * side);
    gradient = {way * end / away, side / away};
    return away;
  }
  gradient = side >= end ? OnHalf{0.0, 1.0} : OnHalf{way, 0.0};
  return side >= end ? side : end;
}

}  // namespace

Vec3 across(Vec3 axis) noexcept {
  int least = 0;
  for (int i = 1; i < 3; ++i)
    if (std::fabs(axis[i]) < std::fabs(axis[least])) least = i;
  Vec3 out(0.0);
  out[least] = 1.0;
  out -= axis * axis[least];
  return out / std::sqrt(glm::dot(out, out));
}

Vec3 head_furthest(const Bur& bur, Vec3 axis, Vec3 direction) noexcept {
  if (bur.head.ball()) return direction * bur.radius_mm;
  const ByHead way = by_axis(axis, direction);
  const OnHalf at = bur.head.support(way.at, {});
  return in_space(axis, way, at);
}

Vec3 gradient_in_space(const ByHead& place, Vec3 axis) noexcept { return in_space(axis, place, place.gradient); }

double head_distance(const Bur& bur, Vec3 axis, Vec3 from_pivot) noexcept {
  if (bur.head.ball()) return std::sqrt(glm::dot(from_pivot, from_pivot)) - bur.radius_mm;
  OnHalf gradient;
  return bur.head.distance(by_axis(axis, from_pivot).at, gradient);
}

double head_distance(const Bur& bur, Vec3 axis, Vec3 from_pivot, Vec3& gradient) noexcept {
  if (bur.head.ball()) return ball_distance(bur.radius_mm, axis, from_pivot, gradient);
  ByHead place = by_axis(axis, from_pivot);
  reckon(bur, place);
  gradient = gradient_in_space(place, axis);
  return place.distance;
}

Vec3 head_support(const Bur& bur, Vec3 axis, Vec3 direction, Vec3 near) noexcept {
  if (bur.head.ball()) return direction * bur.radius_mm;
  const ByHead way = by_axis(axis, direction), place = by_axis(axis, near);
  const OnHalf at = bur.head.support(way.at, place.at);
  if (way.at.rho > 1e-9) return axis * at.t + way.off * (at.rho / way.at.rho);
  // A direction along the axis has no part across it; the place's part is used.
  const Vec3 round = place.at.rho > 0.0 ? place.off / place.at.rho : across(axis);
  return axis * at.t + round * at.rho;
}

Passing passing_head(const Bur& bur, Vec3 axis, Vec3 a, Vec3 b, Vec3 place, double enough_mm) noexcept {
  Passing out;
  const double near = nearest_part(a, b, place);
  const Vec3 from_near = place - (a + (b - a) * near);
  if (bur.head.ball()) {
    out.part = near;
    out.distance_mm = ball_distance(bur.radius_mm, axis, from_near, out.gradient);
    return out;
  }
  if (enough_mm < 1e299) {
    const double bound = std::sqrt(glm::dot(from_near, from_near)) - bur.head.reach();
    if (bound > enough_mm) {
      out.distance_mm = bound;
      return out;
    }
  }
  const Vec3 way = b - a;
  const auto at = [&](double part) { return at_part(bur.head, axis, place - a, way, part); };
  const auto answer = [&](const OnTheWay& best) {
    out.part = best.part;
    out.distance_mm = best.distance;
    out.gradient = in_space(axis, best.place, best.gradient);
    return out;
  };
  OnTheWay high = at(1.0);
  if (high.slope <= 0.0) return answer(high);
  OnTheWay low = at(0.0);
  if (low.slope >= 0.0) return answer(low);
  // Between a falling and a rising end, whose tangents bound the minimum from below. The search ends if the better end
  // is within kPassingErrorMm of that bound. The next part is, in turns, the slopes' secant for a smooth minimum, the
  // tangents' meeting place for a crease, and the middle.
  constexpr int kMostPasses = 60;
  for (int i = 0; i < kMostPasses; ++i) {
    const double width = high.part - low.part;
    const double meet = (high.slope * width - (high.distance - low.distance)) / (high.slope - low.slope);
    const double floor = low.distance + low.slope * meet;
    const OnTheWay& best = low.distance <= high.distance ? low : high;
    if (best.distance - floor <= kPassingErrorMm) return answer(best);
    double step = i % 3 == 0 ? width * (-low.slope / (high.slope - low.slope)) : i % 3 == 1 ? meet : 0.5 * width;
    if (!(step > 0.0 && step < width)) step = 0.5 * width;
    const OnTheWay next = at(low.part + step);
    (next.slope <= 0.0 ? low : high) = next;
  }
  return answer(low.distance <= high.distance ? low : high);
}

double holder_distance(const Bur& bur, Vec3 axis, Vec3 from_pivot, Vec3& gradient) noexcept {
  const ByHead place = by_axis(axis, from_pivot);
  OnHalf on_half{0.0, 1.0};
  double distance = cylinder_distance(0.0, bur.neck_length_mm, bur.neck_radius_mm, place.at, on_half);
  if (bur.shank_length_mm > 0.0) {
    OnHalf of_shank;
    const double shank = cylinder_distance(bur.neck_length_mm, bur.neck_length_mm + bur.shank_length_mm,
                                           bur.shank_radius_mm, place.at, of_shank);
    if (shank < distance) {
      distance = shank;
      on_half = of_shank;
    }
  }
  gradient = in_space(axis, place, on_half);
  return distance;
}

}  // namespace cusp::engine
