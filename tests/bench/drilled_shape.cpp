#include "tests/bench/drilled_shape.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/surface_contact.h"
#include "engine/tool/heads.h"
#include "tests/bench/frame.h"
#include "tests/engine/step/cut_along.h"

namespace cusp::bench {

namespace {

constexpr double kHoleOverBur = 1.5;
constexpr double kAboveRimMm = 0.05;
constexpr double kLeastAngle = 0.45, kMostAngle = 1.1;  // of the way from the rim to the device, over the face
constexpr double kTurn = 6.283185307179586;

/// Of the frame, about the hole's axis.
struct Polar {
  double rho = 0.0, phi = 0.0, z = 0.0;
};

class Drilled : public Shape {
 public:
  explicit Drilled(double r) : Shape("cut", r), hole_(kHoleOverBur * r), ball_(r - SurfaceContact::kClearanceMm) {}
  std::string variant() const override { return "drilled"; }
  std::string key() const override { return "face"; }
  double distance_mm(Vec3 p) const override { return frame_.to_local(p).z; }
  Vec3 tool_axis() const override { return frame_.z; }
  Vec3 home() const override { return frame_.to_world({0.0, 0.0, 14.0}); }
  double cutter_radius_mm() const override { return hole_; }
  std::optional<Profile> cutter_head() const override { return flat_head(hole_, hole_, 2.0 * hole_ + 1.0); }
  bool prepare(StepState& state) const override {
    // The head's end lies a radius below its pivot.
    return test::cut_along(state, 1, world({0.0, 0.0, hole_ + 0.2}), world({0.0, 0.0, 0.0}));
  }
  std::unique_ptr<Truth> truth() const override { return std::make_unique<OneSheet<Drilled>>(*this); }

  /// Of the ball's centre.
  double clearance_mm(Vec3 centre) const {
    const Polar c = polar(centre);
    if (c.z >= 0.0) return c.rho >= hole_ ? c.z - bur_radius_mm() : std::hypot(hole_ - c.rho, c.z) - ball_;
    return std::min(hole_ - c.rho, c.z + hole_) - ball_;
  }
  /// Below the face the wall holds the ball, above it the rim.
  Vec3 proxy(Vec3 device) const {
    const Polar q = polar(device);
    if (q.z < 0.0) return q.rho > hole_ - ball_ ? at({hole_ - ball_, q.phi, q.z}) : device;
    const double off = std::hypot(hole_ - q.rho, q.z);
    return off < ball_ ? at({hole_ + (q.rho - hole_) * (ball_ / off), q.phi, q.z * (ball_ / off)}) : device;
  }

  Spot spot(Random& random) const override {
    const double phi = random.between(0.0, kTurn);
    return {at({hole_ - ball_ - 1e-6, phi, -random.between(0.1, 0.4) * bur_radius_mm()}),
            frame_.direction({-std::cos(phi), -std::sin(phi), 0.0})};
  }
  /// Along the rim, half a radius off it.
  Leg leg(Random& random, const Vec3* from) const override {
    const double off = 0.5 * bur_radius_mm();
    double phi = random.between(0.0, kTurn), angle = random.between(kLeastAngle, kMostAngle);
    if (from != nullptr) {
      const Polar p = polar(*from);
      phi = p.phi;
      angle = std::atan2(p.z, hole_ - p.rho);
    }
    const double turn = random.between(-kTurn / 2.0, kTurn / 2.0), tilt = random.between(kLeastAngle, kMostAngle) - angle;
    const double whole = std::hypot(hole_ * turn, off * tilt) + 1e-9;
    return {whole, [this, off, phi, angle, turn, tilt, whole](double s) {
              const double share = s / whole, a = angle + tilt * share;
              return at({hole_ - off * std::cos(a), phi + turn * share, off * std::sin(a)});
            }};
  }
  Vec3 before(Vec3 first) const override {
    const Polar p = polar(first);
    const double off = std::hypot(hole_ - p.rho, p.z), far = (bur_radius_mm() + kAboveRimMm) / off;
    return at({hole_ + (p.rho - hole_) * far, p.phi, p.z * far});
  }

 private:
  Vec3 world(Vec3 local) const { return frame_.to_world(local); }
  Polar polar(Vec3 p) const {
    const Vec3 l = frame_.to_local(p);
    return {std::hypot(l.x, l.y), std::atan2(l.y, l.x), l.z};
  }
  Vec3 at(const Polar& p) const { return world({p.rho * std::cos(p.phi), p.rho * std::sin(p.phi), p.z}); }

  Frame frame_ = oblique_frame();
  double hole_, ball_;  // radii, mm; the ball is thinner against what was cut
};

}  // namespace

std::unique_ptr<Shape> make_drilled(double bur_radius_mm) { return std::make_unique<Drilled>(bur_radius_mm); }

}  // namespace cusp::bench
