#include "tests/bench/cavity_truth.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/frame.h"

namespace cusp::bench {

namespace {

constexpr double kTrustMm = 0.004;   // of one Newton step
constexpr double kSlackMm = 0.012;   // features beyond this cannot become active within one step
constexpr double kNearMm = 0.08;     // features are gathered this far beyond touch
constexpr double kFitsMm = 0.02;     // a ball with less play touches a wall all round
constexpr double kFootMm = 0.015;    // a foot that remains has a surfel of its sweep this close
constexpr double kSurfelUnderMm = 1e-6;  // a surfel lies this far below the feet, so that it turns no normal
constexpr double kSubStepMm = 0.002;
constexpr double kTurnsShare = 0.8;  // of the way to the centre of an edge's curvature: beyond, its points stand for it
constexpr double kMilledFreeMm = 1e-9;
constexpr double kJumpMm = 0.05;     // more than a sub-step moves along a surface
constexpr int kPasses = 200;

}  // namespace

CavityTruth::CavityTruth(std::shared_ptr<const SweptSurface> surface, double bur_radius_mm, double thinner_mm)
    : surface_(std::move(surface)),
      radius_(bur_radius_mm - thinner_mm),
      fits_(std::fabs(surface_->path().radius_mm() - radius_) <= kFitsMm) {}

void CavityTruth::gather(Vec3 centre, Near& near) const {
  near.centre = centre;
  near.sweeps.clear();
  near.surfels.clear();
  near.edges.clear();
  const double reach = radius_ + kNearMm;
  const auto within = [&](Vec3 p) {
    const Vec3 d = p - centre;
    return glm::dot(d, d) <= reach * reach;
  };
  surface_->surfel_grid().about(centre, reach, [&](int i) {
    const SweptSurface::Surfel& s = surface_->surfels()[static_cast<std::size_t>(i)];
    if (!within(s.at)) return;
    near.surfels.push_back(i);
    near.sweeps.push_back(s.sweep);
  });
  std::ranges::sort(near.sweeps);
  near.sweeps.erase(std::unique(near.sweeps.begin(), near.sweeps.end()), near.sweeps.end());
  surface_->edge_grid().about(centre, reach, [&](int i) {
    if (within(surface_->edge_points()[static_cast<std::size_t>(i)].at)) near.edges.push_back(i);
  });
}

double CavityTruth::clearance_mm(Vec3 centre) const {
  const SweptPath& path = surface_->path();
  const SweptPath::Deepest deepest = path.deepest(centre);
  if (deepest.mm <= 0.0) return deepest.mm - radius_;
  // The deepest sweep's foot is tissue or further off.
  Near near;
  gather(centre, near);
  double least = radius_ + kNearMm;
  for (const int i : near.surfels) least = std::min(least, length(surface_->surfels()[static_cast<std::size_t>(i)].at - centre));
  for (const int sweep : near.sweeps) {
    Vec3 inwards;
    const double far = path.depth(sweep, centre, &inwards);
    if (far > 0.0 && far < least && glm::dot(inwards, inwards) > 0.5 && surface_->remains(centre - inwards * far, sweep, sweep)) least = far;
  }
  for (const int i : near.edges) least = std::min(least, length(surface_->foot(i, centre).at - centre));
  return least - radius_;
}

void CavityTruth::start(Vec3 centre) {
  Truth::start(centre);
  y_ = device_ = centre;
  bend_ = Mat3(0.0);
}

Exact CavityTruth::follow(Vec3 device) {
  Exact out;
  const int steps = std::clamp(static_cast<int>(std::ceil(length(device - device_) / kSubStepMm)), 1, kSubSteps);
  for (int k = 1; k <= steps; ++k) {
    const Exact now = move_to(device_ + (device - device_) * (static_cast<double>(k) / steps), k < steps ? kCoarseMm : kFineMm);
    out.pose_mm = now.pose_mm;
    out.contact = now.contact;
    out.vanished = out.vanished || now.vanished;
  }
  device_ = device;
  keep(out);
  return out;
}

Exact CavityTruth::move_to(Vec3 device, double precision_mm) {
  const Vec3 before = y_;
  y_ = settle(device, precision_mm);
  return {y_, length(y_ - device) > kMilledFreeMm, length(y_ - before) > kJumpMm + length(device - device_)};
}

bool CavityTruth::add_point(Vec3 at, double radius_mm, Vec3 y, Normal normal) {
  const Vec3 d = y - at;
  const double far = length(d);
  if (far > radius_mm + kSlackMm || far < 1e-9) return false;
  const Vec3 n = d / far;
  spaces_.push_back({n, glm::dot(n, at) + radius_mm, Mat3(0.0)});
  if (normal == Normal::turning) spaces_.back().bend = (glm::outerProduct(n, n) - Mat3(1.0)) / far;
  return true;
}

void CavityTruth::add_wall(int sweep, Vec3 y) {
  Vec3 inwards;
  const SweptPath& path = surface_->path();
  const double far = path.depth(sweep, y, &inwards);
  if (far <= 0.0 || far >= radius_ + kSlackMm || glm::dot(inwards, inwards) <= 0.5) return;
  const Vec3 foot = y - inwards * far;
  if (!surface_->remains(foot, sweep, sweep)) return;
  HalfSpace h{inwards, glm::dot(inwards, foot) + radius_, Mat3(0.0)};
  const Sweep& s = path.sweep(sweep);
  const Vec3 axis = nearest_on(s, y);
  h.bend = Mat3(1.0) - glm::outerProduct(inwards, inwards);
  if (axis != s.a && axis != s.b) {
    const Vec3 t = unit(s.b - s.a);
    h.bend -= glm::outerProduct(t, t);
  }
  h.bend /= std::max(1e-6, length(y - axis));
  spaces_.push_back(h);
}

void CavityTruth::add_edge(int point, Vec3 y) {
  const SweptSurface::EdgePoint& e = surface_->edge_points()[static_cast<std::size_t>(point)];
  const auto square_to = [&](int i) {
    if (i < 0) return 1e300;
    const Vec3 d = surface_->edge_points()[static_cast<std::size_t>(i)].at - y;
    return glm::dot(d, d);
  };
  const double far2 = square_to(point), reach = radius_ + kSlackMm;
  if (far2 > reach * reach) return;
  const bool nearest = far2 <= square_to(e.before) && far2 <= square_to(e.after);
  const SweptSurface::Foot foot = surface_->foot(point, y);
  // share: how far y lies towards the centre of the edge's own curvature, where every point of the edge is as near.
  const double share = glm::dot(foot.curvature, y - foot.at);
  // A point with a nearer neighbour only bounds the way along the edge, and Newton's steps along it would halve.
  if (!nearest && share < kTurnsShare) return;
  if (!nearest || share > 0.9) {
    add_point(e.at, radius_, y, Normal::turning);
    return;
  }
  if (!add_point(foot.at, radius_, y, Normal::turning) || !foot.inside) return;
  HalfSpace& h = spaces_.back();
  const Vec3 t = unit(foot.tangent - h.n * glm::dot(h.n, foot.tangent));
  h.bend += glm::outerProduct(t, t) * ((1.0 + share / (1.0 - share)) / std::sqrt(far2));
}

/// The normal at a foot turns within the play of the ball. Surfels all round bound the step; only the feet are exact.
void CavityTruth::add_fitting_walls(Vec3 y) {
  walls_.clear();
  for (const int i : near_.surfels) {
    const SweptSurface::Surfel& s = surface_->surfels()[static_cast<std::size_t>(i)];
    if (!add_point(s.at, radius_ - kSurfelUnderMm, y, Normal::fixed)) continue;
    Vec3 inwards;
    const double far = surface_->path().depth(s.sweep, y, &inwards);
    const Vec3 off = y - inwards * far - s.at;
    if (glm::dot(off, off) < kFootMm * kFootMm) walls_.push_back(s.sweep);
  }
  std::ranges::sort(walls_);
  walls_.erase(std::unique(walls_.begin(), walls_.end()), walls_.end());
  for (const int sweep : walls_) add_wall(sweep, y);
}

void CavityTruth::constraints(Vec3 y) {
  if (length(y - near_.centre) > kNearMm - kSlackMm - SweptSurface::kEdgeStepMm) gather(y, near_);
  spaces_.clear();
  if (fits_) {
    add_fitting_walls(y);
  } else {
    for (const int sweep : near_.sweeps) add_wall(sweep, y);
  }
  for (const int i : near_.edges) add_edge(i, y);
}

Vec3 CavityTruth::settle(Vec3 q, double precision_mm) {
  Vec3 y = y_;
  for (int pass = 0; pass < kPasses; ++pass) {
    constraints(y);
    Mat3 metric = Mat3(1.0) + bend_;
    // Near an edge that the device point has almost passed there is no minimum; the plain metric continues.
    if (glm::determinant(metric) < 0.05 || metric[0][0] < 0.05 || metric[1][1] < 0.05 || metric[2][2] < 0.05)
      metric = Mat3(1.0);
    const Mat3 inverse = glm::inverse(metric);
    const Found found = nearest_in(y + inverse * (q - y), inverse, spaces_);
    const Vec3 way = found.c - y;
    const double far = length(way);
    bend_ = found.bend;
    // If two active sets alternate, shorter steps converge.
    const double share = pass < 30 ? 1.0 : pass < 80 ? 0.5 : 0.25;
    y = far > kTrustMm ? y + way * (kTrustMm / far) : y + way * share;
    if (far < precision_mm) break;
  }
  return y;
}

}  // namespace cusp::bench
