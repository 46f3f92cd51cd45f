/// Named places on a grown tooth, in the specimen frame (mm): what a cavity is laid along and what tests measure.
/// Frame: y buccal, z occlusal, z = 0 at the buccal CEJ; x mesial in quadrants 1 and 3, distal in 2 and 4.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::scenarios {

/// The way in which "mesial" lies on a tooth along its frame's x: 1 in quadrants 1 and 3, -1 in 2 and 4, 0 if `fdi` is no
/// tooth's number.
constexpr int mesial_x(int fdi) noexcept {
  const int quadrant = fdi / 10;
  return quadrant < 1 || quadrant > 4 ? 0 : quadrant % 2 == 1 ? 1 : -1;
}

/// A named line on the surface, sampled about every 0.1 mm.
struct SurfaceLine {
  std::string name;  // key of teeth.json: "central mesial", "lingual", ...
  std::vector<Vec3> points_mm;
};

struct SurfacePlace {
  std::string name;  // key of teeth.json: "MB", "central", ...
  Vec3 at_mm{0.0};
};

/// Lengths as they are measured on teeth (mm). Crown and root from the buccal CEJ; necks at the CEJ of each side.
struct ToothDims {
  double crown_length = 0, root_length = 0;
  double mesiodistal = 0, mesiodistal_neck = 0;
  double buccolingual = 0, buccolingual_neck = 0;
};

struct ToothLandmarks {
  std::vector<SurfacePlace> cusp_tips;      // highest point of each cusp; of an incisor: of its edge
  std::vector<SurfacePlace> pits;           // bottoms, deepest point near each pit of the table
  std::vector<SurfaceLine> fissures;        // along the bottom of each occlusal groove, pit first
  std::vector<SurfaceLine> marginal_ridges; // "mesial marginal", "distal marginal": the crests; none on front teeth
  std::vector<Vec3> cej;                    // closed line round the neck, from mesial over buccal; last = first
  Vec3 mesial_contact{0.0};                 // most mesial point
  Vec3 distal_contact{0.0};                 // most distal point
  Vec3 central{0.0};                        // central pit; without one, the middle of the central groove
  ToothDims dims;                           // of this tooth, after its seed

  /// The fissure of that name; nullptr when the tooth has none.
  const SurfaceLine* fissure(std::string_view name) const noexcept {
    for (const SurfaceLine& line : fissures) {
      if (line.name == name) return &line;
    }
    return nullptr;
  }
};

}  // namespace cusp::scenarios
