#include "tests/bench/cut_shape.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/surface_contact.h"

namespace cusp::bench {

namespace {

constexpr double kPieceMm = 0.1;
constexpr double kAbove = 0.05;
constexpr double kCutterOverBurr = 1.5;
constexpr double kRadians = 0.017453292519943296;

class Cut : public CutBlock {
 public:
  Cut(double r, bool crossing) : CutBlock("cut", r), crossing_(crossing) {
    // Three lines round a triangle 1 mm wide, each a little inclined; depths below the face 0.3 to 0.6 burr radii.
    const double big = kCutterOverBurr * r;
    std::vector<Capsule> paths;
    const double wide = 0.35, reach = 1.6;
    for (int i = 0; i < (crossing ? 3 : 1); ++i) {
      const double phi = 0.4 + 2.0943951 * i + 0.13 * i * i;
      const Vec3 out(std::cos(phi), std::sin(phi), 0.0), along(-std::sin(phi), std::cos(phi), 0.0);
      const Vec3 up(0.0, 0.0, 1.0);
      paths.push_back({out * wide - along * reach + up * (big - 0.3 * r),
                       out * wide + along * reach + up * (big - (0.45 + 0.07 * i) * r), big});
    }
    carve(paths, SurfaceContact::kClearanceMm);
  }
  std::string variant() const override { return crossing_ ? "crossing" : "single"; }
  Vec3 tool_axis() const override { return frame_.z; }
  Vec3 home() const override { return frame_.to_world({0.0, 0.0, 14.0}); }
  double cutter_radius_mm() const override { return kCutterOverBurr * burr_radius_mm(); }

  /// On a ridge or a mouth a small burr's device point would lie beyond the edge, where no minimum is meant.
  Spot spot(Random& random) const override {
    for (;;) {
      const Vec3 c = over(random.between(-kSide, kSide), random.between(-kSide, kSide), 1e-8);
      if (burr_radius_mm() < kDepthMm + 0.02 && block_->edge_nearest(c)) continue;
      Vec3 slope;
      constexpr double kStep = 1e-6;
      for (int i = 0; i < 3; ++i) {
        Vec3 d(0.0);
        d[i] = kStep;
        slope[i] = block_->clearance_mm(c + d) - block_->clearance_mm(c - d);
      }
      // Two faces at once have no one normal: the slope across them is less than one.
      if (length(slope) < 1.99 * kStep) continue;
      return {c, unit(slope)};
    }
  }
  /// Straight over the scratched part as seen from above, kDepthMm below the height at which the burr rests there.
  Leg leg(Random& random, const Vec3* from) const override {
    const auto aim = [&] { return Vec3(random.between(-kSide, kSide), random.between(-kSide, kSide), 0.0); };
    const Vec3 a = from ? frame_.to_local(*from) : aim();
    Vec3 b = aim();
    while (std::hypot(b.x - a.x, b.y - a.y) < 0.2) b = aim();
    const double whole = std::hypot(b.x - a.x, b.y - a.y);
    return {whole, [this, a, b, whole](double s) {
              const double t = s / whole;
              return over(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, 1e-5) - frame_.z * kDepthMm;
            }};
  }
  Vec3 before(Vec3 first) const override { return first + frame_.z * (kDepthMm + kAbove); }

 private:
  static constexpr double kSide = 1.2;
  bool crossing_;
  /// Where the burr rests when it is let down along the face's normal.
  Vec3 over(double x, double y, double precision_mm) const {
    double high = burr_radius_mm() + 1e-6, low = 0.0;
    while (high - low > precision_mm) {
      const double middle = 0.5 * (high + low);
      (block_->clearance_mm(frame_.to_world({x, y, middle})) >= 0.0 ? high : low) = middle;
    }
    return frame_.to_world({x, y, high});
  }
};

}  // namespace

void CutBlock::carve(std::vector<Capsule> local, double thinner_mm) {
  for (Capsule& c : local) {
    c.a = frame_.to_world(c.a);
    c.b = frame_.to_world(c.b);
  }
  block_ = std::make_shared<CarvedBlock>(frame_.z, glm::dot(frame_.z, frame_.origin), std::move(local),
                                         burr_radius_mm(), thinner_mm);
}

bool CutBlock::prepare(StepState& state) const {
  const std::uint16_t cutter = cutter_radius_mm() > 0.0 ? 1 : 0;
  bool room = true;
  for (const Capsule& c : block_->capsules()) {
    const int pieces = static_cast<int>(length(c.b - c.a) / kPieceMm) + 1;
    for (int k = 0; k < pieces; ++k)
      room = cut_along(state, cutter, c.a + (c.b - c.a) * (static_cast<double>(k) / pieces),
                       c.a + (c.b - c.a) * (static_cast<double>(k + 1) / pieces)) &&
             room;
  }
  return room;
}

std::unique_ptr<Shape> make_cut(double burr_radius_mm, bool crossing) {
  return std::make_unique<Cut>(burr_radius_mm, crossing);
}

Hole::Hole(double r, HoleKind kind, std::uint64_t seed, double thinner_mm)
    : CutBlock("channel", r), kind_(kind), seed_(seed) {
  Random random(seed * 3 + static_cast<std::uint64_t>(kind));
  const double tilt = kRadians * (kind == HoleKind::straight ? random.between(0.0, 5.0) : random.between(10.0, 70.0));
  const double turn = random.between(0.0, 360.0) * kRadians;
  const double deep = random.between(0.4, 1.3);
  const Vec3 mouth(random.between(-0.5, 0.5), random.between(-0.5, 0.5), 0.0);
  const Vec3 axis(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt));
  // From well outside, where the burr touches nothing yet, to its depth below the face along the axis.
  std::vector<Capsule> paths{{mouth + axis * (1.5 * r / std::cos(tilt) + 0.2), mouth - axis * deep, r}};
  const double side = random.between(0.0, 360.0) * kRadians;
  const Frame across = Frame::of(axis, {0.3, 1.0, 0.2}, Vec3(0.0));
  const Vec3 pull = across.direction({std::cos(side), std::sin(side), 0.0}) * 0.1;
  if (kind == HoleKind::slot) {
    // Its axis lies 0.3 radii above to 0.6 below the face, and passes the mouth within half a radius.
    const double way = random.between(0.0, 360.0) * kRadians;
    const Vec3 along(std::cos(way), std::sin(way), random.between(-0.1, 0.1)), sideways(-along.y, along.x, 0.0);
    const Vec3 middle =
        mouth + sideways * random.between(-0.5 * r, 0.5 * r) + Vec3(0.0, 0.0, random.between(-0.6 * r, 0.3 * r));
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
