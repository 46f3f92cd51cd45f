/// The crown of a grown tooth, turned and shifted against the grid and cut down to a box about a preparation.
/// Frame: specimen; z is the axis of the preparation.
#pragma once

#include <memory>

#include "scenarios/shapes/distance.h"
#include "scenarios/teeth/shared_shape.h"
#include "scenarios/teeth/tables.h"
#include "scenarios/teeth/tooth_body.h"
#include "scenarios/teeth/voxels.h"
#include "tests/scenarios/metrics/preparation.h"

namespace cusp::test {

/// A tooth turned about z after it was tilted about a level axis.
struct Orientation {
  double turn_deg = 0, tilt_deg = 0, towards_deg = 0;

  glm::dmat3 rotation() const {
    const auto about_z = [](double deg) {
      const double c = std::cos(deg * kRadians), s = std::sin(deg * kRadians);
      return glm::dmat3(Vec3(c, s, 0), Vec3(-s, c, 0), Vec3(0, 0, 1));
    };
    const double c = std::cos(tilt_deg * kRadians), s = std::sin(tilt_deg * kRadians);
    const glm::dmat3 about_y(Vec3(c, 0, -s), Vec3(0, 1, 0), Vec3(s, 0, c));
    return about_z(turn_deg + towards_deg) * about_y * about_z(-towards_deg);
  }
};

inline Orientation random_orientation(Draw& draw) {
  const double turn = draw(-20, 20), tilt = draw(0, 8), towards = draw(0, 360);
  return {turn, tilt, towards};
}

class TurnedCrown final : public Body {
 public:
  /// `middle`: place of the crown's middle in plan. The surface there has z = middle.z.
  TurnedCrown(int fdi, double voxel_mm, const Orientation& orientation, Vec3 middle)
      : fdi_(fdi), shape_(shared_shape(*table_for(fdi)->table, 0, voxel_mm)),
        tooth_(*shape_, ToothPlace{.mirrored = table_for(fdi)->mirrored}, ToothMaterial::natural), turn_(orientation.rotation()), middle_(middle) {
    const Vec3 crown = 0.5 * (tooth_.low() + tooth_.high());
    shift_ = middle - turn_ * Vec3(crown.x, crown.y, tooth_.high().z);
    shift_.z += middle.z - top_at(middle.x, middle.y);
    centre_ = middle + Vec3(0, 0, 0.5 * (kAbove - kBelow));
    half_ = Vec3(6.5, 3.1, 0.5 * (kAbove + kBelow));
    find_pulp();
  }
  int fdi() const { return fdi_; }
  Vec3 middle() const { return middle_; }

  /// Of the whole tooth.
  double surface(Vec3 p) const noexcept { return tooth_.outside(to_tooth(p)); }
  double dentine(Vec3 p) const noexcept {
    const Vec3 q = to_tooth(p);
    return shape_->dentine(tooth_.place().to_tooth(q), tooth_.outside(q));
  }
  double pulp(Vec3 p) const noexcept { return shape_->pulp(tooth_.place().to_tooth(to_tooth(p))); }
  /// Height of the tooth at a place in plan; below -100 where there is none.
  double top_at(double x, double y) const noexcept {
    double z = middle_.z + kAbove;
    for (int i = 0; i < 300 && z > middle_.z - 20.0; ++i) {
      const double d = surface({x, y, z});
      if (d < 1e-5) return z;
      z -= 0.7 * std::min(d, 2.0);
    }
    return -1e3;
  }
  /// Places on the pulp's surface within the box, about 0.1 mm apart.
  const std::vector<Vec3>& pulp_places() const noexcept { return pulp_places_; }
  double highest() const noexcept { return centre_.z + half_.z; }

  double outside(Vec3 p) const noexcept override { return std::max(surface(p), box_distance(p, centre_, half_)); }
  Tissue inside(Vec3 p, double) const noexcept override {
    const Vec3 q = to_tooth(p);
    return tooth_.inside(q, tooth_.outside(q));
  }
  Tissue skin(Vec3 p) const noexcept override { return inside(p, 0.0) == Tissue::cementum ? Tissue::cementum : Tissue::enamel; }
  Tissue whole(Vec3 p, double far) const noexcept override { return tooth_.whole(to_tooth(p), far); }
  Vec3 low() const noexcept override { return centre_ - half_; }
  Vec3 high() const noexcept override { return centre_ + half_; }

 private:
  void find_pulp() {
    constexpr double kStep = 0.1;
    const Vec3 low = middle_ - Vec3(2.4, 2.4, 0.8 * kBelow), high = middle_ + Vec3(2.4, 2.4, -1.0);
    for (double z = low.z; z < high.z; z += kStep)
      for (double y = low.y; y < high.y; y += kStep)
        for (double x = low.x; x < high.x; x += kStep) {
          Vec3 at(x, y, z);
          const double d = pulp(at);
          if (std::fabs(d) > kStep) continue;
          for (int pass = 0; pass < 3; ++pass) {
            const Vec3 g = Vec3(pulp(at + Vec3(1e-3, 0, 0)), pulp(at + Vec3(0, 1e-3, 0)), pulp(at + Vec3(0, 0, 1e-3))) - pulp(at);
            at -= pulp(at) * 1e-3 / std::max(glm::dot(g, g), 1e-9) * g;
          }
          pulp_places_.push_back(at);
        }
  }
  static constexpr double kAbove = 2.6, kBelow = 5.2;  // mm of the crown about its middle

  Vec3 to_tooth(Vec3 p) const noexcept { return glm::transpose(turn_) * (p - shift_); }

  int fdi_;
  std::shared_ptr<const ToothShape> shape_;
  ToothBody tooth_;
  glm::dmat3 turn_;
  std::vector<Vec3> pulp_places_;
  Vec3 middle_, shift_{0.0}, centre_{0.0}, half_{0.0};
};

inline std::shared_ptr<const Specimen> specimen_of(const TurnedCrown& crown, double voxel_mm) {
  return Specimen::build(*voxels_of(crown, voxel_mm, nullptr, {}, 0.0), Reading::banded);
}

}  // namespace cusp::test
