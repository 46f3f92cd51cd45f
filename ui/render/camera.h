/// Where the eye is: an orbit about a point of the specimen. Frame: specimen, z up, millimetres; angles in radians.
/// Plain value, any thread.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/base/vec.h"

namespace cusp::ui {

struct Ray {
  Vec3 from_mm{0.0};
  Vec3 along{0.0, 0.0, -1.0};  // unit
};

/// Views with a key of their own, 1 to 5 in the order of the drilling screen's turn menu.
enum class PresetView : std::uint8_t { working, occlusal, buccal, lingual, distal };

class Camera {
 public:
  /// Looks at `centre`, far enough that a ball of `radius_mm` about it fills the shorter side of the view.
  static Camera about(Vec3 centre_mm, double radius_mm);

  /// Turns by angles; pitch stops short of the poles.
  void orbit(double yaw, double pitch) noexcept;
  /// Factor above 1 comes nearer. The distance stays within 0.15 and 8 times the first one.
  void zoom(double factor) noexcept;
  /// Moves the centre in the view's plane by pixels of a view whose shorter side has `shorter_px`.
  void pan(glm::dvec2 by_px, double shorter_px) noexcept;
  /// `mesial_x`: the way of mesial along x (scenarios/teeth/landmarks.h).
  void set_preset(PresetView view, int mesial_x = 1) noexcept;
  void set_centre(Vec3 mm) noexcept { centre_ = mm; }
  void set_angles(double yaw, double pitch) noexcept;

  Vec3 centre_mm() const noexcept { return centre_; }
  Vec3 eye_mm() const noexcept;
  double distance_mm() const noexcept { return distance_; }
  double yaw() const noexcept { return yaw_; }
  double pitch() const noexcept { return pitch_; }
  /// Unit vectors of the view in the specimen frame; `right` is what lies right in the picture.
  Vec3 right() const noexcept;
  Vec3 up() const noexcept;
  Vec3 forward() const noexcept;

  glm::dmat4 view_from_world() const noexcept;
  /// Depth range fits a ball of `reach_mm` about the centre.
  glm::dmat4 clip_from_view(double aspect, double reach_mm) const noexcept;
  glm::dmat4 clip_from_world(double aspect, double reach_mm) const noexcept;

  /// Through a pixel (from the upper left corner) of a view of this size.
  Ray ray(glm::dvec2 at_px, glm::dvec2 view_px) const noexcept;
  /// Pixel of a place; nullopt behind the eye.
  std::optional<glm::dvec2> project(Vec3 mm, glm::dvec2 view_px) const noexcept;
  /// Pixels a millimetre covers at the centre, in a view whose shorter side has `shorter_px`.
  double px_per_mm(double shorter_px) const noexcept;

  friend bool operator==(const Camera&, const Camera&) = default;

 private:
  Vec3 centre_{0.0};
  double distance_ = 30.0;
  double first_distance_ = 30.0;
  double yaw_ = 0.0;    // 0: the eye on the +y side (buccal), x pointing left; grows as the eye goes towards -x
  double pitch_ = 1.0;  // above the occlusal plane
};

}  // namespace cusp::ui
