#include "tests/bench/head_courses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/contact/surface_contact.h"
#include "tests/bench/shapes.h"

namespace cusp::bench {

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr double kHeadSphereMm = 4.0;
constexpr double kSphereConeDeg = 45.0;
constexpr double kInsideMm = 0.6;      // of a ray's start, below each face of an edge or a corner
constexpr double kOverTopMm = 0.8;     // from there over an edge's top
constexpr double kDownSideMm = 2.0;    // and down its side; half a short head
constexpr double kAlongEdgeMm = 2.0;   // to either side of the middle
constexpr double kDiscMm = 2.5;        // radius of the places on a face
constexpr double kClearMm = 0.1;       // of the pivots that a ray finds: their normal does not jump
constexpr double kStartMm = 0.05;      // clearance at the end of a way in
constexpr double kTippedSine = 0.01;   // of a normal that a stable place brings back, this much deeper than a press:
constexpr double kStableOver = 1.25;   // at radius equal to depth any error would grow without bound
constexpr double kAwayMm = 6.0;        // of a pivot between two places
constexpr double kSlotPushMm = 0.2;    // of the device point beyond the milled line
constexpr double kSlotMarginMm = 0.3;  // of the head from the slot's ends
constexpr double kSlotTiltDeg = 12.0;  // of the milling axis, at most

Vec3 in_cone(Random& random, double half_angle_deg) {
  const double z = random.between(std::cos(half_angle_deg * kRadPerDeg), 1.0),
               phi = random.between(0.0, 2.0 * std::numbers::pi);
  const double rho = std::sqrt(1.0 - z * z);
  return {rho * std::cos(phi), rho * std::sin(phi), z};
}

/// Only its distance is used: specimen_of builds and keeps specimens by Shape.
class Solid : public Shape {
 public:
  explicit Solid(const ConvexTissue& tissue)
      : Shape("convex-" + std::to_string(static_cast<int>(tissue.kind)), 0.0), tissue_(tissue) {}
  double distance_mm(Vec3 p) const override { return tissue_.distance_mm(p); }
  double half_mm() const override { return tissue_.kind == ConvexKind::sphere ? tissue_.radius_mm + 0.1 : 0.0; }
  Vec3 tool_axis() const override { return tissue_.frame.z; }
  Vec3 home() const override { return tissue_.frame.z; }
  std::unique_ptr<Truth> truth() const override { return nullptr; }
  Spot spot(Random&) const override { return {}; }
  Leg leg(Random&, const Vec3*) const override { return {}; }
  Vec3 before(Vec3 first) const override { return first; }

 private:
  ConvexTissue tissue_;
};

struct Ray {
  Vec3 from{0.0}, towards{0.0};
};

/// Way points on a convex tissue, each a ray out of it. face: x and y. edge: x, and y as the length over the edge.
/// sphere and corner: a direction.
class Places {
 public:
  Places(const ConvexTissue& tissue, const Bur& bur) : tissue_(tissue), radius_(bur.radius_mm) {
    const double head = bur.head.ball() ? 2.0 * bur.radius_mm : bur.head.high() - bur.head.low();
    down_ = std::max(std::min(kDownSideMm, 0.5 * head) - kInsideMm, 0.0);
  }
  Vec3 any(Random& random) const {
    switch (tissue_.kind) {
      case ConvexKind::face: {
        const double rho = kDiscMm * std::sqrt(random.between(0.0, 1.0)),
                     phi = random.between(0.0, 2.0 * std::numbers::pi);
        return {rho * std::cos(phi), rho * std::sin(phi), 0.0};
      }
      case ConvexKind::edge:
        return {random.between(-kAlongEdgeMm, kAlongEdgeMm), random.between(-kOverTopMm, quarter() + down_), 0.0};
      case ConvexKind::sphere:
        return in_cone(random, kSphereConeDeg);
      case ConvexKind::corner:
        return glm::abs(in_cone(random, 90.0));
    }
    return {};
  }
  double length_mm(Vec3 a, Vec3 b) const {
    if (is_flat()) return length(b - a);
    const double reach = tissue_.radius_mm > 0.0 ? tissue_.radius_mm + radius_ : 2.0 * kInsideMm + radius_;
    return reach * std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
  }
  Vec3 between(Vec3 a, Vec3 b, double share) const {
    if (is_flat()) return a + (b - a) * share;
    const double angle = std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
    if (angle < 1e-9) return a;
    return (a * std::sin((1.0 - share) * angle) + b * std::sin(share * angle)) / std::sin(angle);
  }
  Ray ray(Vec3 u) const {
    const Frame& f = tissue_.frame;
    switch (tissue_.kind) {
      case ConvexKind::face:
        return {f.to_world({u.x, u.y, -1.0}), f.z};
      case ConvexKind::sphere:
        return {f.origin, f.direction(u)};
      case ConvexKind::corner:
        return {f.to_world(Vec3(-kInsideMm)), f.direction(u)};
      case ConvexKind::edge:
        break;
    }
    const double back = std::min(u.y, 0.0), down = std::max(u.y - quarter(), 0.0);
    const double angle = std::clamp(u.y / quarter(), 0.0, 1.0) * std::numbers::pi / 2.0;
    return {f.to_world({u.x, -kInsideMm + back, -kInsideMm - down}),
            f.direction({0.0, std::sin(angle), std::cos(angle)})};
  }

 private:
  bool is_flat() const { return tissue_.kind == ConvexKind::face || tissue_.kind == ConvexKind::edge; }
  double quarter() const { return std::numbers::pi / 2.0 * (kInsideMm + radius_); }
  ConvexTissue tissue_;
  double radius_, down_ = 0.0;
};

class ConvexCourse : public HeadCourse {
 public:
  ConvexCourse(const ConvexTissue& tissue, const Bur& bur, std::uint64_t seed)
      : tissue_(tissue),
        bur_(bur),
        head_(tissue, HeadCurve(bur), tissue.frame.z),
        places_(tissue, bur),
        random_(seed),
        from_(places_.any(random_)),
        to_(places_.any(random_)) {}
  Vec3 rest_axis() const override { return tissue_.frame.z; }
  std::shared_ptr<const Specimen> specimen(double voxel_mm) const override {
    return specimen_of(Solid(tissue_), voxel_mm, Reading::banded);
  }
  std::unique_ptr<HeadTruth> truth() const override { return std::make_unique<ConvexTruth>(tissue_, bur_); }
  AxisMotion axis_motion(std::string_view kind, std::uint64_t seed) const override {
    return {kind, tissue_.frame, AxisMotion::Span::cone, seed};
  }
  std::vector<Vec3> way_in(Vec3 axis) const override {
    const Ray ray = places_.ray(from_);
    const Vec3 start = on_ray(ray, axis, kStartMm);
    return {start + ray.towards * kAwayMm, start};
  }
  Vec3 next(Vec3 axis, double per_tick_mm) override {
    const Vec3 before = at(axis);
    if (begun_) done_ += per_tick_mm * scale_;
    begun_ = true;
    while (done_ >= places_.length_mm(from_, to_)) {
      done_ -= places_.length_mm(from_, to_);
      from_ = to_;
      to_ = places_.any(random_);
    }
    const Vec3 out = at(axis);
    // A length over the tissue is longer or shorter for a wide head.
    const double moved = length(out - before);
    if (moved > 0.0) scale_ = std::clamp(scale_ * std::clamp(per_tick_mm / moved, 0.8, 1.25), 0.05, 5.0);
    return out;
  }
  /// On a rim or a narrow curve the device would tip off to one side: such a place is drawn anew.
  Spot spot(Vec3 axis, Random& random) const override {
    ConvexContact head = head_;
    head.turn_to(axis);
    for (;;) {
      const Vec3 pivot = on_ray(places_.ray(places_.any(random)), axis, kStartMm);
      const Vec3 n = head.separating(pivot), touching = pivot - n * kStartMm;
      const Vec3 aside = random.in(Vec3(-1.0), Vec3(1.0)) * kTippedSine;
      const Vec3 back = head.settle(tissue_.normal_near(n + aside), touching - n * (kStableOver * kDepthMm), 1e-9);
      if (length(back - n) < 1e-3 * kTippedSine) return {touching, n};
    }
  }

 private:
  Vec3 on_ray(const Ray& ray, Vec3 axis, double clearance) const {
    ConvexContact head = head_;
    head.turn_to(axis);
    return head.on_ray(ray.from, ray.towards, clearance);
  }
  Vec3 at(Vec3 axis) const {
    const double whole = places_.length_mm(from_, to_);
    const Ray ray = places_.ray(places_.between(from_, to_, whole > 0.0 ? std::min(done_ / whole, 1.0) : 0.0));
    return on_ray(ray, axis, kClearMm) - ray.towards * (kClearMm + kDepthMm);
  }

  ConvexTissue tissue_;
  Bur bur_;
  ConvexContact head_;
  Places places_;
  Random random_;
  Vec3 from_, to_;
  double done_ = 0.0, scale_ = 1.0;
  bool begun_ = false;
};

/// The bur enters by the shaft and slides in its slot, pushed against the walls and the floor in turn.
class SlotCourse : public HeadCourse {
 public:
  SlotCourse(const Bur& bur, std::uint64_t seed)
      : bur_(bur),
        random_(seed),
        slot_(slot_of(bur, unit(unit(oblique_frame().direction(in_cone(random_, kSlotTiltDeg)))))),
        steepest_(std::min(SlotTruth(slot_, bur, 0.0).least_steepness() - 5.0 * kRadPerDeg, 70.0 * kRadPerDeg)),
        low_(slot_.from_mm + 2.0 * bur.radius_mm + kSlotMarginMm),
        high_(slot_.to_mm - kSlotMarginMm),
        from_(any()),
        to_(any()) {}
  Vec3 rest_axis() const override { return slot_.axis; }
  std::shared_ptr<const Specimen> specimen(double voxel_mm) const override {
    return specimen_of(Solid(ConvexTissue{}), voxel_mm, Reading::banded);
  }
  std::unique_ptr<HeadTruth> truth() const override {
    return std::make_unique<SlotTruth>(slot_, bur_, SurfaceContact::kHeadClearanceMm);
  }
  AxisMotion axis_motion(std::string_view kind, std::uint64_t seed) const override {
    return {kind, Frame::of(slot_.axis, slot_.frame.x, slot_.pivot), AxisMotion::Span::slot, seed};
  }
  bool prepare(StepState& state) const override { return mill(state, slot_); }
  std::vector<Vec3> way_in(Vec3) const override {
    return {slot_.above() + slot_.axis, slot_.at(slot_.from_mm), slot_.at(from_.along_mm)};
  }
  Vec3 next(Vec3, double per_tick_mm) override {
    if (begun_) done_ += per_tick_mm;
    begun_ = true;
    while (done_ >= span()) {
      done_ -= span();
      from_ = to_;
      to_ = any();
    }
    const double share = done_ / span();
    const double angle = from_.angle + (to_.angle - from_.angle) * share;
    const Vec3 push = slot_.frame.y * std::sin(angle) - slot_.frame.z * std::cos(angle);
    return slot_.at(from_.along_mm + (to_.along_mm - from_.along_mm) * share) + push * kSlotPushMm;
  }

 private:
  struct Place {
    double along_mm = 0.0;
    double angle = 0.0;  // of the push from straight down, radians
  };
  Place any() { return {random_.between(low_, high_), random_.between(-steepest_, steepest_)}; }
  /// Of a leg: the longer of the ways along the slot and of the device point across it.
  double span() const {
    return std::max({std::fabs(to_.along_mm - from_.along_mm), kSlotPushMm * std::fabs(to_.angle - from_.angle), 1e-6});
  }

  Bur bur_;
  Random random_;
  HeadSlot slot_;
  double steepest_, low_, high_;
  Place from_, to_;
  double done_ = 0.0;
  bool begun_ = false;
};

}  // namespace

AxisMotion::AxisMotion(std::string_view kind, const Frame& rest, Span span, std::uint64_t seed)
    : kind_(kind), rest_(rest), span_(span), random_(seed) {
  const Vec3 tilt = span == Span::slot ? Vec3(0.0, 0.0, 1.0) : in_cone(random_, kConeDeg);
  base_ = axis_ = kind == "turning" ? rest.z : rest.direction(tilt);
}

Vec3 AxisMotion::tilted(double angle_deg) const {
  return rest_.z * std::cos(angle_deg * kRadPerDeg) + side_ * std::sin(angle_deg * kRadPerDeg);
}

Vec3 AxisMotion::next() {
  if (kind_ == "jitter") {
    const Vec3 off = in_cone(random_, kJitterDeg);
    const Frame about = Frame::of(base_, rest_.x, Vec3(0.0));
    axis_ = about.direction(off);
  }
  if (kind_ != "turning") return axis_;
  const double most = span_ == Span::slot ? kSlotConeDeg : kConeDeg;
  if (angle_deg_ <= 0.0) {
    const double phi = random_.between(0.0, 2.0 * std::numbers::pi);
    side_ = span_ == Span::slot ? rest_.x * (std::cos(phi) < 0.0 ? -1.0 : 1.0)
                                : rest_.x * std::cos(phi) + rest_.y * std::sin(phi);
    step_deg_ = kTurnDegS * kTickUs * 1e-6;
    angle_deg_ = 0.0;
  }
  if (angle_deg_ >= most) step_deg_ = -std::fabs(step_deg_);
  angle_deg_ += step_deg_;
  return axis_ = tilted(angle_deg_);
}

StepInput turned_input(Vec3 device_mm, Vec3 rest, Vec3 axis) {
  Sample sample;
  sample.status = Sample::Status::fresh;
  sample.position_mm = device_mm;
  const Vec3 turn = glm::cross(rest, axis);
  sample.orientation = glm::normalize(Quat(1.0 + glm::dot(rest, axis), turn.x, turn.y, turn.z));
  return quantise(sample, kTickUs, StepInput{});
}

Vec3 axis_of_input(const StepInput& input, Vec3 rest) {
  return unit(glm::normalize(Quat(input.qw, input.qx, input.qy, input.qz)) * rest);
}

std::unique_ptr<HeadCourse> make_course(std::string_view shape, const Bur& bur, std::uint64_t seed) {
  if (shape == "slot") return std::make_unique<SlotCourse>(bur, seed);
  ConvexTissue tissue;
  if (shape == "sphere") {
    tissue.kind = ConvexKind::sphere;
    tissue.radius_mm = kHeadSphereMm;
  }
  if (shape == "edge") tissue.kind = ConvexKind::edge;
  if (shape == "corner") tissue.kind = ConvexKind::corner;
  return std::make_unique<ConvexCourse>(tissue, bur, seed);
}

}  // namespace cusp::bench
