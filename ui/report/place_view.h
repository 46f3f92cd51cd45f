/// Where to look from, so that a place on the tooth is seen. No widget. Any thread.
#pragma once

#include <vector>

#include "ui/render/camera.h"
#include "ui/render/patch_store.h"

namespace cusp::ui {

/// Meshes that may hide a place: the tooth itself, and what stands about it. None is null.
using Meshes = std::vector<const PatchStore*>;

/// Nothing lies between the camera's eye and the place.
bool seen_from(const Camera& camera, const Meshes& meshes, Vec3 place_mm);

/// `now` turned so that the place comes to the middle, faces the viewer and is hidden by nothing; its distance stays. Of the
/// views that show the place the one that the surface faces most wins, those from above before those from the side. Where
/// none shows it, the view from above. The first mesh is the tooth. Tries some hundred rays: about 10 ms for a molar.
Camera look_at_place(const Camera& now, const Meshes& meshes, Vec3 place_mm);

}  // namespace cusp::ui
