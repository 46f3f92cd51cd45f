#include "scenarios/metrics/groups.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "scenarios/metrics/box.h"
#include "scenarios/metrics/caries.h"
#include "scenarios/metrics/margin.h"
#include "scenarios/metrics/proximal.h"
#include "scenarios/metrics/surface.h"
#include "scenarios/metrics/unsupported.h"
#include "scenarios/metrics/volume.h"

namespace cusp::scenarios {

namespace {

/// Whether over-cut is asked for by a face's name.
bool asks_for_faces(const Reference& reference) {
  return std::ranges::any_of(kFaceKeys, [&](std::string_view face) {
    for (const char* start : {"overcut_leeway_", "overcut_beyond_"})
      if (reference.asks(std::string(start) + std::string(face))) return true;
    return false;
  });
}

}  // namespace

void add_groups(const CutFaces& faces, const std::vector<MarginPoint>& margin, const Reference& reference, const Volume& volume,
                std::vector<Measure>& out) {
  const auto wanted = [&](std::initializer_list<std::string_view> starts) {
    return std::ranges::any_of(starts, [&](std::string_view start) { return reference.asks(start); });
  };
  if (asks_for_faces(reference)) add_volume(reference, volume, out);
  if (wanted({"surface_"})) add_surface(reference, volume, out);
  if (wanted({"gingival_above_cej", "box_height", "axial_past_junction_"})) add_box(faces, reference, volume, out);
  if (wanted({"cavosurface_"})) add_margin(margin, reference, out);
  if (wanted({"unsupported_enamel"})) add_unsupported(reference, volume, out);
  if (wanted({"contact_broken", "clearance_", "gingival_floor_"})) add_proximal(faces, margin, reference, volume, out);
  if (wanted({"caries_left_", "sound_lost"})) add_caries(reference, volume, out);
}

}  // namespace cusp::scenarios
