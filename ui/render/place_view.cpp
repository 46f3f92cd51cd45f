#include "ui/render/place_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace cusp::ui {
namespace {

constexpr int kTurns = 16;  // views about the tooth's axis
constexpr std::array<double, 6> kPitches = {1.45, 1.2, 0.95, 0.7, 0.45, 0.15};  // radians above the horizon
constexpr double kFromAbove = 1.0;   // weight of a view from above, against the cosine of the surface's slant
constexpr double kAsUsual = 0.3;     // weight of the usual turn about the axis, likewise
constexpr double kOnPlaceMm = 0.5;   // a ray that ends farther from the place has missed its surface

}  // namespace

bool seen_from(const Camera& camera, const Meshes& meshes, Vec3 place_mm) {
  return std::ranges::all_of(meshes, [&](const PatchStore* mesh) { return mesh->shows(place_mm, camera.eye_mm()); });
}

Camera look_at_place(const Camera& now, const Meshes& meshes, Vec3 place_mm) {
  Camera above = now;
  above.set_centre(place_mm);
  above.set_preset(PresetView::occlusal);
  Camera best = above;
  double most = -1.0;
  for (const double pitch : kPitches) {
    for (int turn = 0; turn < kTurns; ++turn) {
      Camera view = above;
      view.set_angles(above.yaw() + 2 * std::numbers::pi * turn / kTurns, pitch);
      if (!seen_from(view, meshes, place_mm)) continue;
      const Vec3 to_eye = -view.forward();
      const auto hit = meshes.front()->pick({view.eye_mm(), view.forward()});
      const bool on_place = hit && glm::length(hit->at_mm - place_mm) < kOnPlaceMm;
      const double worth = (on_place ? glm::dot(hit->normal, to_eye) : 0.0) + kFromAbove * to_eye.z +
                           kAsUsual * std::cos(view.yaw() - above.yaw());
      if (worth <= most + 1e-9) continue;
      most = worth;
      best = view;
    }
  }
  return best;
}

}  // namespace cusp::ui
