/// A grown tooth in its place: turned about z, moved, mirrored when it is of the other side; with its lesions, of
/// natural tissues, of plastic, or as a neighbour of the tooth that an exercise is about.
#pragma once

#include <memory>
#include <vector>

#include "scenarios/teeth/body.h"
#include "scenarios/teeth/caries.h"
#include "scenarios/teeth/shape.h"

namespace cusp::scenarios {

/// place = R(turn about z) * mirrored(tooth) + move; the frame is that of the tooth that the exercise is about.
struct ToothPlace {
  double cos = 1.0, sin = 0.0;
  Vec3 move_mm{0.0};
  bool mirrored = false;
  Vec3 turned(Vec3 v) const noexcept { return {cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z}; }
  Vec3 turned_back(Vec3 v) const noexcept { return {cos * v.x + sin * v.y, cos * v.y - sin * v.x, v.z}; }
  Vec3 from_tooth(Vec3 p) const noexcept {
    if (mirrored) p.x = -p.x;
    return turned(p) + move_mm;
  }
  Vec3 to_tooth(Vec3 p) const noexcept {
    Vec3 q = turned_back(p - move_mm);
    if (mirrored) q.x = -q.x;
    return q;
  }
};

enum class ToothMaterial : std::uint8_t { natural, typodont, neighbour };

class ToothBody final : public Body {
 public:
  /// `shape` must outlive the body.
  ToothBody(const ToothShape& shape, const ToothPlace& place, ToothMaterial material, std::vector<PlacedLesion> lesions = {});

  double outside(Vec3 p) const noexcept override { return shape_->outside(place_.to_tooth(p)); }
  Tissue inside(Vec3 p, double outside_mm) const noexcept override;
  Tissue skin(Vec3 p) const noexcept override;
  Tissue whole(Vec3 p, double far) const noexcept override;
  Vec3 low() const noexcept override { return low_; }
  Vec3 high() const noexcept override { return high_; }

  double above_cej(Vec3 p) const noexcept { return shape_->above_cej(place_.to_tooth(p)); }
  const ToothShape& shape() const noexcept { return *shape_; }
  const ToothPlace& place() const noexcept { return place_; }
  /// Contact points and apex in the frame of the place. "mesial" is the tooth's own, whichever way it lies.
  Vec3 mesial_contact() const noexcept { return place_.from_tooth(shape_->mesial_contact()); }
  Vec3 distal_contact() const noexcept { return place_.from_tooth(shape_->distal_contact()); }

 private:
  Tissue worn(Tissue natural) const noexcept;
  const ToothShape* shape_;
  ToothPlace place_;
  ToothMaterial material_;
  std::vector<PlacedLesion> lesions_;
  Vec3 low_{0.0}, high_{0.0};
};

}  // namespace cusp::scenarios
