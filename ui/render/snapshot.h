/// The tooth as a picture, without a window: for reports and verbs. Any thread, also a window's: each picture is
/// drawn with a context of its own on a thread of its own, and the caller waits for it. An exception of the
/// drawing, as std::bad_alloc, reaches the caller.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "ui/render/tooth_picture.h"

namespace cusp::ui {

enum class PictureError : std::uint8_t {
  no_opengl,  // no context, or an older one than 3.3; detail: which call failed
  drawing,    // OpenGL failed while drawing; detail: its error
};
using PictureFailure = Failure<PictureError>;

struct PictureRequest {
  int width_px = 1200, height_px = 1200;
  Colouring colouring = Colouring::tissue;
  /// Deviation from the target; needed for Colouring::deviation.
  DeviationAt deviation;
  /// Signed distance to the target's walls seen along its approach; empty: no lines.
  std::function<double(Vec3 mm)> sideways_mm;
  double leeway_mm = 0.0;
  std::shared_ptr<const SceneryLook> scenery;  // null: none
  /// Where to look: empty box = the whole specimen from above at a slant.
  Box look_at;
  PresetView view = PresetView::working;
  std::vector<Vec3> places_mm;  // whose position in the picture is wanted
  std::vector<Vec3> closeups_mm;  // a picture of its own each, from a side where nothing hides the place
  std::vector<SurfaceMarks> closeup_marks;  // as many as close-ups, or none: painted in each
  int closeup_px = 360;           // side of a close-up, which shows kCloseupMm from its middle to its edge
};
inline constexpr double kCloseupMm = 3.0;

/// Pixels, top row first, 4 bytes each (R, G, B, A).
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
  std::vector<std::optional<glm::dvec2>> places_px{};  // of places_mm; none: hidden, or outside the picture
  std::vector<Picture> closeups{};                       // of closeups_mm; each has one place
};

Result<Picture, PictureFailure> draw_tooth(const Volume& volume, const PictureRequest& request);

}  // namespace cusp::ui
