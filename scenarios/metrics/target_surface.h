/// The surface that an exact cut of the target would leave in a specimen. Not for the haptic thread.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/modules.h"
#include "scenarios/shapes/target.h"

namespace cusp::scenarios {

/// A triangle of it.
struct SurfacePatch {
  std::array<Vec3, 3> corners;
  double mm2 = 0;
  Vec3 middle() const noexcept { return (corners[0] + corners[1] + corners[2]) / 3.0; }
};

/// Cuts the target out of a copy and takes the triangles that are left, so that both surfaces are known in the same way. Tens
/// of milliseconds. Empty for a filled reading. Pre: the target is not empty.
[[nodiscard]] std::vector<SurfacePatch> target_surface(const TargetShape& target, std::shared_ptr<const Specimen> specimen);

}  // namespace cusp::scenarios
