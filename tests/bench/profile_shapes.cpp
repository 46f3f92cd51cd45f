#include "tests/bench/profile_shapes.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/frame.h"
#include "tests/bench/profile.h"

namespace cusp::bench {

namespace {

constexpr double kFar = 100.0;   // mm: out of every box
constexpr double kAboveProfileMm = 0.05;  // mm: where a press starts, above its spot
constexpr double kProfileHomeMm = 14.0;
constexpr double kAlong = 2.0;  // mm to either side of the middle, along the shape
constexpr double kStepMm = 0.5;
constexpr double kSine30 = 0.5, kCosine30 = 0.86602540378443864676;

/// A vanished minimum lets the proxy go further than any sub-step of a slide could take it along a surface.
constexpr double kProfileVanishedMm = 0.05;

Vec2 flat(Vec3 local) { return {local.x, local.z}; }

class ProfileTruth : public Truth {
 public:
  ProfileTruth(const PlaneProfile& profile, const Frame& frame, double radius)
      : profile_(profile), frame_(frame), radius_(radius) {}
  double clearance_mm(Vec3 centre) const override {
    return profile_.distance_mm(flat(frame_.to_local(centre))) - radius_;
  }

 protected:
  Vec3 place(Vec3 centre) override {
    const Vec3 p = frame_.to_local(centre);
    held_ = profile_.distance_mm(flat(p)) < radius_;
    if (!held_) return centre;
    on_ = profile_.nearest(flat(p));
    return frame_.to_world({on_.at.x, p.y, on_.at.y});
  }
  Exact move_to(Vec3 device) override {
    const Vec3 p = frame_.to_local(device);
    const Vec2 q = flat(p);
    const bool inside = profile_.distance_mm(q) < radius_;
    bool vanished = false;
    if (held_) {
      const Vec2 before = on_.at;
      on_ = profile_.slide(on_, q);
      vanished = glm::distance(before, on_.at) > kProfileVanishedMm;
      if (glm::dot(q - on_.at, on_.normal) > 0.0) {
        held_ = inside;
        if (held_) on_ = profile_.nearest(q);
      }
    } else if (inside) {
      held_ = true;
      on_ = profile_.slide(profile_.nearest(q), q);
    }
    if (!held_) return {device, false, vanished};
    return {frame_.to_world({on_.at.x, p.y, on_.at.y}), true, vanished};
  }

 private:
  const PlaneProfile& profile_;
  const Frame& frame_;
  double radius_;
  bool held_ = false;
  PlaneProfile::On on_;
};

class ProfileShape : public Shape {
 public:
  ProfileShape(std::string name, double bur_radius_mm, std::vector<Vec2> corners, double lift_mm, Vec3 axis,
               const Frame& frame = oblique_frame())
      : Shape(std::move(name), bur_radius_mm), profile_(std::move(corners), bur_radius_mm), frame_(frame) {
    frame_.origin += frame_.z * lift_mm;
    axis_ = frame_.direction(unit(axis));
  }
  double distance_mm(Vec3 p) const override { return profile_.distance_mm(flat(frame_.to_local(p))); }
  Vec3 tool_axis() const override { return axis_; }
  Vec3 home() const override { return frame_.origin + axis_ * kProfileHomeMm; }
  std::unique_ptr<Truth> truth() const override {
    return std::make_unique<ProfileTruth>(profile_, frame_, bur_radius_mm());
  }
  Vec3 before(Vec3 first) const override {
    const Vec3 p = frame_.to_local(first);
    const PlaneProfile::On on = profile_.nearest(flat(p));
    return frame_.to_world({on.at.x, p.y, on.at.y}) + frame_.direction({on.normal.x, 0.0, on.normal.y}) * kAboveProfileMm;
  }
  /// On a straight piece, or on an arc where kDepthMm below it is still one nearest point of it.
  Spot spot(Random& random) const override {
    const auto& pieces = profile_.segments();
    for (;;) {
      const PlaneProfile::Segment& p =
          pieces[static_cast<std::size_t>(random.between(0.0, static_cast<double>(pieces.size())))];
      const double y = random.between(-kAlong, kAlong);
      if (p.arc) {
        if (bur_radius_mm() < kDepthMm + 0.02) continue;
        const double angle = random.between(p.to, p.from);
        const Vec2 n(std::cos(angle), std::sin(angle));
        const Vec2 c = p.middle + bur_radius_mm() * n;
        return {frame_.to_world({c.x, y, c.y}), frame_.direction({n.x, 0.0, n.y})};
      }
      // The part of the piece within 2 mm of the middle.
      const Vec2 d = p.b - p.a;
      const double whole = std::sqrt(glm::dot(d, d));
      if (whole < 1e-6) continue;
      const double middle = -glm::dot(p.a, d) / whole;
      const double low = std::max(0.0, middle - 2.0), high = std::min(whole, middle + 2.0);
      const double t = random.between(low, high) / whole;
      if (!(low < high)) continue;
      const Vec2 c = p.a + d * t;
      return {frame_.to_world({c.x, y, c.y}), frame_.direction({p.normal.x, 0.0, p.normal.y})};
    }
  }
  Leg leg(Random& random, const Vec3* from) const override {
    Vec3 at;
    if (from) {
      at = frame_.to_local(*from);
    } else {
      const Vec2 first = start(random);
      at = {first.x, random.between(-kAlong, kAlong), first.y};
    }
    const double y = random.between(-kAlong, kAlong);
    std::vector<Vec3> way{at};
    const std::vector<Vec2> to = way_on(random, flat(at));
    for (std::size_t i = 0; i < to.size(); ++i)
      way.push_back(
          {to[i].x, at.y + (y - at.y) * static_cast<double>(i + 1) / static_cast<double>(to.size()), to[i].y});
    std::vector<double> upto{0.0};
    for (std::size_t i = 1; i < way.size(); ++i) upto.push_back(upto.back() + length(way[i] - way[i - 1]));
    const double whole = upto.back();
    return {whole, [way = std::move(way), upto = std::move(upto), frame = frame_](double s) {
              std::size_t i = 1;
              while (i + 1 < way.size() && upto[i] < s) ++i;
              const double t = (s - upto[i - 1]) / (upto[i] - upto[i - 1]);
              return frame.to_world(way[i - 1] + (way[i] - way[i - 1]) * std::min(t, 1.0));
            }};
  }

 protected:
  const Frame& frame() const { return frame_; }
  /// Where the first slide begins, and by which corners the next leg goes on from there; both in the plane.
  virtual Vec2 start(Random& random) const = 0;
  virtual std::vector<Vec2> way_on(Random& random, Vec2 at) const = 0;

 private:
  PlaneProfile profile_;
  Frame frame_;
  Vec3 axis_;
};

/// Tissue where x <= 0 and z <= 0. The slide goes out over the edge along one face, and back in on the other.
class Edge : public ProfileShape {
 public:
  explicit Edge(double r, std::string name = "edge", const Frame& frame = oblique_frame())
      : ProfileShape(std::move(name), r, {{-kFar, 0.0}, {0.0, 0.0}, {0.0, -kFar}}, 0.0, {1.0, 0.0, 1.0}, frame) {}

 protected:
  Vec2 start(Random& random) const override { return {random.between(-1.5, -0.3), under()}; }
  std::vector<Vec2> way_on(Random& random, Vec2 at) const override {
    const double next = random.between(-1.5, -0.3);
    if (at.x <= -0.3) return {{out(), under()}, {out(), next}, {under(), next}};
    return {{under(), out()}, {next, out()}, {next, under()}};
  }

 private:
  double under() const { return bur_radius_mm() - kDepthMm; }
  double out() const { return bur_radius_mm() + 0.1; }
};

/// The same where a volume ends whose every voxel is tissue: its own edge, between its faces towards +x and +z.
class Rim : public Edge {
 public:
  explicit Rim(double r) : Edge(r, "rim", Frame::of({0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {kHalfBoxMm, 0.0, kHalfBoxMm})) {}
  bool fills_grid() const override { return true; }

 private:
  static constexpr double kHalfBoxMm = 5.0;
};

/// A groove of 60 degrees, sharp at its bottom, deep enough for the bur to rest on both walls below the mouth.
class Groove : public ProfileShape {
 public:
  explicit Groove(double r) : Groove(r, std::max(2.5, 2.2 * r)) {}

 protected:
  Vec2 start(Random& random) const override { return up_wall(-1.0, random); }
  std::vector<Vec2> way_on(Random& random, Vec2 at) const override {
    return {apex(), up_wall(at.x < 0.0 ? 1.0 : -1.0, random)};
  }

 private:
  Groove(double r, double deep)
      : ProfileShape("groove", r,
                     {{-kFar, 0.0},
                      {-deep * kSine30 / kCosine30, 0.0},
                      {0.0, -deep},
                      {deep * kSine30 / kCosine30, 0.0},
                      {kFar, 0.0}},
                     deep / 2.0, {0.0, 0.0, 1.0}),
        deep_(deep) {}
  Vec2 apex() const { return {0.0, -deep_ + (bur_radius_mm() - kDepthMm) / kSine30}; }
  Vec2 up_wall(double side, Random& random) const {
    const double most = std::min(2.0, (deep_ - 1.5 * bur_radius_mm()) / kCosine30 - 0.2);
    const double s = random.between(0.3, most);
    return apex() + s * Vec2(side * kSine30, kCosine30);
  }
  double deep_;
};

/// Faces at z = 0 (x > 0) and z = 0.5 mm (x < 0). The slide goes into the corner, up the riser and over it, onto the
/// upper face, and back over its edge.
class Step : public ProfileShape {
 public:
  explicit Step(double r)
      : ProfileShape("step", r, {{-kFar, kStepMm}, {0.0, kStepMm}, {0.0, 0.0}, {kFar, 0.0}}, 0.0, {0.45, 0.0, 1.0}) {}

 protected:
  Vec2 start(Random& random) const override { return {lower_x(random), under()}; }
  std::vector<Vec2> way_on(Random& random, Vec2 at) const override {
    const double above = kStepMm + bur_radius_mm() + 0.1;
    if (at.x > 0.0) {
      const double x = random.between(-1.5, -0.4);
      return {{under(), under()}, {under(), above}, {x, above}, {x, kStepMm + under()}};
    }
    const double x = lower_x(random);
    return {{x, kStepMm + under()}, {x, under()}};
  }

 private:
  double under() const { return bur_radius_mm() - kDepthMm; }
  double lower_x(Random& random) const { return bur_radius_mm() + random.between(0.4, 1.5); }
};

/// A slot 1.2 bur radii wide and three deep, which the bur cannot enter: it rests on both mouth edges. The slide goes
/// across it, in and out again.
class NarrowSlot : public ProfileShape {
 public:
  /// Where the centre may go is what a notch leaves it whose walls the bur all but touches as it rests on the mouth
  /// (10 nm off, relative to a radius of 0.25): tan of their slope 0.75 where the mouth edges stand at 0.6 radii.
  explicit NarrowSlot(double r)
      : ProfileShape("narrow-slot", r,
                     {{-kFar, 0.0}, {-kHalf * r, 0.0}, {0.0, -0.7495 * kHalf * r}, {kHalf * r, 0.0}, {kFar, 0.0}},
                     kLift, {0.0, 0.0, 1.0}),
        slot_({{-kFar, 0.0},
               {-kHalf * r, 0.0},
               {-kHalf * r, -3.0 * r},
               {kHalf * r, -3.0 * r},
               {kHalf * r, 0.0},
               {kFar, 0.0}},
              0.1 * r) {}
  double distance_mm(Vec3 p) const override { return slot_.distance_mm(flat(frame().to_local(p))); }

 protected:
  Vec2 start(Random& random) const override { return {-side(random), under()}; }
  std::vector<Vec2> way_on(Random& random, Vec2 at) const override {
    return {{0.0, under() - 0.2}, {at.x < 0.0 ? side(random) : -side(random), under()}};
  }

 private:
  static constexpr double kHalf = 0.6, kLift = 0.5;
  PlaneProfile slot_;
  double under() const { return bur_radius_mm() - kDepthMm; }
  double side(Random& random) const { return bur_radius_mm() + random.between(0.3, 1.2); }
};

}  // namespace

std::unique_ptr<Shape> make_profile_shape(std::string_view name, double r) {
  if (name == "edge") return std::make_unique<Edge>(r);
  if (name == "groove") return std::make_unique<Groove>(r);
  if (name == "rim") return std::make_unique<Rim>(r);
  if (name == "narrow-slot") return std::make_unique<NarrowSlot>(r);
  if (name == "step") return std::make_unique<Step>(r);
  return nullptr;
}

}  // namespace cusp::bench
