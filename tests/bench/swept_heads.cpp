#include "tests/bench/swept_heads.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/bench/half_spaces.h"

namespace cusp::bench {

namespace {

constexpr std::int32_t kLeaf = 4;         // sweeps
constexpr int kHalvings = 12;             // of a sweep: a tick's is 5 um long
constexpr double kSeenMm = 0.06;          // skin further out than this bears no constraint in a pass
constexpr int kPasses = 60;
constexpr double kFirstMoveMm = 0.01, kShrink = 0.9;  // longest move of a pass: 0.1 mm in all
constexpr double kAdmissibleMm = 3e-4;    // beyond the clearance
constexpr double kRestMm = 1e-5;

}  // namespace

std::vector<Vec3> skin_of(const Bur& bur, Vec3 axis) {
  std::vector<OnHalf> outline;
  for (int i = 0; i < bur.head.size(); ++i) {
    const OutlinePiece& p = bur.head.piece(i);
    const double first = std::atan2(p.from.rho - p.centre.rho, p.from.t - p.centre.t);
    const double last = std::atan2(p.to.rho - p.centre.rho, p.to.t - p.centre.t);
    const double whole = p.radius > 0.0 ? std::fabs(last - first) * p.radius : std::hypot(p.to.t - p.from.t, p.to.rho - p.from.rho);
    const int parts = std::max(2, static_cast<int>(std::ceil(whole / kSkinMm)));
    for (int k = 0; k <= parts; ++k) {
      const double share = static_cast<double>(k) / parts, angle = first + (last - first) * share;
      outline.push_back(p.radius > 0.0 ? OnHalf{p.centre.t + p.radius * std::cos(angle), p.centre.rho + p.radius * std::sin(angle)}
                                       : OnHalf{p.from.t + (p.to.t - p.from.t) * share, p.from.rho + (p.to.rho - p.from.rho) * share});
    }
  }
  const Frame frame = Frame::of(axis, Vec3(0.31, 0.77, 0.11), Vec3(0.0));
  std::vector<Vec3> out;
  for (const OnHalf& o : outline) {
    const int round = std::max(1, static_cast<int>(std::ceil(2.0 * std::numbers::pi * o.rho / kSkinMm)));
    for (int k = 0; k < round; ++k) {
      const double phi = 2.0 * std::numbers::pi * k / round;
      out.push_back(frame.direction({o.rho * std::cos(phi), o.rho * std::sin(phi), o.t}));
    }
  }
  return out;
}

SweptHeads::SweptHeads(const Bur& bur, std::vector<HeadSweep> sweeps, const Frame& face)
    : bur_(bur), curve_(bur), sweeps_(std::move(sweeps)), face_(face), axis_(sweeps_.front().axis) {
  build(0, static_cast<std::int32_t>(sweeps_.size()));
}

std::int32_t SweptHeads::build(std::int32_t first, std::int32_t count) {
  const auto from = sweeps_.begin() + first, end = from + count;
  Vec3 low(1e300), high(-1e300);
  for (auto s = from; s != end; ++s) {
    low = glm::min(low, glm::min(s->a, s->b));
    high = glm::max(high, glm::max(s->a, s->b));
  }
  const auto number = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back({0.5 * (low + high), 0.0, first, count, -1, -1});
  for (auto s = from; s != end; ++s) {
    const double turned = length(s->axis - axis_) * bur_.head.reach();
    const double away = std::max(length(s->a - nodes_.back().centre), length(s->b - nodes_.back().centre));
    nodes_.back().radius = std::max(nodes_.back().radius, away + turned);
  }
  if (count <= kLeaf) return number;
  const Vec3 wide = high - low;
  const int across = wide.x >= wide.y && wide.x >= wide.z ? 0 : wide.y >= wide.z ? 1 : 2;
  std::nth_element(from, from + count / 2, end,
                   [across](const HeadSweep& s, const HeadSweep& t) { return s.a[across] + s.b[across] < t.a[across] + t.b[across]; });
  const std::int32_t left = build(first, count / 2), right = build(first + count / 2, count - count / 2);
  Node& node = nodes_[static_cast<std::size_t>(number)];
  node.left = left;
  node.right = right;
  return number;
}

/// Signed distance of a place to the head at a pivot. A convex head lies behind each of its nearest places.
double SweptHeads::head_mm(Vec3 place, Vec3 pivot, Vec3 axis, Vec3& outwards) const {
  const Vec3 from_pivot = place - pivot;
  const Vec3 skin = curve_.nearest(from_pivot, axis);
  const Vec3 off = from_pivot - skin;
  const double far = length(off);
  const Vec3 inside = axis * (0.5 * (bur_.head.low() + bur_.head.high()));
  const double sign = glm::dot(off, skin - inside) < 0.0 ? -1.0 : 1.0;
  outwards = far > 1e-12 ? off * (sign / far) : unit(skin - inside);
  return sign * far;
}

/// The least along the way, on which the distance to a convex head is convex; any value above `enough` if it is above.
double SweptHeads::passing_mm(Vec3 place, const HeadSweep& sweep, double enough, Vec3& outwards) const {
  const Vec3 way = sweep.b - sweep.a;
  Vec3 at_a, at_b;
  const double a = head_mm(place, sweep.a, sweep.axis, at_a);
  if (a - length(way) > enough) return a;
  const double b = head_mm(place, sweep.b, sweep.axis, at_b);
  // Moving on by d changes the distance by -outwards . d.
  if (glm::dot(at_a, way) <= 0.0 || glm::dot(at_b, way) >= 0.0) {
    outwards = a < b ? at_a : at_b;
    return std::min(a, b);
  }
  double low = 0.0, high = 1.0, least = std::min(a, b);
  outwards = a < b ? at_a : at_b;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    Vec3 there;
    const double d = head_mm(place, sweep.a + way * middle, sweep.axis, there);
    if (d < least) {
      least = d;
      outwards = there;
    }
    (glm::dot(there, way) > 0.0 ? low : high) = middle;
  }
  return least;
}

void SweptHeads::nearest(std::int32_t number, Vec3 place, double& least, Vec3& outwards) const {
  if (least <= -kFarMm) return;
  const Node& node = nodes_[static_cast<std::size_t>(number)];
  if (node.left < 0) {
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      Vec3 there;
      const double d = passing_mm(place, sweeps_[static_cast<std::size_t>(i)], least, there);
      if (d >= least) continue;
      least = d;
      outwards = there;
    }
    return;
  }
  const auto bound = [&](std::int32_t child) {
    Vec3 there;
    const Node& of = nodes_[static_cast<std::size_t>(child)];
    return head_mm(place, of.centre, axis_, there) - of.radius;
  };
  const double left = bound(node.left), right = bound(node.right);
  const bool left_first = left <= right;
  if (std::min(left, right) < least) nearest(left_first ? node.left : node.right, place, least, outwards);
  if (std::max(left, right) < least) nearest(left_first ? node.right : node.left, place, least, outwards);
}

double SweptHeads::depth_mm(Vec3 place, Vec3& inwards) const {
  const double under = -glm::dot(place - face_.origin, face_.z);
  inwards = -face_.z;
  double least = under;
  nearest(0, place, least, inwards);
  return least;
}

double SweptHeads::deepest_mm(Vec3 pivot, Vec3 axis) const {
  double most = -1e300;
  Vec3 inwards;
  for (const Vec3& skin : skin_of(bur_, axis)) most = std::max(most, depth_mm(pivot + skin, inwards));
  return most;
}

std::optional<Vec3> SweptHeads::proxy_from(Vec3 from, Vec3 axis, Vec3 device, double thinner_mm) const {
  std::vector<Vec3> skin = skin_of(bur_, axis);
  Vec3 inwards;
  std::erase_if(skin, [&](Vec3 s) { return depth_mm(from + s, inwards) <= -kFarMm; });
  Vec3 at = from;
  double longest = kFirstMoveMm;
  for (int pass = 0; pass < kPasses; ++pass, longest *= kShrink) {
    std::vector<HalfSpace> spaces;
    for (const Vec3& s : skin) {
      const double depth = depth_mm(at + s, inwards);
      if (depth > -kSeenMm) spaces.push_back({-inwards, depth - thinner_mm - glm::dot(inwards, at), Mat3(0.0)});
    }
    const Vec3 step = nearest_in(device, Mat3(1.0), spaces).c - at;
    const double moved = length(step);
    at += step * std::min(1.0, longest / std::max(moved, 1e-300));
    if (moved < kRestMm) break;
  }
  double deepest = -1e300;
  for (const Vec3& s : skin) deepest = std::max(deepest, depth_mm(at + s, inwards));
  if (deepest > thinner_mm + kAdmissibleMm) return std::nullopt;
  return at;
}

}  // namespace cusp::bench
