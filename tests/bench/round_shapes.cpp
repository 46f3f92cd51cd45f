#include "tests/bench/round_shapes.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/frame.h"

namespace cusp::bench {

namespace {

constexpr double kAboveRoundMm = 0.05;  // mm: where a press starts, above its spot
constexpr double kRoundHomeMm = 14.0;   // mm from the middle: no bur of 3 mm touches the 10 mm box there
constexpr double kSphereMm = 4.0, kCylinderMm = 2.0, kPitOverBur = 1.2, kWallMm = 0.2;

class RoundShape : public Shape {
 public:
  using Shape::Shape;
  Vec3 tool_axis() const override { return frame_.z; }
  Vec3 home() const override { return frame_.to_world({0.0, 0.0, kRoundHomeMm}); }
  double clearance_mm(Vec3 centre) const { return distance_mm(centre) - bur_radius_mm(); }

 protected:
  Frame frame_ = oblique_frame();
};

/// A uniform random point of a disc.
Vec3 in_disc(Random& random, double radius) {
  const double rho = radius * std::sqrt(random.between(0.0, 1.0));
  const double phi = random.between(0.0, 6.283185307179586);
  return {rho * std::cos(phi), rho * std::sin(phi), 0.0};
}

Leg straight(Vec3 a, Vec3 b) {
  const double whole = length(b - a);
  return {whole, [a, b, whole](double s) { return a + (b - a) * (s / whole); }};
}

/// A flat tissue face z <= 0 of the frame; the wall is one 0.2 mm thick, felt from above.
class Flat : public RoundShape {
 public:
  Flat(std::string name, double bur_radius_mm, double thickness_mm)
      : RoundShape(std::move(name), bur_radius_mm), thickness_(thickness_mm) {}
  double distance_mm(Vec3 p) const override {
    const double z = frame_.to_local(p).z;
    return thickness_ > 0.0 ? std::fabs(z + thickness_ / 2.0) - thickness_ / 2.0 : z;
  }
  double thinnest_mm() const override { return thickness_; }
  /// Always above the wall, where the bur comes from.
  Vec3 proxy(Vec3 q) const {
    const double under = bur_radius_mm() - frame_.to_local(q).z;
    return under > 0.0 ? q + frame_.z * under : q;
  }
  std::unique_ptr<Truth> truth() const override { return std::make_unique<OneSheet<Flat>>(*this); }
  Spot spot(Random& random) const override {
    Vec3 c = in_disc(random, kDisc);
    c.z = bur_radius_mm();
    return {frame_.to_world(c), frame_.z};
  }
  Leg leg(Random& random, const Vec3* from) const override {
    const auto aim = [&] {
      Vec3 c = in_disc(random, kDisc);
      c.z = bur_radius_mm() - kDepthMm;
      return frame_.to_world(c);
    };
    const Vec3 a = from ? *from : aim();
    return straight(a, aim());
  }
  Vec3 before(Vec3 first) const override { return proxy(first) + frame_.z * kAboveRoundMm; }

 private:
  static constexpr double kDisc = 3.0;
  double thickness_;
};

/// A flat face with enamel on one side of a plane and dentine on the other. Legs cross the joint.
class Joint : public Flat {
 public:
  explicit Joint(double bur_radius_mm) : Flat("joint", bur_radius_mm, 0.0) {}
  Tissue tissue(Vec3 p) const override { return frame_.to_local(p).x < 0.0 ? Tissue::enamel : Tissue::dentine; }
  Leg leg(Random& random, const Vec3* from) const override {
    const auto aim = [&](double side) {
      return frame_.to_world({side * random.between(0.3, 1.5), random.between(-1.5, 1.5), bur_radius_mm() - kDepthMm});
    };
    const Vec3 a = from ? *from : aim(-1.0);
    return straight(a, aim(frame_.to_local(a).x < 0.0 ? 1.0 : -1.0));
  }
};

/// Ball of 4 mm; the bur keeps to the 55 degrees about the frame's z. Or its inside, a pit of 1.2 bur radii.
class Ball : public RoundShape {
 public:
  enum class Side : std::uint8_t { outside, inside };
  Ball(std::string name, double bur_radius_mm, double radius_mm, Side side)
      : RoundShape(std::move(name), bur_radius_mm), ball_(radius_mm), pit_(side == Side::inside) {}
  std::string key() const override { return pit_ ? name() + std::to_string(ball_) : name(); }
  double distance_mm(Vec3 world) const override {
    const Vec3 p = frame_.to_local(world);
    if (!pit_) return length(p) - ball_;
    // Half space z <= 0 without the ball: its lower half is the pit, its rim a circle.
    const double from_middle = length(p);
    const double rho = std::sqrt(p.x * p.x + p.y * p.y);
    const double rim = std::sqrt((rho - ball_) * (rho - ball_) + p.z * p.z);
    if (p.z <= 0.0 && from_middle >= ball_) {  // in tissue
      return -std::min(from_middle - ball_, rho >= ball_ ? -p.z : rim);
    }
    if (p.z > 0.0) return rho >= ball_ ? p.z : rim;
    return ball_ - from_middle;
  }
  double half_mm() const override { return pit_ ? 0.0 : ball_ + 0.1; }
  double least_radius_mm() const override { return ball_; }
  /// In the pit the bur stays below the middle's height, where the offset surface is a sphere of 0.2 radii.
  Vec3 proxy(Vec3 q) const {
    const Vec3 d = q - frame_.origin;
    const double far = length(d);
    const double reach = offset();
    if (pit_ ? far <= reach : far >= reach) return q;
    return frame_.origin + d * (reach / far);
  }
  std::unique_ptr<Truth> truth() const override { return std::make_unique<OneSheet<Ball>>(*this); }
  Spot spot(Random& random) const override {
    const Vec3 u = somewhere(random);
    return {frame_.origin + u * offset(), pit_ ? -u : u};
  }
  Leg leg(Random& random, const Vec3* from) const override {
    const double reach = pit_ ? offset() + kDepthMm : offset() - kDepthMm;
    const Vec3 a = from ? unit(*from - frame_.origin) : somewhere(random);
    const Vec3 b = somewhere(random);
    const double angle = std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
    const Vec3 side = unit(b - a * glm::dot(a, b));
    const Vec3 middle = frame_.origin;
    return {reach * angle, [=](double s) {
              const double t = s / reach;
              return middle + (a * std::cos(t) + side * std::sin(t)) * reach;
            }};
  }
  Vec3 before(Vec3 first) const override {
    if (pit_) return frame_.origin;
    return frame_.origin + unit(first - frame_.origin) * (offset() + kAboveRoundMm);
  }

 private:
  double offset() const { return pit_ ? ball_ - bur_radius_mm() : ball_ + bur_radius_mm(); }
  /// A direction within 55 degrees of the frame's z, evenly; downwards for the pit.
  Vec3 somewhere(Random& random) const {
    const double z = random.between(0.5736, 1.0);
    const double phi = random.between(0.0, 6.283185307179586);
    const double rho = std::sqrt(1.0 - z * z);
    return frame_.direction({rho * std::cos(phi), rho * std::sin(phi), pit_ ? -z : z});
  }
  double ball_;
  bool pit_;
};

/// Cylinder of 2 mm along the frame's x; the bur keeps to 50 degrees about z and 2.4 mm along.
class Cylinder : public RoundShape {
 public:
  explicit Cylinder(double bur_radius_mm) : RoundShape("cylinder", bur_radius_mm) {}
  double distance_mm(Vec3 world) const override {
    const Vec3 p = frame_.to_local(world);
    return std::sqrt(p.y * p.y + p.z * p.z) - kCylinderMm;
  }
  double least_radius_mm() const override { return kCylinderMm; }
  Vec3 proxy(Vec3 q) const {
    const Vec3 p = frame_.to_local(q);
    const double far = std::sqrt(p.y * p.y + p.z * p.z);
    const double reach = kCylinderMm + bur_radius_mm();
    if (far >= reach) return q;
    return frame_.to_world({p.x, p.y * reach / far, p.z * reach / far});
  }
  std::unique_ptr<Truth> truth() const override { return std::make_unique<OneSheet<Cylinder>>(*this); }
  Spot spot(Random& random) const override {
    const double x = random.between(-kAlong, kAlong), phi = random.between(-kAround, kAround);
    return {at(x, phi, kCylinderMm + bur_radius_mm()), frame_.direction({0.0, std::sin(phi), std::cos(phi)})};
  }
  /// A helix: a straight line on the unrolled cylinder.
  Leg leg(Random& random, const Vec3* from) const override {
    const double reach = kCylinderMm + bur_radius_mm() - kDepthMm;
    double x0 = random.between(-kAlong, kAlong), phi0 = random.between(-kAround, kAround);
    if (from) {
      const Vec3 p = frame_.to_local(*from);
      x0 = p.x;
      phi0 = std::atan2(p.y, p.z);
    }
    const double x1 = random.between(-kAlong, kAlong), phi1 = random.between(-kAround, kAround);
    const double whole = std::sqrt((x1 - x0) * (x1 - x0) + reach * reach * (phi1 - phi0) * (phi1 - phi0));
    return {whole, [=, this](double s) {
              const double t = s / whole;
              return at(x0 + (x1 - x0) * t, phi0 + (phi1 - phi0) * t, reach);
            }};
  }
  Vec3 before(Vec3 first) const override {
    const Vec3 p = frame_.to_local(first);
    return at(p.x, std::atan2(p.y, p.z), kCylinderMm + bur_radius_mm() + kAboveRoundMm);
  }

 private:
  static constexpr double kAlong = 2.4, kAround = 0.873;
  Vec3 at(double x, double phi, double rho) const {
    return frame_.to_world({x, rho * std::sin(phi), rho * std::cos(phi)});
  }
};

/// Three walls at right angles, tissue beyond each: admissible centres are an octant. Its corner lies 1.5 mm below the
/// middle along the diagonal, which is the frame's z.
class Corner : public RoundShape {
 public:
  explicit Corner(double bur_radius_mm) : RoundShape("corner", bur_radius_mm) {
    const Vec3 u = unit(Vec3(1.0)), v = unit(Vec3(1.0, -1.0, 0.0));
    const Frame body = Frame::of(u, v, Vec3(0.0));
    // The octant's axes, turned so that its diagonal is the frame's z.
    const auto turned = [&](Vec3 axis) {
      return frame_.direction({glm::dot(axis, body.x), glm::dot(axis, body.y), glm::dot(axis, body.z)});
    };
    walls_.x = turned({1.0, 0.0, 0.0});
    walls_.y = turned({0.0, 1.0, 0.0});
    walls_.z = turned({0.0, 0.0, 1.0});
    walls_.origin = frame_.origin - frame_.z * 1.5;
  }
  double distance_mm(Vec3 world) const override {
    const Vec3 p = walls_.to_local(world);
    const double least = std::min({p.x, p.y, p.z});
    return least >= 0.0 ? least : -length(glm::max(-p, Vec3(0.0)));
  }
  Vec3 proxy(Vec3 q) const {
    const Vec3 p = walls_.to_local(q);
    const double r = bur_radius_mm();
    if (p.x >= r && p.y >= r && p.z >= r) return q;
    return walls_.to_world(glm::max(p, Vec3(r)));
  }
  std::unique_ptr<Truth> truth() const override { return std::make_unique<OneSheet<Corner>>(*this); }
  /// On one wall, in the groove of two, or in the corner: a third each.
  Spot spot(Random& random) const override {
    const int walls = 1 + static_cast<int>(random.between(0.0, 3.0));
    const int first = static_cast<int>(random.between(0.0, 3.0));
    Vec3 c(bur_radius_mm()), n(0.0);
    for (int i = 0; i < 3; ++i) {
      const int axis = (first + i) % 3;
      if (i < walls) {
        n[axis] = 1.0;
      } else {
        c[axis] += random.between(0.05, kSide);
      }
    }
    return {walls_.to_world(c), walls_.direction(unit(n))};
  }
  /// From touch to touch: each way point lies kDepthMm behind one, two or three walls.
  Leg leg(Random& random, const Vec3* from) const override {
    const auto aim = [&] {
      Vec3 c;
      const int must = static_cast<int>(random.between(0.0, 3.0));
      for (int i = 0; i < 3; ++i)
        c[i] =
            bur_radius_mm() + (i == must || random.between(0.0, 1.0) < 0.4 ? -kDepthMm : random.between(0.05, kSide));
      return walls_.to_world(c);
    };
    const Vec3 a = from ? *from : aim();
    Vec3 b = aim();
    while (length(b - a) < 0.1) b = aim();  // the corner itself, twice
    return straight(a, b);
  }
  Vec3 before(Vec3 first) const override { return proxy(first) + frame_.z * kAboveRoundMm; }

 private:
  static constexpr double kSide = 1.5;
  Frame walls_;
};

}  // namespace

std::unique_ptr<Shape> make_round_shape(std::string_view name, double r) {
  if (name == "face") return std::make_unique<Flat>("face", r, 0.0);
  if (name == "joint") return std::make_unique<Joint>(r);
  if (name == "wall") return std::make_unique<Flat>("wall", r, kWallMm);
  if (name == "sphere") return std::make_unique<Ball>("sphere", r, kSphereMm, Ball::Side::outside);
  if (name == "pit") return std::make_unique<Ball>("pit", r, kPitOverBur * r, Ball::Side::inside);
  if (name == "cylinder") return std::make_unique<Cylinder>(r);
  if (name == "corner") return std::make_unique<Corner>(r);
  return nullptr;
}

}  // namespace cusp::bench
