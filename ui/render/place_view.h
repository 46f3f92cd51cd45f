/// Finds a camera that sees a place on the tooth. No widget. Thread: any. Units: millimetres.
#pragma once

#include <vector>

#include "ui/render/camera.h"
#include "ui/render/patch_store.h"

namespace cusp::ui {

/// Meshes that may hide a place: first the tooth, then the scenery. No null pointers.
using Meshes = std::vector<const PatchStore*>;

/// True if no mesh lies between the camera's eye and the place.
bool seen_from(const Camera& camera, const Meshes& meshes, Vec3 place_mm);

/// `now` with the place in the middle of the picture, at the same distance, turned so that no mesh hides it and the surface about it
/// is seen. Prefers views that the surface faces and views from above; if no view shows the place, the view from above. Casts some
/// hundred rays: 4 to 8 ms for a premolar, up to 24 ms for a box between neighbours.
Camera look_at_place(const Camera& now, const Meshes& meshes, Vec3 place_mm);

/// The same view, moved so that the tooth keeps margin_px from each edge of a picture of this size where it has room. Unchanged if the
/// place would then be hidden.
Camera keep_in_picture(const Camera& view, const Meshes& meshes, Vec3 place_mm, glm::dvec2 picture_px, double margin_px);

}  // namespace cusp::ui
