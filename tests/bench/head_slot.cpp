#include "tests/bench/head_slot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/engine/step/cut_along.h"

namespace cusp::bench {

namespace {

constexpr double kQuarterTurn = std::numbers::pi / 2.0;
constexpr double kSlotMm = 0.8, kSlotShare = 0.55;  // depth: the least of both
constexpr double kHalfSlotMm = 2.5;
constexpr double kMillStepMm = 0.1;
constexpr double kWallStep = std::numbers::pi / 360.0;  // between two walls' normals: 9 nm of the clearance
constexpr double kLongestMoveMm = 0.01;                 // of the proxy between two linearisations
constexpr int kMostMoves = 300;
constexpr int kAround = 36;

}  // namespace

HeadSlot slot_of(const Bur& bur, Vec3 axis) {
  const HeadCurve head(bur);
  HeadSlot out;
  out.axis = axis;
  const double length_mm = glm::dot(head.furthest(axis, axis) - head.furthest(-axis, axis), axis);
  const double deep = std::min(kSlotMm, kSlotShare * length_mm);
  const double under = -glm::dot(head.furthest(-out.frame.z, axis), out.frame.z);
  out.pivot = out.frame.origin + out.frame.z * (under - deep);
  out.from_mm = -kHalfSlotMm;
  out.to_mm = kHalfSlotMm;
  out.entry_mm = (deep + 0.3) / glm::dot(axis, out.frame.z);
  return out;
}

bool mill(StepState& state, const HeadSlot& slot) {
  bool room = true;
  const auto along = [&](Vec3 from, Vec3 to) {
    const int parts = static_cast<int>(std::ceil(length(to - from) / kMillStepMm));
    for (int k = 0; k < parts; ++k)
      room = test::cut_along(state, 0, from + (to - from) * (static_cast<double>(k) / parts),
                             from + (to - from) * (static_cast<double>(k + 1) / parts)) &&
             room;
  };
  along(slot.above(), slot.at(slot.from_mm));
  along(slot.at(slot.from_mm), slot.at(slot.to_mm));
  return room;
}

SlotTruth::SlotTruth(const HeadSlot& slot, const Bur& bur, double thinner_mm)
    : slot_(slot), head_(bur), thinner_(thinner_mm), axis_(slot.axis) {
  add_side(1.0);
  add_side(-1.0);
}

/// In the cross-section, from the face's plane on one side (0) down (-90 degrees) or up.
Vec3 SlotTruth::across(double angle, double side) const {
  return slot_.frame.y * (side * std::cos(angle)) + slot_.frame.z * std::sin(angle);
}

/// The angle at which the milled head has a straight line of its outline as its silhouette; beyond a quarter: none.
double SlotTruth::kink_of(double normal_angle, double side, double root) const {
  const double level = glm::dot(across(0.0, side), slot_.axis), upright = glm::dot(slot_.frame.z, slot_.axis);
  const double most = std::hypot(level, upright), share = std::cos(normal_angle) / most;
  if (std::fabs(share) > 1.0) return 10.0;
  return std::remainder(std::atan2(upright, level) + root * std::acos(share), 2.0 * std::numbers::pi);
}

void SlotTruth::add_side(double side) {
  const Vec3 origin = slot_.frame.origin;
  // The silhouette rises with the angle; its height passes the face at the slot's edge.
  double low = -kQuarterTurn, high = kQuarterTurn;
  for (int i = 0; i < 55; ++i) {
    const double middle = 0.5 * (low + high);
    const Vec3 n = across(middle, side);
    const double height = glm::dot(slot_.pivot + head_.furthest(n, slot_.axis) - origin, slot_.frame.z);
    (height < 0.0 ? low : high) = middle;
  }
  std::vector<double> angles{low};
  for (double angle = -kQuarterTurn; angle < low; angle += kWallStep) angles.push_back(angle);
  for (const double normal : head_.straight_normals())
    for (const double root : {-1.0, 1.0}) {
      const double kink = kink_of(normal, side, root);
      if (kink > -kQuarterTurn && kink < low) angles.push_back(kink);
    }
  const auto level = [&](Vec3 n) { return glm::dot(n, slot_.pivot + head_.furthest(n, slot_.axis)); };
  for (const double angle : angles) {
    const Vec3 n = across(angle, side);
    walls_.push_back({n, level(n) + thinner_, {}});
  }
  const Vec3 n = across(low, side);
  const double out = (level(n) - glm::dot(n, origin)) / std::cos(low);
  edges_[side > 0.0 ? 0 : 1] = origin + slot_.frame.y * (side * out);
  steepness_ = std::min(steepness_, low + kQuarterTurn);
}

void SlotTruth::turn_to(Vec3 axis) {
  if (axis == axis_ && turned_) return;
  axis_ = axis;
  turned_ = true;
  for (Wall& wall : walls_) wall.furthest = head_.furthest(wall.n, axis);
}

Vec3 SlotTruth::place(Vec3 pivot) { return proxy_ = pivot; }

bool SlotTruth::below_face(const Wall& wall, Vec3 pivot) const {
  return glm::dot(pivot + wall.furthest - slot_.frame.origin, slot_.frame.z) <= 0.0;
}

/// The head's supporting line nearest to one of the slot's edges. gap: from the thin head to the edge, negative inside.
HalfSpace SlotTruth::edge_space(Vec3 edge, Vec3 pivot, double& gap) const {
  constexpr double kPart = 2.0 * std::numbers::pi / kAround;
  const auto height = [&](double angle) {
    const Vec3 n = across(angle, 1.0);
    return glm::dot(n, edge - pivot - head_.furthest(n, axis_));
  };
  double best = 0.0, most = -1e300;
  for (int i = 0; i < kAround; ++i)
    if (const double here = height(kPart * i); here > most) {
      most = here;
      best = kPart * i;
    }
  double low = best - kPart, high = best + kPart;
  for (int i = 0; i < 45; ++i) {
    const double middle = 0.5 * (low + high);
    const Vec3 along = across(middle + kQuarterTurn, 1.0);
    (glm::dot(along, edge - pivot - head_.furthest(across(middle, 1.0), axis_)) > 0.0 ? low : high) = middle;
  }
  const Vec3 n = across(0.5 * (low + high), 1.0);
  const double level = glm::dot(n, edge - head_.furthest(n, axis_)) + thinner_;
  gap = level - glm::dot(n, pivot);
  return {-n, -level, Mat3(0.0)};
}

void SlotTruth::constraints(Vec3 pivot) {
  spaces_.clear();
  for (const Wall& wall : walls_)
    if (below_face(wall, pivot)) spaces_.push_back({-wall.n, glm::dot(wall.n, wall.furthest) - wall.level, Mat3(0.0)});
  double gap = 0.0;
  for (const Vec3& edge : edges_) spaces_.push_back(edge_space(edge, pivot, gap));
}

Exact SlotTruth::move_to(Vec3 device, double precision) {
  proxy_ += slot_.frame.x * glm::dot(device - proxy_, slot_.frame.x);
  const Vec3 from = proxy_;
  for (int move = 0; move < kMostMoves; ++move) {
    constraints(proxy_);
    const Vec3 step = nearest_in(device, Mat3(1.0), spaces_).c - proxy_;
    const double moved = length(step);
    proxy_ += step * std::min(1.0, kLongestMoveMm / std::max(moved, 1e-300));
    if (moved < precision) break;
  }
  fits_ = clearance_mm(proxy_) > -kFitsMm;
  if (!fits_) proxy_ = from;
  return {proxy_, length(proxy_ - device) > 1e-9, false};
}

double SlotTruth::clearance_mm(Vec3 pivot) const {
  double least = 1e300, gap = 0.0;
  for (const Wall& wall : walls_)
    if (below_face(wall, pivot)) least = std::min(least, wall.level - glm::dot(wall.n, pivot + wall.furthest));
  for (const Vec3& edge : edges_) {
    edge_space(edge, pivot, gap);
    least = std::min(least, gap);
  }
  return least;
}

}  // namespace cusp::bench
