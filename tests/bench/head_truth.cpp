#include "tests/bench/head_truth.h"

#include <algorithm>

namespace cusp::bench {

namespace {

/// In a sub-step the device moves by a few micrometres. A proxy that moves this far has changed its minimum.
constexpr double kHeadVanishedMm = 0.05;
constexpr Vec3 kAnyAxis(0.0, 0.0, 1.0);

HeadCurve neck_of(const Bur& bur) {
  const double from = bur.head.ball() ? bur.radius_mm : bur.head.high();
  return HeadCurve::cylinder(bur.neck_radius_mm, from, std::max(bur.neck_length_mm, from + 0.01));
}

HeadCurve shank_of(const Bur& bur) {
  return HeadCurve::cylinder(bur.shank_radius_mm, bur.neck_length_mm, bur.neck_length_mm + bur.shank_length_mm);
}

}  // namespace

void HeadTruth::start(Vec3 pivot, Vec3 axis) {
  turn_to(axis);
  device_ = pivot;
  axis_ = axis;
  exact_ = {place(pivot), false, false};
}

Exact HeadTruth::follow(Vec3 device, Vec3 axis) {
  const Vec3 device_from = device_, axis_from = axis_;
  bool vanished = false;
  for (int k = 1; k <= kTurnSubSteps; ++k) {
    const double share = static_cast<double>(k) / kTurnSubSteps;
    const bool last = k == kTurnSubSteps;
    turn_to(last ? axis : unit(axis_from + (axis - axis_from) * share));
    const Exact now = move_to(device_from + (device - device_from) * share, last ? kFine : kCoarse);
    vanished = vanished || (now.contact && exact_.contact && length(now.pose_mm - exact_.pose_mm) > kHeadVanishedMm);
    exact_ = now;
  }
  device_ = device;
  axis_ = axis;
  exact_.vanished = vanished;
  return exact_;
}

ConvexTruth::ConvexTruth(const ConvexTissue& tissue, const Bur& bur)
    : head_(tissue, HeadCurve(bur), kAnyAxis),
      neck_(tissue, neck_of(bur), kAnyAxis),
      shank_(tissue, shank_of(bur), kAnyAxis) {}

void ConvexTruth::turn_to(Vec3 axis) {
  head_.turn_to(axis);
  neck_.turn_to(axis);
  shank_.turn_to(axis);
}

Vec3 ConvexTruth::place(Vec3 pivot) {
  normal_ = head_.separating(pivot);
  return pivot;
}

Exact ConvexTruth::move_to(Vec3 device, double precision) {
  normal_ = head_.settle(normal_, device, precision);
  const double depth = head_.depth_mm(normal_, device);
  if (depth <= 0.0) return {device, false, false};
  return {device + normal_ * depth, true, false};
}

bool ConvexTruth::is_clear(const ConvexContact& part) const {
  const Vec3 pivot = exact().pose_mm;
  // The tissue lies below the contact's plane, so a part above it needs no search.
  return part.depth_mm(normal_, pivot) < -kShankMm || part.clearance_mm(pivot, normal_) > kShankMm;
}

bool ConvexTruth::is_valid() const { return is_clear(neck_) && is_clear(shank_); }

}  // namespace cusp::bench
