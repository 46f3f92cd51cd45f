#include "tests/bench/swept_surface.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/frame.h"

namespace cusp::bench {

namespace {

constexpr double kFlat2 = 1e-6;       // square of the sine between two faces: below, they are one
constexpr double kFarSeedMm = 0.03;   // a seed that Newton moves further belongs to another edge
constexpr int kMostTries = 3;
constexpr int kMostSteps = 20000;     // of an edge, each way

std::uint64_t key_of(IVec3 c) {
  const auto part = [](int v) { return static_cast<std::uint64_t>(v + (1 << 20)) & 0x1fffff; };
  return part(c.x) | part(c.y) << 21 | part(c.z) << 42;
}
std::uint64_t pair_of(int a, int b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint32_t>(std::max(a, b));
}

}  // namespace

IVec3 PointGrid::cell_of(Vec3 p) { return IVec3(glm::floor(p / kCellMm)); }
std::uint64_t PointGrid::key(IVec3 cell) { return key_of(cell); }

SweptSurface::SweptSurface(SweptPath path, const Region& region) : path_(std::move(path)), region_(region) {
  Vec3 low(1e300), high(-1e300);
  for (std::size_t i = 0; i < path_.size(); ++i) {
    const Sweep& s = path_.sweep(static_cast<int>(i));
    low = glm::min(low, glm::min(s.a, s.b));
    high = glm::max(high, glm::max(s.a, s.b));
  }
  low_ = low - path_.radius_mm() - kSurfelMm;
  constexpr double kBlock = 32.0 * kSurfelMm;
  const Vec3 size = high - low_ + path_.radius_mm() + kSurfelMm;
  for (double z = 0.5 * kBlock; z < size.z + kBlock; z += kBlock)
    for (double y = 0.5 * kBlock; y < size.y + kBlock; y += kBlock)
      for (double x = 0.5 * kBlock; x < size.x + kBlock; x += kBlock)
        add_surfels(low_ + Vec3(x, y, z), 0.5 * kBlock, -1);
  seed_edges();
  trace_all();
  surfels_of_cell_.clear();
  points_of_pair_.clear();
  region_ = nullptr;
  for (std::size_t i = 0; i < surfels_.size(); ++i) surfel_grid_.add(surfels_[i].at, static_cast<int>(i));
  for (std::size_t i = 0; i < edges_.size(); ++i) edge_grid_.add(edges_[i].at, static_cast<int>(i));
}

void SweptSurface::add_surfels(Vec3 middle, double half, int guess) {
  if (region_(middle) < -1.7321 * half) return;
  SweptPath::Deepest deepest = path_.deepest(middle, guess);
  if (std::fabs(deepest.mm) > 1.7321 * half) return;
  if (half > 0.6 * kSurfelMm) {
    for (int i = 0; i < 8; ++i) {
      const double h = 0.5 * half;
      add_surfels(middle + Vec3(i & 1 ? h : -h, i & 2 ? h : -h, i & 4 ? h : -h), h, deepest.sweep);
    }
    return;
  }
  Vec3 at = middle;
  for (int pass = 0; pass < 8 && std::fabs(deepest.mm) > 1e-12; ++pass) {
    Vec3 inwards;
    path_.depth(deepest.sweep, at, &inwards);
    at -= inwards * deepest.mm;
    deepest = path_.deepest(at, deepest.sweep);
  }
  if (std::fabs(deepest.mm) > 1e-9 || length(at - middle) > 2.0 * kSurfelMm || region_(at) < 0.0) return;
  surfels_of_cell_[key_of(IVec3(glm::floor((at - low_) / kSurfelMm)))].push_back(static_cast<int>(surfels_.size()));
  surfels_.push_back({at, deepest.sweep});
}

void SweptSurface::seed_edges() {
  for (const Surfel& s : surfels_) {
    const IVec3 cell(glm::floor((s.at - low_) / kSurfelMm));
    for (int k = 0; k < 27; ++k) {
      const auto found = surfels_of_cell_.find(key_of(cell + IVec3(k % 3, k / 3 % 3, k / 9) - 1));
      if (found == surfels_of_cell_.end()) continue;
      for (const int other : found->second) {
        const Surfel& o = surfels_[static_cast<std::size_t>(other)];
        if (o.sweep > s.sweep) seeds_.push_back({s.sweep, o.sweep, 0.5 * (s.at + o.at), 0});
      }
    }
  }
}

void SweptSurface::trace_all() {
  while (!seeds_.empty()) {
    const Seed seed = seeds_.back();
    seeds_.pop_back();
    try_seed(seed);
  }
}

void SweptSurface::try_seed(const Seed& seed) {
  Vec3 p = seed.at;
  if (seed.a == seed.b || !project_onto(seed.a, seed.b, p) || length(p - seed.at) > kFarSeedMm) return;
  if (region_(p) < 0.0 || known(seed.a, seed.b, p)) return;
  if (remains(p, seed.a, seed.b)) {
    trace(seed.a, seed.b, p);
  } else if (seed.tries < kMostTries) {
    const int taker = path_.deepest(p).sweep;
    seeds_.push_back({seed.a, taker, p, seed.tries + 1});
    seeds_.push_back({seed.b, taker, p, seed.tries + 1});
  }
}

bool SweptSurface::project_onto(int a, int b, Vec3& p) const {
  for (int pass = 0; pass < 20; ++pass) {
    Vec3 ga, gb;
    const double da = path_.depth(a, p, &ga), db = path_.depth(b, p, &gb);
    if (std::fabs(da) < 1e-13 && std::fabs(db) < 1e-13) return true;
    const double ab = glm::dot(ga, gb), det = 1.0 - ab * ab;
    if (det < kFlat2) return false;
    p -= ga * ((da - ab * db) / det) + gb * ((db - ab * da) / det);
  }
  return std::fabs(path_.depth(a, p, nullptr)) < 1e-11 && std::fabs(path_.depth(b, p, nullptr)) < 1e-11;
}

bool SweptSurface::known(int a, int b, Vec3 p) const {
  const auto found = points_of_pair_.find(pair_of(a, b));
  if (found == points_of_pair_.end()) return false;
  return std::ranges::any_of(found->second, [&](int i) {
    return length(edges_[static_cast<std::size_t>(i)].at - p) < 1.5 * kEdgeStepMm;
  });
}

std::vector<Vec3> SweptSurface::walk(int a, int b, Vec3 from, double way, bool& closed) {
  std::vector<Vec3> points;
  Vec3 p = from;
  for (int k = 0; k < kMostSteps; ++k) {
    Vec3 ga, gb, next = p;
    path_.depth(a, p, &ga);
    path_.depth(b, p, &gb);
    const Vec3 tangent = glm::cross(ga, gb);
    const double size = length(tangent);
    if (size < std::sqrt(kFlat2)) break;
    next += tangent * (way / size);
    if (!project_onto(a, b, next) || length(next - p) > 3.0 * kEdgeStepMm || region_(next) < 0.0) break;
    if (!remains(next, a, b)) {
      Vec3 good = p, bad = next;
      for (int half = 0; half < 50; ++half) {
        Vec3 middle = 0.5 * (good + bad);
        if (!project_onto(a, b, middle)) break;
        (remains(middle, a, b) ? good : bad) = middle;
      }
      points.push_back(good);
      const int taker = path_.deepest(next).sweep;
      seeds_.push_back({a, taker, good, 0});
      seeds_.push_back({b, taker, good, 0});
      break;
    }
    if (way > 0.0 && k > 3 && length(next - from) < 0.9 * kEdgeStepMm) {
      closed = true;
      break;
    }
    points.push_back(next);
    p = next;
  }
  return points;
}

void SweptSurface::trace(int a, int b, Vec3 from) {
  bool closed = false;
  const std::vector<Vec3> on = walk(a, b, from, kEdgeStepMm, closed);
  std::vector<Vec3> points;
  if (!closed) points = walk(a, b, from, -kEdgeStepMm, closed);
  std::ranges::reverse(points);
  points.push_back(from);
  points.insert(points.end(), on.begin(), on.end());
  store(a, b, points, closed);
}

void SweptSurface::store(int a, int b, const std::vector<Vec3>& points, bool closed) {
  const int first = static_cast<int>(edges_.size()), n = static_cast<int>(points.size());
  std::vector<int>& of_pair = points_of_pair_[pair_of(a, b)];
  for (int i = 0; i < n; ++i) {
    EdgePoint e{points[static_cast<std::size_t>(i)], first + i - 1, first + i + 1};
    if (i == 0) e.before = closed ? first + n - 1 : -1;
    if (i == n - 1) e.after = closed ? first : -1;
    of_pair.push_back(static_cast<int>(edges_.size()));
    edges_.push_back(e);
  }
}

SweptSurface::Foot SweptSurface::foot(int i, Vec3 centre) const {
  const auto at_of = [this](int k) { return edges_[static_cast<std::size_t>(k)].at; };
  const EdgePoint* e = &edges_[static_cast<std::size_t>(i)];
  if ((e->before < 0) != (e->after < 0)) e = &edges_[static_cast<std::size_t>(std::max(e->before, e->after))];
  const Vec3 at = e->at;
  if (e->before < 0 && e->after < 0) return {at, Vec3(0.0), Vec3(0.0), false};
  if (e->before < 0 || e->after < 0) {
    const Sweep line{at, at_of(std::max(e->before, e->after))};
    const Vec3 place = nearest_on(line, centre);
    return {place, line.b - line.a, Vec3(0.0), place != line.a && place != line.b};
  }
  // A parabola through the three, by its chord lengths, and the foot on it.
  const Vec3 p = at_of(e->before), r = at_of(e->after);
  const double back = -length(at - p), on = length(r - at);
  if (back > -1e-9 || on < 1e-9) return {at, r - p, Vec3(0.0), false};
  const Vec3 u = (p - at) / back, v = (r - at) / on;
  const Vec3 second = (v - u) / (on - back);
  const Vec3 slope = u - second * back;
  double s = 0.0;
  for (int k = 0; k < 4; ++k) {
    const Vec3 off = at + s * slope + s * s * second - centre;
    const Vec3 d = slope + 2.0 * s * second;
    const double bend = glm::dot(d, d) + 2.0 * glm::dot(off, second);
    if (bend < 1e-9) return {at, slope, 2.0 * second, false};
    s = std::clamp(s - glm::dot(off, d) / bend, back, on);
  }
  return {at + s * slope + s * s * second, slope + 2.0 * s * second, 2.0 * second, s > back && s < on};
}

}  // namespace cusp::bench
