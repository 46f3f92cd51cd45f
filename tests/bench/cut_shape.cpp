#include "tests/bench/cut_shape.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/surface_contact.h"
#include "tests/engine/step/cut_along.h"
#include "tests/modules.h"

namespace cusp::bench {

namespace {

constexpr double kCutStepMm = 0.1;
constexpr double kAboveCutMm = 0.05;
constexpr double kCutterOverBur = 1.5;
constexpr double kRadians = 0.017453292519943296;

bool cut_in_steps(StepState& state, std::uint16_t cutter, const Capsule& c) {
  const int pieces = static_cast<int>(length(c.b - c.a) / kCutStepMm) + 1;
  bool room = true;
  for (int k = 0; k < pieces; ++k)
    room = test::cut_along(state, cutter, c.a + (c.b - c.a) * (static_cast<double>(k) / pieces),
                           c.a + (c.b - c.a) * (static_cast<double>(k + 1) / pieces)) &&
           room;
  return room;
}

class Cut : public CutBlock {
 public:
  Cut(double r, CutKind kind) : CutBlock("cut", r), kind_(kind) {
    // Three lines round a triangle 1 mm wide, each a little inclined; depths below the face 0.3 to 0.6 bur radii.
    const double big = kCutterOverBur * r;
    std::vector<Capsule> paths;
    const double wide = 0.35, reach = 1.6;
    for (int i = 0; i < (kind == CutKind::crossing ? 3 : 1); ++i) {
      const double phi = 0.4 + 2.0943951 * i + 0.13 * i * i;
      const Vec3 out(std::cos(phi), std::sin(phi), 0.0), along(-std::sin(phi), std::cos(phi), 0.0);
      const Vec3 up(0.0, 0.0, 1.0);
      paths.push_back({out * wide - along * reach + up * (big - 0.3 * r),
                       out * wide + along * reach + up * (big - (0.45 + 0.07 * i) * r), big});
    }
    carve(paths, SurfaceContact::kClearanceMm);
  }
  std::string variant() const override { return kind_ == CutKind::crossing ? "crossing" : "single"; }
  Vec3 tool_axis() const override { return frame_.z; }
  Vec3 home() const override { return frame_.to_world({0.0, 0.0, 14.0}); }
  double cutter_radius_mm() const override { return kCutterOverBur * bur_radius_mm(); }

  /// spot() avoids edges for a small bur, whose device point lies beyond the edge and has no minimum there.
  Spot spot(Random& random) const override {
    for (;;) {
      const glm::dvec2 above = random.in(glm::dvec2(-kSide), glm::dvec2(kSide));
      const Vec3 c = over(above.x, above.y, 1e-8);
      if (bur_radius_mm() < kDepthMm + 0.02 && block_->edge_nearest(c)) continue;
      Vec3 slope;
      constexpr double kStep = 1e-6;
      for (int i = 0; i < 3; ++i) {
        Vec3 d(0.0);
        d[i] = kStep;
        slope[i] = block_->clearance_mm(c + d) - block_->clearance_mm(c - d);
      }
      // On two faces at once the gradient is shorter than one and no normal.
      if (length(slope) < 1.99 * kStep) continue;
      return {c, unit(slope)};
    }
  }
  /// Straight over the scratched part as seen from above, kDepthMm below the height at which the bur rests there.
  Leg leg(Random& random, const Vec3* from) const override {
    const auto aim = [&] { return Vec3(random.in(glm::dvec2(-kSide), glm::dvec2(kSide)), 0.0); };
    const Vec3 a = from ? frame_.to_local(*from) : aim();
    Vec3 b = aim();
    while (std::hypot(b.x - a.x, b.y - a.y) < 0.2) b = aim();
    const double whole = std::hypot(b.x - a.x, b.y - a.y);
    return {whole, [this, a, b, whole](double s) {
              const double t = s / whole;
              return over(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, 1e-5) - frame_.z * kDepthMm;
            }};
  }
  Vec3 before(Vec3 first) const override { return first + frame_.z * (kDepthMm + kAboveCutMm); }

 private:
  static constexpr double kSide = 1.2;
  CutKind kind_;
  /// Where the bur rests when it is let down along the face's normal.
  Vec3 over(double x, double y, double precision_mm) const {
    double high = bur_radius_mm() + 1e-6, low = 0.0;
    while (high - low > precision_mm) {
      const double middle = 0.5 * (high + low);
      (block_->clearance_mm(frame_.to_world({x, y, middle})) >= 0.0 ? high : low) = middle;
    }
    return frame_.to_world({x, y, high});
  }
};

/// Two crossing pairs of slots leave an islet on a neck of 0.4 mm, 0.5 mm across at its top, with four sharp tips.
class Islet : public CutBlock {
 public:
  explicit Islet(double r) : CutBlock("islet", r) {
    std::vector<Capsule> paths;
    for (const double side : {-kApartMm, kApartMm}) {
      paths.push_back({{side, -1.4, -kAxisMm}, {side, 1.4, -kAxisMm}, kCutterMm});
      paths.push_back({{-1.4, side, -kAxisMm - 0.003}, {1.4, side, -kAxisMm - 0.003}, kCutterMm});
    }
    carve(paths, SurfaceContact::kClearanceMm);
  }
  Vec3 tool_axis() const override { return frame_.z; }
  Vec3 home() const override { return frame_.to_world({0.0, 0.0, 14.0}); }
  double cutter_radius_mm() const override { return kCutterMm; }
  double thinnest_mm() const override { return 2.0 * (kApartMm - kCutterMm); }
  Spot spot(Random& random) const override {
    const Vec3 c = frame_.to_world({random.between(-0.05, 0.05), random.between(-0.05, 0.05), bur_radius_mm()});
    return {c, frame_.z};
  }
  Leg leg(Random& random, const Vec3* from) const override {
    const double low = bur_radius_mm() - kDepthMm;
    const Vec3 a = from ? frame_.to_local(*from) : Vec3(-1.3, random.between(-0.3, 0.3), low);
    const double phi = random.between(0.0, 6.283185307179586);
    const Vec3 b(1.3 * std::cos(phi), 1.3 * std::sin(phi), low);
    const double whole = std::max(length(b - a), 0.01);
    return {whole, [frame = frame_, a, b, whole](double s) { return frame.to_world(a + (b - a) * (s / whole)); }};
  }
  Vec3 before(Vec3 first) const override { return first + frame_.z * (kDepthMm + kAboveCutMm); }

 private:
  static constexpr double kCutterMm = 0.4, kApartMm = 0.6, kAxisMm = 0.2;
};

}  // namespace

void CutBlock::carve(std::vector<Capsule> local, double thinner_mm) {
  for (Capsule& c : local) {
    c.a = frame_.to_world(c.a);
    c.b = frame_.to_world(c.b);
  }
  block_ = std::make_shared<CarvedBlock>(frame_.z, glm::dot(frame_.z, frame_.origin), std::move(local),
                                         bur_radius_mm(), thinner_mm);
}

bool CutBlock::prepare(StepState& state) const {
  const std::uint16_t cutter = cutter_radius_mm() > 0.0 ? 1 : 0;
  bool room = true;
  for (const Capsule& c : block_->capsules()) room = cut_in_steps(state, cutter, c) && room;
  return room;
}

namespace {

constexpr double kSuddenHoleMm = 0.8;
constexpr Vec3 kSuddenHoleTop(0.0, 0.0, 1.0), kSuddenHoleBottom(0.0, 0.0, -0.4);

/// A ball below the mouth of a hole: its centre stays within `play` of the axis.
class InSuddenHole : public Truth {
 public:
  InSuddenHole(Vec3 bottom, Vec3 out, double play) : bottom_(bottom), out_(out), play_(play) {}
  double clearance_mm(Vec3 centre) const override { return play_ - length(centre - on(centre)); }

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

constexpr double kBridgeCutMm = 0.35;

class EmptySpace : public Truth {
 public:
  double clearance_mm(Vec3) const override { return 1e3; }

 protected:
  Vec3 place(Vec3 centre) override { return centre; }
  Exact move_to(Vec3 device) override { return {device, false, false}; }
};

}  // namespace

ChangingFace::ChangingFace(std::string name, double r) : Shape(std::move(name), r), face_(make_shape("face", r)) {}

double SuddenHole::cutter_radius_mm() const { return kSuddenHoleMm; }

bool SuddenHole::give_way(StepState& state) const {
  return cut_in_steps(state, 1, {frame_.to_world(kSuddenHoleTop), frame_.to_world(kSuddenHoleBottom), kSuddenHoleMm});
}

std::unique_ptr<Truth> SuddenHole::truth_after() const {
  return std::make_unique<InSuddenHole>(frame_.to_world(kSuddenHoleBottom), frame_.z,
                                     kSuddenHoleMm - bur_radius_mm() + SurfaceContact::kClearanceMm);
}

/// Within the hole's middle half.
Spot SuddenHole::spot(Random& random) const {
  const double half = 0.35 * kSuddenHoleMm;
  const Vec3 c(random.in(glm::dvec2(-half), glm::dvec2(half)), bur_radius_mm());
  return {frame_.to_world(c), frame_.z};
}

double DetachablePlate::distance_mm(Vec3 place) const {
  const Vec3 p = frame_.to_local(place);
  const auto box = [&p](Vec3 middle, Vec3 half) {
    const Vec3 beyond = glm::abs(p - middle) - half;
    return length(glm::max(beyond, Vec3(0.0))) + std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0);
  };
  return std::min({box({0.0, 0.0, -0.25}, {1.2, 1.2, 0.25}), box({1.6, 0.0, -0.25}, {0.6, 0.25, 0.2}),
                   box({2.7, 0.0, -0.5}, {0.7, 1.2, 0.5})});
}

double DetachablePlate::cutter_radius_mm() const { return kBridgeCutMm; }

bool DetachablePlate::give_way(StepState& state) const {
  return cut_in_steps(state, 1, {frame_.to_world({1.6, -0.6, -0.25}), frame_.to_world({1.6, 0.6, -0.25}), kBridgeCutMm});
}

std::unique_ptr<Truth> DetachablePlate::truth_after() const { return std::make_unique<EmptySpace>(); }

Spot DetachablePlate::spot(Random& random) const {
  return {frame_.to_world({random.between(-0.3, 0.3), random.between(-0.3, 0.3), bur_radius_mm()}), frame_.z};
}

std::unique_ptr<Shape> make_islet(double bur_radius_mm) { return std::make_unique<Islet>(bur_radius_mm); }

std::unique_ptr<Shape> make_cut(double bur_radius_mm, CutKind kind) {
  return std::make_unique<Cut>(bur_radius_mm, kind);
}

Hole::Hole(double r, HoleKind kind, std::uint64_t seed, double thinner_mm)
    : CutBlock("channel", r), kind_(kind), seed_(seed) {
  Random random(seed * 3 + static_cast<std::uint64_t>(kind));
  const double tilt = kRadians * (kind == HoleKind::straight ? random.between(0.0, 5.0) : random.between(10.0, 70.0));
  const double turn = random.between(0.0, 360.0) * kRadians;
  const double deep = random.between(0.4, 1.3);
  const Vec3 mouth(random.in(glm::dvec2(-0.5), glm::dvec2(0.5)), 0.0);
  const Vec3 axis(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt));
  // From well outside, where the bur touches nothing yet, to its depth below the face along the axis.
  std::vector<Capsule> paths{{mouth + axis * (1.5 * r / std::cos(tilt) + 0.2), mouth - axis * deep, r}};
  const double side = random.between(0.0, 360.0) * kRadians;
  const Frame across = Frame::of(axis, {0.3, 1.0, 0.2}, Vec3(0.0));
  const Vec3 pull = across.direction({std::cos(side), std::sin(side), 0.0}) * 0.1;
  if (kind == HoleKind::slot) {
    // Its axis lies 0.3 radii above to 0.6 below the face, and passes the mouth within half a radius.
    const double way = random.between(0.0, 360.0) * kRadians;
    const Vec3 along(std::cos(way), std::sin(way), random.between(-0.1, 0.1)), sideways(-along.y, along.x, 0.0);
    const double lift = random.between(-0.6 * r, 0.3 * r);  // before the way sideways
    const Vec3 middle = mouth + sideways * random.between(-0.5 * r, 0.5 * r) + Vec3(0.0, 0.0, lift);
    paths.insert(paths.begin(), {middle - along * 1.3, middle + along * 1.7, r});
  }
  axis_ = frame_.direction(axis);
  bottom_ = frame_.to_world(mouth - axis * deep);
  mouth_ = frame_.to_world(mouth);
  pull_ = frame_.direction(pull);
  carve(std::move(paths), thinner_mm);
}

const char* name_of(HoleKind kind) {
  return kind == HoleKind::straight ? "straight" : kind == HoleKind::oblique ? "oblique" : "slot";
}

std::string Hole::variant() const { return name_of(kind_); }

/// Out along the axis and back in, pulled aside.
Leg Hole::leg(Random&, const Vec3*) const {
  const double whole = length(outside() - bottom_);
  return {2.0 * whole, [=, this](double s) {
            const double out = s < whole ? s : 2.0 * whole - s;
            return bottom_ + axis_ * out + pull_;
          }};
}

}  // namespace cusp::bench
