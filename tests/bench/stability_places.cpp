#include "tests/bench/stability_places.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/surface_contact.h"
#include "tests/bench/cut_shape.h"
#include "tests/bench/frame.h"
#include "tests/modules.h"

namespace cusp::bench {

namespace {

constexpr double kTiltMost = 0.14;  // sideways part of a push into a hollow: 8 degrees along each axis

Vec3 unit_direction(const Frame& frame, Vec3 local) { return frame.direction(unit(local)); }

/// A place on a Shape.
class ShapePlace : public PressPlace {
 public:
  ShapePlace(std::string_view name, double r) : shape_(make_shape(name, r)) {}
  const Shape& shape() const override { return *shape_; }
  std::unique_ptr<Truth> truth() const override { return shape_->truth(); }

 protected:
  double r() const { return shape_->bur_radius_mm(); }
  Frame frame_ = oblique_frame();

 private:
  std::unique_ptr<Shape> shape_;
};

class FacePlace : public ShapePlace {
 public:
  explicit FacePlace(double r) : ShapePlace("face", r) {}
  Press press(std::uint64_t seed) const override {
    Random random(seed);
    const Vec3 at(random.in(glm::dvec2(-2.0), glm::dvec2(2.0)), r());
    return {frame_.to_world(at), -frame_.z, -frame_.z, frame_.x, frame_.y};
  }
};

class EdgePlace : public ShapePlace {
 public:
  explicit EdgePlace(double r) : ShapePlace("edge", r) {}
  Press press(std::uint64_t seed) const override {
    Random random(seed);
    const Vec3 at(random.in(glm::dvec2(-0.2, -1.5), glm::dvec2(-0.05, 1.5)), r());
    return {frame_.to_world(at), -frame_.z, -frame_.z, frame_.x, frame_.y};
  }
};

class CornerPlace : public ShapePlace {
 public:
  explicit CornerPlace(double r) : ShapePlace("corner", r) {}
  Press press(std::uint64_t seed) const override {
    Random random(seed);
    // Three walls at right angles about the frame's z, their corner 1.5 mm below its origin.
    const Vec3 at(0.0, 0.0, std::sqrt(3.0) * r() - 1.5);
    const Vec3 into =
        unit_direction(frame_, Vec3(random.in(glm::dvec2(-kTiltMost), glm::dvec2(kTiltMost)), -1.0));
    return {frame_.to_world(at), -frame_.z, into, Vec3(0.0), Vec3(0.0)};
  }
};

class GroovePlace : public ShapePlace {
 public:
  explicit GroovePlace(double r) : ShapePlace("groove", r) {}
  Press press(std::uint64_t seed) const override {
    Random random(seed);
    // The groove is as deep as its shape makes it, its apex half of that below the frame's origin; 60 degrees.
    const double deep = std::max(2.5, 2.2 * r());
    const Vec3 at(0.0, random.between(-1.5, 1.5), 2.0 * r() - 0.5 * deep);
    const Vec3 into = unit_direction(frame_, Vec3(random.between(-kTiltMost, kTiltMost), 0.0, -1.0));
    return {frame_.to_world(at), -frame_.z, into, frame_.y, Vec3(0.0)};
  }
};

/// The half space z <= 0 of the frame without a ball 2 % wider than the bur about its origin.
class FittingPit : public Shape {
 public:
  explicit FittingPit(double r) : Shape("fitting-pit", r), ball_(1.02 * r) {}
  std::string key() const override { return name() + std::to_string(ball_); }
  double distance_mm(Vec3 world) const override {
    const Vec3 p = frame_.to_local(world);
    const double far = length(p), rho = std::sqrt(p.x * p.x + p.y * p.y);
    const double rim = std::sqrt((rho - ball_) * (rho - ball_) + p.z * p.z);
    if (p.z <= 0.0 && far >= ball_) return -std::min(far - ball_, rho >= ball_ ? -p.z : rim);
    if (p.z > 0.0) return rho >= ball_ ? p.z : rim;
    return ball_ - far;
  }
  double least_radius_mm() const override { return ball_; }
  Vec3 tool_axis() const override { return frame_.z; }
  Vec3 home() const override { return frame_.to_world({0.0, 0.0, 14.0}); }
  Spot spot(Random&) const override { return {frame_.origin - frame_.z * play(), frame_.z}; }
  Leg leg(Random&, const Vec3*) const override {
    const Vec3 at = frame_.origin - frame_.z * (play() + kDepthMm);
    return {1e-3, [at](double) { return at; }};
  }
  Vec3 before(Vec3) const override { return frame_.origin; }
  std::unique_ptr<Truth> truth() const override;

  double play() const { return ball_ - bur_radius_mm(); }
  const Frame& frame() const { return frame_; }

 private:
  Frame frame_ = oblique_frame();
  double ball_;
};

/// A ball in a slightly wider bowl: its centre is free within `play` of the middle; higher up it rolls on the rim.
class InBowl : public Truth {
 public:
  InBowl(const Frame& frame, double bowl, double ball) : frame_(frame), bowl_(bowl), ball_(ball) {}
  double clearance_mm(Vec3 centre) const override {
    const Vec3 p = frame_.to_local(centre);
    const double rho = std::sqrt(p.x * p.x + p.y * p.y);
    if (p.z <= 0.0) return bowl_ - length(p) - ball_;
    return (rho < bowl_ ? std::hypot(bowl_ - rho, p.z) : p.z) - ball_;
  }
  Exact follow(Vec3 device) override { return move_to(device); }

 protected:
  Vec3 place(Vec3 centre) override { return move_to(centre).pose_mm; }
  Exact move_to(Vec3 device) override {
    if (clearance_mm(device) >= 0.0) return {device, false, false};
    const Vec3 p = frame_.to_local(device);
    if (p.z <= 0.0) return {frame_.to_world(p * ((bowl_ - ball_) / length(p))), true, false};
    const double rho = std::sqrt(p.x * p.x + p.y * p.y);
    if (rho >= bowl_) return {frame_.to_world({p.x, p.y, ball_}), true, false};
    const double far = std::hypot(bowl_ - rho, p.z), out = bowl_ - (bowl_ - rho) * ball_ / far;
    const Vec3 at(rho > 0.0 ? p.x / rho * out : out, rho > 0.0 ? p.y / rho * out : 0.0, p.z * ball_ / far);
    return {frame_.to_world(at), true, false};
  }

 private:
  Frame frame_;
  double bowl_, ball_;
};

std::unique_ptr<Truth> FittingPit::truth() const { return std::make_unique<InBowl>(frame_, ball_, bur_radius_mm()); }

/// A ball in a hole of its own width: its centre stays within `play` of the ray from the bottom outwards.
class InHole : public Truth {
 public:
  InHole(Vec3 bottom, Vec3 out, double play) : bottom_(bottom), out_(out), play_(play) {}
  double clearance_mm(Vec3 centre) const override { return play_ - length(centre - on(centre)); }
  Exact follow(Vec3 device) override { return move_to(device); }

 protected:
  Vec3 place(Vec3 centre) override { return move_to(centre).pose_mm; }
  Exact move_to(Vec3 device) override {
    const Vec3 foot = on(device), off = device - foot;
    const double far = length(off);
    if (far <= play_) return {device, false, false};
    return {foot + off * (play_ / far), true, false};
  }

 private:
  Vec3 on(Vec3 q) const { return bottom_ + out_ * std::max(0.0, glm::dot(q - bottom_, out_)); }
  Vec3 bottom_, out_;
  double play_;
};

class PitPlace : public PressPlace {
 public:
  explicit PitPlace(double r) : pit_(r) {}
  const Shape& shape() const override { return pit_; }
  std::unique_ptr<Truth> truth() const override { return pit_.truth(); }
  Press press(std::uint64_t seed) const override {
    Random random(seed);
    const Frame& f = pit_.frame();
    const Vec3 into = unit_direction(f, Vec3(random.in(glm::dvec2(-0.4), glm::dvec2(0.4)), -1.0));
    return {f.origin + into * pit_.play(), -f.z, into, Vec3(0.0), Vec3(0.0)};
  }

 private:
  FittingPit pit_;
};

class ChannelPlace : public PressPlace {
 public:
  explicit ChannelPlace(double r) {
    // The first oblique hole that is deep enough for the bur to stand wholly below its mouth's middle.
    for (std::uint64_t seed = 1;; ++seed) {
      hole_ = std::make_unique<Hole>(r, HoleKind::oblique, seed, SurfaceContact::kClearanceMm);
      if (glm::dot(frame_.z, frame_.origin - hole_->bottom()) >= kDeepRadii * r) break;
    }
  }
  const Shape& shape() const override { return *hole_; }
  std::unique_ptr<Truth> truth() const override {
    return std::make_unique<InHole>(hole_->bottom(), hole_->axis(), SurfaceContact::kClearanceMm);
  }
  Press press(std::uint64_t seed) const override {
    Random random(seed);
    const Frame f = Frame::of(hole_->axis(), {0.3, 1.0, 0.2}, hole_->bottom());
    const Vec3 into = unit_direction(f, Vec3(random.in(glm::dvec2(-0.5), glm::dvec2(0.5)), -1.0));
    return {hole_->bottom() + into * SurfaceContact::kClearanceMm, -hole_->axis(), into, Vec3(0.0), Vec3(0.0)};
  }

 private:
  static constexpr double kDeepRadii = 1.8;
  Frame frame_ = oblique_frame();
  std::unique_ptr<Hole> hole_;
};

}  // namespace

std::unique_ptr<PressPlace> PressPlace::make(std::string_view name, double r) {
  if (name == "face") return std::make_unique<FacePlace>(r);
  if (name == "edge") return std::make_unique<EdgePlace>(r);
  if (name == "corner") return std::make_unique<CornerPlace>(r);
  if (name == "groove") return std::make_unique<GroovePlace>(r);
  if (name == "pit") return std::make_unique<PitPlace>(r);
  if (name == "channel") return std::make_unique<ChannelPlace>(r);
  return nullptr;
}

}  // namespace cusp::bench
