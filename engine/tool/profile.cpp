#include "engine/tool/profile.h"

#include <cmath>

namespace cusp::engine {

namespace {

constexpr double kSameMm = 1e-7;    // two ends that meet, an arc's end on its circle: the rounding of a data file
constexpr double kEdgeSine = 1e-3;  // a larger sine of the angle between two pieces is an edge
constexpr double kOnSkinMm = 1e-9;  // up to here the lines' distance is exact to as much at a corner
constexpr double kStraight = 1e-9;  // a smaller sine of an angle is none

OnHalf operator-(OnHalf a, OnHalf b) noexcept { return {a.t - b.t, a.rho - b.rho}; }
double dot(OnHalf a, OnHalf b) noexcept { return a.t * b.t + a.rho * b.rho; }
/// Positive where b is to the left of a.
double cross(OnHalf a, OnHalf b) noexcept { return a.t * b.rho - a.rho * b.t; }
double length(OnHalf a) noexcept { return std::sqrt(dot(a, a)); }
/// Direction along an outline whose outward normal is n.
OnHalf along(OnHalf n) noexcept { return {n.rho, -n.t}; }
/// Outward normal of an outline with direction d.
OnHalf outward(OnHalf d) noexcept { return {-d.rho, d.t}; }
/// True if v lies within the turn to the right from `first` to `last`, which is half a turn at most.
bool between(OnHalf first, OnHalf v, OnHalf last) noexcept { return cross(first, v) <= 0.0 && cross(v, last) <= 0.0; }

bool finite(OnHalf a) noexcept { return std::fabs(a.t) < 1e6 && std::fabs(a.rho) < 1e6; }

}  // namespace

bool Profile::add(const OutlinePiece& piece) noexcept {
  if (count_ == kMostPieces || closed()) return false;
  if (!finite(piece.from) || !finite(piece.to) || !finite(piece.centre) || !(piece.radius >= 0.0 && piece.radius < 1e6))
    return false;
  const auto n = static_cast<std::size_t>(count_);
  const OnHalf start = count_ == 0 ? OnHalf{piece.from.t, 0.0} : pieces_[n - 1].to;
  if (length(piece.from - start) > kSameMm || piece.from.rho < 0.0 || piece.to.rho < 0.0) return false;
  Side side;
  const double chord = length(piece.to - piece.from);
  if (!(chord > kSameMm)) return false;
  if (piece.radius == 0.0) {
    const OnHalf d = piece.to - piece.from;
    side.length = chord;
    side.first = side.last = outward({d.t / chord, d.rho / chord});
    side.level = dot(side.first, piece.from);
  } else {
    const OnHalf a = piece.from - piece.centre, b = piece.to - piece.centre;
    const double la = length(a), lb = length(b);
    if (std::fabs(la - piece.radius) > kSameMm || std::fabs(lb - piece.radius) > kSameMm) return false;
    side.first = {a.t / la, a.rho / la};
    side.last = {b.t / lb, b.rho / lb};
    if (cross(side.first, side.last) > kStraight) return false;  // turns to the left, or by more than half a turn
  }
  // The solid is convex if its outline turns to the right all along and never goes back along the axis.
  if (side.first.rho < -kStraight || side.last.rho < -kStraight) return false;
  if (count_ > 0 && cross(sides_[n - 1].last, side.first) > kStraight) return false;
  pieces_[n] = piece;
  sides_[n] = side;
  add_lines(piece, side);

  if (count_ == 0) low_ = piece.from.t;
  ++count_;
  high_ = piece.to.t;
  // Along an outline the radius is the piece's, about the axis rho by the normal's part across; least at an end.
  if (piece.radius > 0.0) sharpest_ = std::fmin(sharpest_, piece.radius);
  if (side.first.rho > kStraight) sharpest_ = std::fmin(sharpest_, piece.from.rho / side.first.rho);
  if (side.last.rho > kStraight) sharpest_ = std::fmin(sharpest_, piece.to.rho / side.last.rho);
  const auto take = [this](OnHalf p) {
    wide_ = p.rho > wide_ ? p.rho : wide_;
    const double away = length(p);
    reach_ = away > reach_ ? away : reach_;
  };
  take(piece.from);
  take(piece.to);
  if (piece.radius > 0.0) {
    if (between(side.first, {0.0, 1.0}, side.last)) take({piece.centre.t, piece.centre.rho + piece.radius});
    const double from_pivot = length(piece.centre);
    if (from_pivot > 0.0 && between(side.first, piece.centre, side.last)) {
      const double more = 1.0 + piece.radius / from_pivot;
      take({piece.centre.t * more, piece.centre.rho * more});
    }
  }
  return true;
}

bool Profile::edge(int i) const noexcept {
  const auto n = static_cast<std::size_t>(i);
  return i + 1 < count_ && cross(sides_[n].last, sides_[n + 1].first) <= -kEdgeSine;
}

void Profile::add_lines(const OutlinePiece& piece, const Side& side) noexcept {
  const auto add = [&](OnHalf normal, double level) {
    // Pieces that touch share a line.
    if (line_count_ > 0 && std::fabs(cross(lines_[static_cast<std::size_t>(line_count_ - 1)].normal, normal)) < kStraight) return;
    lines_[static_cast<std::size_t>(line_count_++)] = {normal, level};
  };
  if (piece.radius == 0.0) {
    add(side.first, side.level);
    return;
  }
  // Tangents at the arc's ends, halved until two of them meet close enough to it.
  OnHalf normals[kMostOfPiece] = {side.first, side.last};
  int count = 2;
  const auto off_arc = [&] {
    const double half2 = 0.5 + 0.5 * dot(normals[0], normals[1]);  // squared cosine of half the angle between them
    return half2 > 0.0 ? piece.radius * (1.0 / std::sqrt(half2) - 1.0) : 1e300;
  };
  while (2 * count - 1 <= kMostOfPiece && off_arc() > kOffArcMm) {
    for (int i = count - 1; i > 0; --i) {
      const OnHalf a = normals[i - 1], b = normals[i], sum{a.t + b.t, a.rho + b.rho};
      const double size = length(sum);
      normals[2 * i] = b;
      // Of half a turn, the way outwards from the axis.
      normals[2 * i - 1] = size > kStraight ? OnHalf{sum.t / size, sum.rho / size} : OnHalf{0.0, 1.0};
    }
    count = 2 * count - 1;
  }
  for (int i = 0; i < count; ++i) add(normals[i], dot(normals[i], piece.centre) + piece.radius);
}

bool Profile::closed() const noexcept {
  return count_ > 0 && wide_ > 0.0 && high_ > low_ && piece(count_ - 1).to.rho <= kSameMm;
}

double Profile::arc_distance(const OutlinePiece& piece, const Side& side, OnHalf at, OnHalf& normal, bool& above) noexcept {
  const OnHalf v = at - piece.centre;
  above = between(side.first, v, side.last);
  const double away = above ? length(v) : 0.0;
  if (away > 0.0) {
    normal = {v.t / away, v.rho / away};
    return away - piece.radius;
  }
  const double first = dot(v, side.first), last = dot(v, side.last);
  normal = first >= last ? side.first : side.last;
  return (first >= last ? first : last) - piece.radius;
}

double Profile::distance(OnHalf at, OnHalf& gradient) const noexcept {
  // Inside a convex solid the distance is the largest of those to its supporting lines.
  double most = -1e300, least = 1e300;
  OnHalf nearest;  // normal of the nearest piece that the place is above
  for (int i = 0; i < count_; ++i) {
    const OutlinePiece& piece = pieces_[static_cast<std::size_t>(i)];
    const Side& side = sides_[static_cast<std::size_t>(i)];
    OnHalf normal = side.first;
    double d = 0.0;
    bool above = false;  // the nearest point lies on the piece
    if (piece.radius == 0.0) {
      d = dot(normal, at) - side.level;
      if (d > 0.0 && d < least) {
        const double on = dot(along(normal), at - piece.from);
        above = on >= 0.0 && on <= side.length;
      }
    } else {
      d = arc_distance(piece, side, at, normal, above);
    }
    if (d > most) {
      most = d;
      gradient = normal;
    }
    if (above && d > 0.0 && d < least) {
      least = d;
      nearest = normal;
    }
  }
  // On the surface the line of a smooth neighbour may have the same distance, or one larger by rounding.
  if (most <= kOnSkinMm || most == least) return most;
  // The solid is convex: where a piece is straight below, no corner is nearer.
  if (least < 1e299) {
    gradient = nearest;
    return least;
  }
  double square = 1e300;
  const auto consider = [&](OnHalf point) {
    const OnHalf v = at - point;
    const double of_point = dot(v, v);
    if (!(of_point < square)) return;
    square = of_point;
    nearest = v;
  };
  consider(piece(0).from);
  for (int i = 0; i < count_; ++i) consider(piece(i).to);
  const double away = std::sqrt(square);
  if (away > 0.0) gradient = {nearest.t / away, nearest.rho / away};
  return away;
}

bool Profile::rim(OnHalf at, double far, OnHalf& out) const noexcept {
  double least = far * far;
  bool any = false;
  for (int i = 0; i + 1 < count_; ++i) {
    if (!edge(i)) continue;
    const OnHalf d = at - piece(i).to;
    if (dot(d, d) > least) continue;
    least = dot(d, d);
    out = piece(i).to;
    any = true;
  }
  return any;
}

OnHalf Profile::support(OnHalf direction, OnHalf near) const noexcept {
  constexpr double kLevel = 1e-9;  // a point must be further than another by more than this: sine, and mm
  OnHalf best = piece(0).from;
  double most = dot(best, direction);
  for (int i = 0; i < count_; ++i) {
    const OutlinePiece& p = piece(i);
    const Side& side = sides_[static_cast<std::size_t>(i)];
    OnHalf point = p.to;
    bool flat = false;
    if (p.radius > 0.0) {
      if (between(side.first, direction, side.last))
        point = {p.centre.t + p.radius * direction.t, p.centre.rho + p.radius * direction.rho};
    } else if (std::fabs(cross(side.first, direction)) <= kLevel && dot(side.first, direction) > 0.0) {
      flat = true;
      const OnHalf way = along(side.first);
      double on = dot(way, near - p.from);
      on = on < 0.0 ? 0.0 : on > side.length ? side.length : on;
      point = {p.from.t + way.t * on, p.from.rho + way.rho * on};
    }
    const double far = dot(point, direction);
    if (!(far > most + (flat ? -kLevel : kLevel))) continue;
    most = far;
    best = point;
  }
  return best;
}

}  // namespace cusp::engine
