#include "tests/bench/swept_bur.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/tool/swept.h"
#include "tests/modules.h"

namespace cusp::bench {

namespace {

constexpr double kShortMm = 0.02;       // mm; at this spacing the nearest place and its neighbours give the minimum
constexpr double kStraightMm = 1e-4;    // mm; places this near to a straight line do not change the volume
constexpr double kRootCubeMm = 0.64;

constexpr double kCubeEdgeCosine = 0.95;    // a cube contains an edge if normals differ by more
constexpr int kBisections = 9;               // halvings of a column: to a thousandth of a cube
constexpr int kEdgeLevels = 1;          // halvings of a cube there

/// Gauss's rule of eight points on [0, 1].
constexpr std::array<std::array<double, 2>, 8> kGauss = {{{0.019855071751231884, 0.050614268145188130},
                                                          {0.101666761293186630, 0.111190517226687235},
                                                          {0.237233795041835507, 0.156853322938943644},
                                                          {0.408282678752175098, 0.181341891689180991},
                                                          {0.591717321247824902, 0.181341891689180991},
                                                          {0.762766204958164493, 0.156853322938943644},
                                                          {0.898333238706813370, 0.111190517226687235},
                                                          {0.980144928248768116, 0.050614268145188130}}};
constexpr int kPanels = 64;

/// The outline as monotone pieces; a ball has two quarters.
std::vector<OutlinePiece> outline_of(const Bur& bur) {
  std::vector<OutlinePiece> out;
  if (bur.head.ball()) {
    const double r = bur.radius_mm;
    out = {{{-r, 0.0}, {0.0, r}, {}, r}, {{0.0, r}, {r, 0.0}, {}, r}};
  }
  for (int i = 0; i < bur.head.size(); ++i) out.push_back(bur.head.piece(i));
  return out;
}

/// Point of a piece at u in [0, 1], and dt/du.
struct OnPiece {
  OnHalf at;
  double speed;
};
OnPiece along(const OutlinePiece& piece, double u) {
  if (piece.radius == 0.0)
    return {{piece.from.t + (piece.to.t - piece.from.t) * u, piece.from.rho + (piece.to.rho - piece.from.rho) * u},
            piece.to.t - piece.from.t};
  // The angle from the tip's direction avoids a root of the integrand at the tip.
  const auto angle = [&](OnHalf p) { return std::atan2(p.rho - piece.centre.rho, -(p.t - piece.centre.t)); };
  const double a = angle(piece.from), b = angle(piece.to), now = a + (b - a) * u;
  return {{piece.centre.t - piece.radius * std::cos(now), piece.centre.rho + piece.radius * std::sin(now)},
          piece.radius * std::sin(now) * (b - a)};
}

/// The turning points of a path.
std::vector<Vec3> without_what_is_straight(const std::vector<Vec3>& places) {
  std::vector<Vec3> out{places.front()};
  for (std::size_t from = 0; from + 1 < places.size();) {
    std::size_t to = from + 1;
    for (bool straight = true; straight && to + 1 < places.size();) {
      const Vec3 way = unit(places[to + 1] - places[from]);
      for (std::size_t i = from + 1; i <= to && straight; ++i) {
        const Vec3 off = places[i] - places[from];
        straight = length(off - way * glm::dot(off, way)) < kStraightMm && glm::dot(off, way) > 0.0;
      }
      if (straight) ++to;
    }
    out.push_back(places[to]);
    from = to;
  }
  return out;
}

/// Area of a disc of radius `widest` and of a disc of radius `rho` <= widest that slides `aside` from the same centre.
struct SlidDisc {
  double widest, rho, aside;
};
double area_of(const SlidDisc& slid) {
  const auto [wide, rho, aside] = slid;
  const double disc = std::numbers::pi * wide * wide;
  if (aside == 0.0) return disc;
  return disc + 2.0 * rho * aside + 0.5 * std::numbers::pi * rho * rho -
         (rho * std::sqrt(wide * wide - rho * rho) + wide * wide * std::asin(rho / wide));
}

}  // namespace

SweptBur::SweptBur(const Bur& bur, Vec3 axis, std::vector<Vec3> places)
    : bur_(bur), axis_(axis), places_(std::move(places)) {
  undercuts_ = bur.head.size() > 1 && bur.head.piece(1).radius == 0.0 && bur.head.piece(1).to.rho < bur.head.piece(1).from.rho;
  along_.push_back(0.0);
  for (std::size_t i = 1; i < places_.size(); ++i) along_.push_back(along_.back() + length(places_[i] - places_[i - 1]));
}

double SweptBur::head(double at, Vec3 place, Vec3& gradient) const {
  const auto next = std::upper_bound(along_.begin(), along_.end(), at);
  const auto i = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(next - along_.begin(), 1, static_cast<std::ptrdiff_t>(along_.size()) - 1));
  const double stretch = along_[i] - along_[i - 1];
  const double part = stretch > 0.0 ? std::clamp((at - along_[i - 1]) / stretch, 0.0, 1.0) : 0.0;
  return head_distance(bur_, axis_, place - (places_[i - 1] + (places_[i] - places_[i - 1]) * part), gradient);
}

void SweptBur::golden(std::size_t segment, Vec3 place, Least& least) const {
  // On a straight stretch the distance to a convex head is convex: it is least where it begins to rise.
  constexpr double kRatio = 0.6180339887498949;
  double a = along_[segment], b = along_[segment + 1];
  const Vec3 way = places_[segment + 1] - places_[segment];
  Vec3 g;
  head_distance(bur_, axis_, place - places_[segment], g);
  if (glm::dot(g, way) <= 0.0) return;  // search() has tried that end
  head_distance(bur_, axis_, place - places_[segment + 1], g);
  if (glm::dot(g, way) >= 0.0) return;
  double x = b - kRatio * (b - a), y = a + kRatio * (b - a), fx = head(x, place, g), fy = head(y, place, g);
  while (b - a > kGoldenMm) {
    if (fx < fy) {
      b = y;
      y = x;
      fy = fx;
      fx = head(x = b - kRatio * (b - a), place, g);
    } else {
      a = x;
      x = y;
      fx = fy;
      fy = head(y = a + kRatio * (b - a), place, g);
    }
  }
  const double d = head(0.5 * (a + b), place, g);
  if (d < least.distance) least = {d, 0.5 * (a + b), g};
}

void SweptBur::search(const Span& span, Vec3 place, double far, Least& least) const {
  const auto [from, to, low, high] = span;
  // The distance changes by no more than the pivot moves: below that bound nothing between can be nearer.
  const double way = along_[to] - along_[from];
  if (0.5 * (low + high - way) >= std::min(least.distance, far) || least.distance <= -far) return;
  if (to - from == 1) {
    if (way > kShortMm) golden(from, place, least);
    return;
  }
  const std::size_t middle = (from + to) / 2;
  Vec3 g;
  const double d = head_distance(bur_, axis_, place - places_[middle], g);
  if (d < least.distance) least = {d, along_[middle], g};
  const bool lower = low < high;  // the nearer half first
  if (lower) search({from, middle, low, d}, place, far, least);
  search({middle, to, d, high}, place, far, least);
  if (!lower) search({from, middle, low, d}, place, far, least);
}

double SweptBur::distance_mm(Vec3 place, Vec3& gradient, double far_mm) const {
  Vec3 g;
  const double low = head_distance(bur_, axis_, place - places_.front(), g);
  Least least{low, 0.0, g};
  const double high = head_distance(bur_, axis_, place - places_.back(), g);
  if (high < low) least = {high, along_.back(), g};
  search({0, places_.size() - 1, low, high}, place, far_mm, least);
  gradient = least.gradient;
  if (std::fabs(least.distance) >= far_mm) return least.distance;
  // Beside the least of the places.
  const auto at = std::upper_bound(along_.begin(), along_.end(), least.at - 1e-12) - along_.begin();
  for (std::ptrdiff_t i = at - 1; i <= at; ++i)
    if (i >= 0 && i + 1 < static_cast<std::ptrdiff_t>(along_.size()) &&
        along_[static_cast<std::size_t>(i) + 1] - along_[static_cast<std::size_t>(i)] <= kShortMm)
      golden(static_cast<std::size_t>(i), place, least);
  gradient = least.gradient;
  return least.distance;
}

double share_behind(Vec3 n, double level) {
  // Of the corners' pyramids (the volume under a plane in a box), with the normal's parts positive and sorted.
  std::array<double, 3> a = {std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
  const double whole = a[0] + a[1] + a[2];
  const double up = level + 0.5 * whole;  // from the lowest corner
  if (up <= 0.0) return 0.0;
  if (up >= whole) return 1.0;
  std::ranges::sort(a);
  const auto cube = [](double v) { return v > 0.0 ? v * v * v : 0.0; };
  const auto square = [](double v) { return v > 0.0 ? v * v : 0.0; };
  constexpr double kFlat = 1e-5;  // beside the largest part: as if it were none
  if (a[1] < kFlat * a[2]) return std::clamp(up / a[2] - 0.5 * (a[0] + a[1]) / a[2], 0.0, 1.0);
  if (a[0] < kFlat * a[2]) {
    const double v = up - 0.5 * a[0];
    return (square(v) - square(v - a[1]) - square(v - a[2]) + square(v - a[1] - a[2])) / (2.0 * a[1] * a[2]);
  }
  double sum = cube(up);
  for (int i = 0; i < 3; ++i) sum -= cube(up - a[static_cast<std::size_t>(i)]);
  sum += cube(up - a[0] - a[1]) + cube(up - a[0] - a[2]) + cube(up - a[1] - a[2]);
  return sum / (6.0 * a[0] * a[1] * a[2]);
}

double SweptBur::cube_mm3(const Frame& face, Vec3 middle, double half, double leaf_mm) const {
  const double corner = half * std::sqrt(3.0);
  Near here;
  here.distance = distance_mm(face.to_world(middle), here.gradient, corner);
  if (here.distance >= corner) return 0.0;
  if (here.distance <= -corner) return 8.0 * half * half * half;
  return split_mm3(face, middle, half, here.gradient, leaf_mm, kEdgeLevels);
}

double SweptBur::split_mm3(const Frame& face, Vec3 middle, double half, Vec3 gradient, double leaf_mm, int edge_levels) const {
  const double small = 0.5 * half, corner = small * std::sqrt(3.0), whole = 8.0 * small * small * small;
  std::array<Near, 8> parts;
  std::array<Vec3, 8> middles;
  bool edge = undercuts_;
  for (std::size_t i = 0; i < 8; ++i) {
    middles[i] = middle + small * Vec3(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
    parts[i].distance = distance_mm(face.to_world(middles[i]), parts[i].gradient, corner);
    if (std::fabs(parts[i].distance) < corner) edge = edge || glm::dot(parts[i].gradient, gradient) < kCubeEdgeCosine;
  }
  const bool last = half <= leaf_mm * 1.001;
  // Near an edge, and near a wall left by an edge, a tangent plane is no surface. There smaller cubes and columns are
  // used.
  const bool finer = last && edge && edge_levels > 0 && !undercuts_;
  double sum = 0.0;
  for (std::size_t i = 0; i < 8; ++i) {
    const Near& part = parts[i];
    if (part.distance >= corner) continue;
    if (part.distance <= -corner) {
      sum += whole;
    } else if (last && !finer && edge) {
      sum += columns_mm3(face, middles[i], small);
    } else if (last && !finer) {
      const Vec3 n{glm::dot(part.gradient, face.x), glm::dot(part.gradient, face.y), glm::dot(part.gradient, face.z)};
      sum += share_behind(n, -0.5 * part.distance / small) * whole;
    } else {
      sum += split_mm3(face, middles[i], small, part.gradient, finer ? 0.5 * leaf_mm : leaf_mm,
                       finer ? edge_levels - 1 : edge_levels);
    }
  }
  return sum;
}

double SweptBur::columns_mm3(const Frame& face, Vec3 middle, double half) const {
  const auto inside = [&](Vec3 local) {
    Vec3 g;
    return distance_mm(face.to_world(local), g);
  };
  // Along the axis on which the distance changes most from face to face of the cube.
  int axis = 0;
  double most = -1.0;
  for (int a = 0; a < 3; ++a) {
    Vec3 step(0.0);
    step[a] = half;
    const double change = std::fabs(inside(middle + step) - inside(middle - step));
    if (change > most) {
      most = change;
      axis = a;
    }
  }
  constexpr double kGauss2 = 0.5773502691896258;
  double sum = 0.0;
  for (int c = 0; c < 4; ++c) {
    Vec3 low = middle;
    low[(axis + 1) % 3] += (c & 1 ? kGauss2 : -kGauss2) * half;
    low[(axis + 2) % 3] += (c & 2 ? kGauss2 : -kGauss2) * half;
    Vec3 high = low;
    low[axis] -= half;
    high[axis] += half;
    double at_low = inside(low), at_high = inside(high);
    if (at_low < 0.0 && at_high < 0.0) sum += 2.0 * half;
    if ((at_low < 0.0) == (at_high < 0.0)) continue;
    const Vec3 begin = low;
    const bool low_in = at_low < 0.0;
    for (int i = 0; i < kBisections; ++i) {
      const Vec3 between = 0.5 * (low + high);
      ((inside(between) < 0.0) == low_in ? low : high) = between;
    }
    const double way = 0.5 * (low[axis] + high[axis]) - begin[axis];
    sum += low_in ? way : 2.0 * half - way;
  }
  return sum * half * half;  // of four columns, each a quarter of the face
}

double SweptBur::volume_mm3(const Frame& face, double leaf_mm) const {
  const SweptBur coarse(bur_, axis_, without_what_is_straight(places_));
  Vec3 low(1e300), high(-1e300);
  for (const Vec3& p : places_) {
    low = glm::min(low, face.to_local(p) - Vec3(head_reach(bur_)));
    high = glm::max(high, face.to_local(p) + Vec3(head_reach(bur_)));
  }
  if (low.z >= 0.0) return 0.0;
  const IVec3 n(glm::ceil((Vec3(high.x, high.y, 0.0) - low) / kRootCubeMm));
  const auto sum = [&](double leaf) {
    double mm3 = 0.0;
    IVec3 c;
    for (c.z = 0; c.z < n.z; ++c.z)
      for (c.y = 0; c.y < n.y; ++c.y)
        for (c.x = 0; c.x < n.x; ++c.x)
          mm3 += coarse.cube_mm3(face, Vec3(low.x, low.y, 0.0) + kRootCubeMm * (Vec3(c.x, c.y, -c.z) + Vec3(0.5, 0.5, -0.5)),
                                 0.5 * kRootCubeMm, leaf);
    return mm3;
  };
  const double rough = sum(leaf_mm), fine = sum(0.5 * leaf_mm);
  return fine + (fine - rough) / 3.0;
}

double upright_mm3(const Bur& bur, double deep_mm, double aside_mm) {
  const std::vector<OutlinePiece> outline = outline_of(bur);
  const double face = outline.front().from.t + deep_mm;  // of t
  double mm3 = 0.0, wide = 0.0;
  for (const OutlinePiece& piece : outline) {
    // The part of the piece that is behind the face.
    double end = 1.0;
    if (along(piece, 1.0).at.t > face) {
      double in = 0.0;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (in + end);
        (along(piece, middle).at.t <= face ? in : end) = middle;
      }
    }
    const double widest = wide;
    for (int k = 0; k < kPanels; ++k)
      for (const auto& [x, weight] : kGauss) {
        const OnPiece here = along(piece, end * (k + x) / kPanels);
        if (here.speed == 0.0) continue;
        // Convex: the outline grows to the widest place and shrinks from there.
        wide = std::max(wide, here.at.rho);
        mm3 += weight * end / kPanels * here.speed * area_of({wide, here.at.rho, aside_mm});
      }
    wide = std::max({widest, wide, along(piece, end).at.rho});
    if (end < 1.0) break;
  }
  return mm3;
}

}  // namespace cusp::bench
