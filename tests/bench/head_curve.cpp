#include "tests/bench/head_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/bench/frame.h"

namespace cusp::bench {

namespace {

/// Angle of a direction to the axis, 0 to pi.
double angle_of(OnHalf direction) { return std::atan2(std::max(direction.rho, 0.0), direction.t); }

OnHalf nearest_on_line(const OutlinePiece& line, OnHalf p) {
  const double t = line.to.t - line.from.t, rho = line.to.rho - line.from.rho;
  const double share = ((p.t - line.from.t) * t + (p.rho - line.from.rho) * rho) / (t * t + rho * rho);
  const double on = std::clamp(share, 0.0, 1.0);
  return {line.from.t + on * t, line.from.rho + on * rho};
}

double square_between(OnHalf a, OnHalf b) { return (a.t - b.t) * (a.t - b.t) + (a.rho - b.rho) * (a.rho - b.rho); }

/// The unit vector beside the axis towards `place`; any one for a place on the axis.
Vec3 beside(Vec3 place, Vec3 axis, double& t, double& rho) {
  t = glm::dot(place, axis);
  const Vec3 side = place - axis * t;
  rho = length(side);
  if (rho > 1e-13) return side / rho;
  return unit(glm::cross(axis, std::fabs(axis.x) < 0.7 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0)));
}

}  // namespace

HeadCurve::HeadCurve(const Bur& bur) {
  if (bur.head.ball()) *this = ball(bur.radius_mm);
  for (int i = 0; i < bur.head.size(); ++i) add(bur.head.piece(i));
}

HeadCurve HeadCurve::ball(double radius_mm) {
  HeadCurve out;
  out.add({{-radius_mm, 0.0}, {radius_mm, 0.0}, {0.0, 0.0}, radius_mm});
  return out;
}

HeadCurve HeadCurve::cylinder(double radius_mm, double from_mm, double to_mm) {
  HeadCurve out;
  const OnHalf low{from_mm, radius_mm}, high{to_mm, radius_mm};
  out.add({{from_mm, 0.0}, low, {}, 0.0});
  out.add({low, high, {}, 0.0});
  out.add({high, {to_mm, 0.0}, {}, 0.0});
  return out;
}

void HeadCurve::add(const OutlinePiece& o) {
  Piece piece{o, 0.0, 0.0};
  if (o.radius > 0.0) {
    piece.first = angle_of({o.from.t - o.centre.t, o.from.rho - o.centre.rho});
    piece.last = angle_of({o.to.t - o.centre.t, o.to.rho - o.centre.rho});
  } else {
    piece.first = piece.last = angle_of({o.from.rho - o.to.rho, o.to.t - o.from.t});
  }
  pieces_.push_back(piece);
}

OnHalf HeadCurve::furthest(OnHalf direction) const {
  // Along the outline from the tip the normal's angle falls from pi to 0.
  const double angle = angle_of(direction);
  for (const Piece& piece : pieces_) {
    const OutlinePiece& o = piece.outline;
    if (angle > piece.first) return o.from;
    if (angle < piece.last) continue;
    if (!(o.radius > 0.0)) return o.from;
    return {o.centre.t + o.radius * std::cos(angle), o.centre.rho + o.radius * std::sin(angle)};
  }
  return pieces_.back().outline.to;
}

OnHalf HeadCurve::nearest(OnHalf place) const {
  OnHalf best = pieces_.front().outline.from;
  double least = square_between(best, place);
  const auto take = [&](OnHalf point) {
    const double square = square_between(point, place);
    if (square >= least) return;
    least = square;
    best = point;
  };
  for (const Piece& piece : pieces_) {
    const OutlinePiece& o = piece.outline;
    take(o.to);
    if (!(o.radius > 0.0)) {
      take(nearest_on_line(o, place));
      continue;
    }
    const OnHalf off{place.t - o.centre.t, place.rho - o.centre.rho};
    const double angle = std::atan2(off.rho, off.t), far = std::hypot(off.t, off.rho);
    if (angle > piece.first || angle < piece.last || !(far > 0.0)) continue;
    take({o.centre.t + off.t * (o.radius / far), o.centre.rho + off.rho * (o.radius / far)});
  }
  return best;
}

Vec3 HeadCurve::furthest(Vec3 direction, Vec3 axis) const {
  OnHalf d;
  const Vec3 side = beside(direction, axis, d.t, d.rho);
  const OnHalf on = furthest(d);
  return axis * on.t + side * on.rho;
}

Vec3 HeadCurve::nearest(Vec3 place, Vec3 axis) const {
  OnHalf p;
  const Vec3 side = beside(place, axis, p.t, p.rho);
  const OnHalf on = nearest(p);
  return axis * on.t + side * on.rho;
}

std::vector<double> HeadCurve::straight_normals() const {
  std::vector<double> out;
  for (const Piece& piece : pieces_)
    if (!(piece.outline.radius > 0.0)) out.push_back(piece.first);
  return out;
}

}  // namespace cusp::bench
