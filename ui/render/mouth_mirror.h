/// A dentist's mouth mirror: a round plane mirror on a handle, and where its picture comes from. Frame: specimen, z up,
/// millimetres. Plain value, any thread.
#pragma once

#include <optional>

#include "ui/render/camera.h"

namespace cusp::ui {

struct MouthMirror {
  Vec3 centre_mm{0.0};
  Vec3 normal{0.0, 0.0, 1.0};  // unit, out of the glass
  Vec3 handle{1.0, 0.0, 0.0};  // unit, in the glass's plane, towards the hand
  static constexpr double kRadiusMm = 10.0;  // of the glass; ISO 9873 size 4 is 22 mm wide with its rim

  friend bool operator==(const MouthMirror&, const MouthMirror&) = default;
};

/// Behind the place as the camera sees it, turned so that the glass shows the side of the place that faces away.
MouthMirror mirror_behind(const Camera& camera, Vec3 place_mm);

/// True if the camera sees the glass, not the back.
bool shows_glass(const MouthMirror& mirror, Vec3 eye_mm) noexcept;
/// A place as the mirror shows it, behind the glass.
Vec3 reflected(const MouthMirror& mirror, Vec3 place_mm) noexcept;
/// Way along the ray to glass or back, mm; nullopt: it misses.
std::optional<double> distance_to(const MouthMirror& mirror, const Ray& ray) noexcept;

/// Moved by millimetres right, up and away in the camera's view.
MouthMirror moved(const MouthMirror& mirror, const Camera& camera, Vec3 by_mm) noexcept;
/// Turned by radians about the view's upright axis, then about the one that points right.
MouthMirror turned(const MouthMirror& mirror, const Camera& camera, glm::dvec2 by_rad) noexcept;

}  // namespace cusp::ui
