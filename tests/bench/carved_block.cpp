#include "tests/bench/carved_block.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/frame.h"

namespace cusp::bench {

namespace {

constexpr double kTouch = 1e-9;      // mm: a point this close to a face lies on it
constexpr double kEdgeStep = 0.005;  // mm between points of an edge
constexpr double kSlack = 0.012;     // mm: features beyond this cannot become active within one step ...
constexpr double kTrust = 0.004;     // ... of this length
constexpr double kNear = 0.08;       // mm: edge points are gathered this far beyond touch
constexpr double kConformal = 0.02;  // mm: a bur with less play than this touches a capsule all round
constexpr int kRing = 64;

Vec3 on_axis(const Capsule& c, Vec3 p) {
  const Vec3 d = c.b - c.a;
  return c.a + d * std::clamp(glm::dot(p - c.a, d) / glm::dot(d, d), 0.0, 1.0);
}

/// Directions across an axis, z.
const std::vector<Vec3>& ring() {
  static const std::vector<Vec3> all = [] {
    std::vector<Vec3> out;
    for (int k = 0; k < kRing; ++k) {
      const double phi = 6.283185307179586 * k / kRing;
      out.push_back({std::cos(phi), std::sin(phi), 0.0});
    }
    return out;
  }();
  return all;
}

/// Directions of the half sphere about z, 9 degrees apart, without the ring.
const std::vector<Vec3>& dome() {
  static const std::vector<Vec3> all = [] {
    std::vector<Vec3> out;
    constexpr int kRows = 10;
    for (int row = 1; row <= kRows; ++row) {
      const double lift = 1.5707963267948966 * row / kRows;
      const int columns = std::max(1, static_cast<int>(4 * kRows * std::cos(lift)));
      for (int k = 0; k < columns; ++k) {
        const double phi = 6.283185307179586 * k / columns;
        out.push_back({std::cos(phi) * std::cos(lift), std::sin(phi) * std::cos(lift), std::sin(lift)});
      }
    }
    return out;
  }();
  return all;
}

/// x and y across a capsule, z along it.
Frame frame_of(const Capsule& c, Vec3 at) {
  const Vec3 along = unit(c.b - c.a);
  return Frame::of(along, std::fabs(along.z) < 0.8 ? Vec3(0, 0, 1) : Vec3(1, 0, 0), at);
}

}  // namespace

CarvedBlock::CarvedBlock(Vec3 normal, double level, std::vector<Capsule> capsules, double radius_mm, double thinner_mm)
    : normal_(normal),
      level_(level),
      capsules_(std::move(capsules)),
      radius_(radius_mm),
      cut_radius_(radius_mm - thinner_mm) {
  for (const Capsule& c : capsules_) frames_.push_back(frame_of(c, Vec3(0.0)));
  const int n = static_cast<int>(capsules_.size());
  for (int i = 0; i < n; ++i)
    for (int j = -1; j < i; ++j) trace_pair(i, j);
}

double CarvedBlock::void_depth(int face, Vec3 p, Vec3* gradient) const {
  if (face < 0) {
    if (gradient) *gradient = normal_;
    return glm::dot(normal_, p) - level_;
  }
  const Capsule& c = capsules_[static_cast<std::size_t>(face)];
  const Vec3 d = p - on_axis(c, p);
  const double far = length(d);
  if (gradient) *gradient = far > 1e-12 ? -d / far : Vec3(0.0);
  return c.radius_mm - far;
}

bool CarvedBlock::remains(Vec3 p, int face_a, int face_b) const {
  for (int f = -1; f < static_cast<int>(capsules_.size()); ++f)
    if (f != face_a && f != face_b && void_depth(f, p, nullptr) > kTouch) return false;
  return true;
}

bool CarvedBlock::project_onto(int face_a, int face_b, Vec3& p) const {
  for (int pass = 0; pass < 20; ++pass) {
    Vec3 ga, gb;
    const double da = void_depth(face_a, p, &ga), db = void_depth(face_b, p, &gb);
    if (std::fabs(da) < 1e-13 && std::fabs(db) < 1e-13) return true;
    const double ab = glm::dot(ga, gb), det = 1.0 - ab * ab;
    if (det < 1e-6) return false;
    p -= ga * ((da - ab * db) / det) + gb * ((db - ab * da) / det);
  }
  return std::fabs(void_depth(face_a, p, nullptr)) < 1e-11 && std::fabs(void_depth(face_b, p, nullptr)) < 1e-11;
}

void CarvedBlock::trace_pair(int face_a, int face_b) {
  // Seeds: the sign of the other face changes between neighbours of a net over the capsule.
  const Capsule& c = capsules_[static_cast<std::size_t>(face_a)];
  const Frame f = frame_of(c, c.a);
  const double whole = length(c.b - c.a);
  constexpr int kAroundCapsule = 48, kCap = 8;
  const int along = static_cast<int>(whole / 0.05) + 2;
  const int rows = along + 2 * kCap;
  const auto at = [&](int row, int column) {
    const double phi = 6.283185307179586 * column / kAroundCapsule;
    double z = 0.0, rho = c.radius_mm;
    if (row < kCap || row >= kCap + along) {
      const double lift = row < kCap ? 1.5707963 * (kCap - row) / kCap : 1.5707963 * (row - kCap - along + 1) / kCap;
      rho = c.radius_mm * std::cos(lift);
      z = row < kCap ? -c.radius_mm * std::sin(lift) : whole + c.radius_mm * std::sin(lift);
    } else {
      z = whole * (row - kCap) / (along - 1);
    }
    return f.to_world({rho * std::cos(phi), rho * std::sin(phi), z});
  };
  const std::size_t first = edges_.size();
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < kAroundCapsule; ++column) {
      const Vec3 p = at(row, column);
      const bool here = void_depth(face_b, p, nullptr) > 0.0;
      for (const Vec3 other : {at(row, (column + 1) % kAroundCapsule), at(std::min(row + 1, rows - 1), column)}) {
        if ((void_depth(face_b, other, nullptr) > 0.0) == here) continue;
        Vec3 seed = 0.5 * (p + other);
        if (!project_onto(face_a, face_b, seed)) continue;
        if (length(seed - p) > 0.2 || !remains(seed, face_a, face_b)) continue;
        bool known = false;
        for (std::size_t k = first; k < edges_.size() && !known; ++k)
          known = length(edges_[k].at - seed) < 1.5 * kEdgeStep;
        if (!known) trace(face_a, face_b, seed);
      }
    }
}

void CarvedBlock::trace(int face_a, int face_b, Vec3 seed) {
  const auto step = [&](Vec3& p, double way) {
    Vec3 ga, gb;
    void_depth(face_a, p, &ga);
    void_depth(face_b, p, &gb);
    const Vec3 t = glm::cross(ga, gb);
    const double size = length(t);
    if (size < 1e-3) return false;
    Vec3 next = p + t * (way / size);
    if (!project_onto(face_a, face_b, next)) return false;
    p = next;
    return true;
  };
  /// End of the edge between a remaining point and a removed one.
  const auto last_remaining = [&](Vec3 good, Vec3 bad) {
    for (int k = 0; k < 50; ++k) {
      Vec3 middle = 0.5 * (good + bad);
      if (!project_onto(face_a, face_b, middle)) break;
      (remains(middle, face_a, face_b) ? good : bad) = middle;
    }
    return good;
  };
  std::vector<Vec3> points{seed};
  for (const double way : {kEdgeStep, -kEdgeStep}) {
    Vec3 p = seed;
    for (int k = 0; k < 20000; ++k) {
      const Vec3 from = p;
      if (!step(p, way)) break;
      if (!remains(p, face_a, face_b)) {
        points.push_back(last_remaining(from, p));
        break;
      }
      if (way > 0.0 && k > 3 && length(p - seed) < 0.9 * kEdgeStep) {
        store_edge(points, Curve::closed);
        return;
      }
      points.push_back(p);
    }
    std::reverse(points.begin(), points.end());  // the second reversal restores the order
  }
  store_edge(points, Curve::open);
}

void CarvedBlock::store_edge(const std::vector<Vec3>& points, Curve curve) {
  const bool closed = curve == Curve::closed;
  const int first = static_cast<int>(edges_.size()), n = static_cast<int>(points.size());
  for (int i = 0; i < n; ++i) {
    EdgePoint e{points[static_cast<std::size_t>(i)], first + i - 1, first + i + 1};
    if (i == 0) e.before = closed ? first + n - 1 : -1;
    if (i == n - 1) e.after = closed ? first : -1;
    edges_.push_back(e);
  }
}

Vec3 CarvedBlock::refined(int i, Vec3 centre) const {
  const EdgePoint& e = edges_[static_cast<std::size_t>(i)];
  if (e.before < 0 || e.after < 0) return e.at;
  const Vec3 p = edges_[static_cast<std::size_t>(e.before)].at, r = edges_[static_cast<std::size_t>(e.after)].at;
  // A parabola through the three, by its chord lengths, and the foot on it.
  const double back = -length(e.at - p), on = length(r - e.at);
  const Vec3 u = (p - e.at) / back, v = (r - e.at) / on;
  const Vec3 second = (v - u) / (on - back);  // p(s) = at + s (u - back second) + s^2 second
  const Vec3 slope = u - second * back;
  double s = 0.0;
  for (int k = 0; k < 4; ++k) {
    const Vec3 at = e.at + s * slope + s * s * second - centre;
    const Vec3 d = slope + 2.0 * s * second;
    const double bend = glm::dot(d, d) + 2.0 * glm::dot(at, second);
    if (bend < 1e-9) return e.at;  // no single foot: the bur lies at the centre of curvature
    s = std::clamp(s - glm::dot(at, d) / bend, back, on);
  }
  return e.at + s * slope + s * s * second;
}

CarvedBlock::Nearest CarvedBlock::nearest(Vec3 centre) const {
  const int n = static_cast<int>(capsules_.size());
  double in_air = -1e300;
  for (int f = -1; f < n; ++f) in_air = std::max(in_air, void_depth(f, centre, nullptr));
  // In tissue the nearest convex void gives the exact distance.
  if (in_air <= 0.0) return {in_air - radius_, false};
  Nearest best{1e300, false};
  for (int f = -1; f < n; ++f) {
    Vec3 g;
    const double far = void_depth(f, centre, &g);
    if (far <= 0.0 || glm::dot(g, g) < 0.5) continue;
    if (!remains(centre - g * far, f, f)) continue;
    best.clearance = std::min(best.clearance, far - (f < 0 ? radius_ : cut_radius_));
  }
  double least = 1e300;
  int which = -1;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Vec3 d = edges_[i].at - centre;
    const double far = glm::dot(d, d);
    if (far < least) {
      least = far;
      which = static_cast<int>(i);
    }
  }
  if (which >= 0) {
    const double far = length(refined(which, centre) - centre) - cut_radius_;
    if (far < best.clearance - 1e-9) best = {far, true};
  }
  return best;
}

double CarvedBlock::clearance_mm(Vec3 centre) const { return nearest(centre).clearance; }
bool CarvedBlock::edge_nearest(Vec3 centre) const { return nearest(centre).edge; }

void CarvedBlock::gather(Vec3 y) {
  if (length(y - near_centre_) < kNear - kSlack - kEdgeStep) return;
  near_.clear();
  near_centre_ = y;
  const double reach = cut_radius_ + kNear;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Vec3 d = edges_[i].at - y;
    if (glm::dot(d, d) < reach * reach) near_.push_back(static_cast<int>(i));
  }
}

bool CarvedBlock::add_point(const Contact& contact, Vec3 y, std::vector<HalfSpace>& out) const {
  const Vec3 d = y - contact.at;
  const double far = length(d);
  if (far > contact.radius + kSlack || far < 1e-9) return false;
  const Vec3 n = d / far;
  out.push_back({n, glm::dot(n, contact.at) + contact.radius, Mat3(0.0)});
  if (contact.normal == Normal::turning) out.back().bend = (glm::outerProduct(n, n) - Mat3(1.0)) / far;
  return true;
}

void CarvedBlock::add_face(int face, Vec3 y, std::vector<HalfSpace>& out) const {
  Vec3 g;
  const double far = void_depth(face, y, &g);
  const double radius = face < 0 ? radius_ : cut_radius_;
  if (far <= 0.0 || far >= radius + kSlack || glm::dot(g, g) <= 0.5) return;
  const Vec3 foot = y - g * far;
  if (!remains(foot, face, face)) return;
  HalfSpace h{g, glm::dot(g, foot) + radius, Mat3(0.0)};
  if (face >= 0) {
    const Capsule& c = capsules_[static_cast<std::size_t>(face)];
    const Vec3 axis = on_axis(c, y), t = unit(c.b - c.a);
    h.bend = Mat3(1.0) - glm::outerProduct(g, g);
    if (axis != c.a && axis != c.b) h.bend -= glm::outerProduct(t, t);
    h.bend /= std::max(1e-6, length(y - axis));
  }
  out.push_back(h);
}

void CarvedBlock::add_fitting_capsule(int face, Vec3 y, std::vector<HalfSpace>& out) const {
  const Capsule& c = capsules_[static_cast<std::size_t>(face)];
  const Frame& frame = frames_[static_cast<std::size_t>(face)];
  const Vec3 axis = on_axis(c, y);
  const auto touch = [&](Vec3 direction, double side) {
    const Vec3 p = axis + c.radius_mm * frame.direction({direction.x, direction.y, side * direction.z});
    if (remains(p, face, face)) add_point({p, cut_radius_, Normal::fixed}, y, out);
  };
  for (const Vec3& u : ring()) touch(u, 1.0);
  for (const double side : {-1.0, 1.0})
    if (length(axis - (side < 0.0 ? c.a : c.b)) <= 1e-12)
      for (const Vec3& u : dome()) touch(u, side);
}

void CarvedBlock::add_edge(int point, Vec3 y, std::vector<HalfSpace>& out) const {
  const EdgePoint& e = edges_[static_cast<std::size_t>(point)];
  const Vec3 d = e.at - y;
  const double far2 = glm::dot(d, d);
  const double reach = cut_radius_ + kSlack;
  if (far2 > reach * reach) return;
  const Contact itself{e.at, cut_radius_, Normal::turning};
  if (e.before < 0 || e.after < 0) {
    add_point(itself, y, out);
    return;
  }
  const Vec3 before = edges_[static_cast<std::size_t>(e.before)].at, after = edges_[static_cast<std::size_t>(e.after)].at;
  const bool foot = far2 <= glm::dot(before - y, before - y) && far2 <= glm::dot(after - y, after - y);
  // share: how far y lies towards the centre of the edge's own curvature, where every point of the edge is as near.
  // Near that centre the points stand for the edge; elsewhere the foot does, which moves with y.
  const Vec3 curvature = (after + before - 2.0 * e.at) / (0.25 * glm::dot(after - before, after - before));
  const double share = glm::dot(curvature, y - e.at);
  if (!foot || share > 0.9 || !add_point({refined(point, y), cut_radius_, Normal::turning}, y, out)) {
    add_point(itself, y, out);
    return;
  }
  HalfSpace& h = out.back();
  const Vec3 tangent = after - before;
  const Vec3 t = unit(tangent - h.n * glm::dot(h.n, tangent));
  h.bend += glm::outerProduct(t, t) * ((1.0 + share / (1.0 - share)) / std::sqrt(far2));
}

void CarvedBlock::constraints(Vec3 y, std::vector<HalfSpace>& out) const {
  out.clear();
  for (int f = -1; f < static_cast<int>(capsules_.size()); ++f) {
    if (void_depth(f, y, nullptr) <= 0.0) continue;
    const bool fits = f >= 0 && capsules_[static_cast<std::size_t>(f)].radius_mm - cut_radius_ <= kConformal;
    // A capsule as wide as the bur touches it all round, and one foot does not describe that.
    fits ? add_fitting_capsule(f, y, out) : add_face(f, y, out);
  }
  for (const int i : near_) add_edge(i, y, out);
}

Vec3 CarvedBlock::settle(Vec3 from, Vec3 q, double precision_mm) {
  constexpr int kPassesAtMost = 400;
  Vec3 y = from;
  for (int pass = 0; pass < kPassesAtMost; ++pass) {
    gather(y);
    constraints(y, spaces_);
    Mat3 metric = Mat3(1.0) + bend_;
    // Near an edge that the device point has almost passed there is no minimum; the plain metric continues.
    if (glm::determinant(metric) < 0.05 || metric[0][0] < 0.05 || metric[1][1] < 0.05 || metric[2][2] < 0.05)
      metric = Mat3(1.0);
    const Mat3 inverse = glm::inverse(metric);
    const Vec3 z = y + inverse * (q - y);
    const Found found = nearest_in(z, inverse, spaces_);
    const Vec3 way = found.c - y;
    const double far = length(way);
    bend_ = found.bend;
    // If two active sets alternate, half steps converge.
    const double share = pass < 40 ? 1.0 : 0.5;
    y = far > kTrust ? y + way * (kTrust / far) : y + way * share;
    if (far < precision_mm) break;
  }
  return y;
}

}  // namespace cusp::bench
