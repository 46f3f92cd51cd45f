/// Grey values between their voxels, and the surface on which they cross a threshold.
#pragma once

#include <utility>
#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/import/image.h"
#include "scenarios/import/label_map.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Values at the centres of a box of voxels; beyond the outermost centres they go on as they are there.
struct GreyField {
  const std::vector<float>& value;  // [z][y][x]
  IVec3 size;
  Vec3 spacing_mm, origin_mm;

  double at(Vec3 mm) const noexcept;  // trilinear
  IVec3 nearest(Vec3 mm) const noexcept;
};

/// s by the exact distance to where the field crosses from something to nothing, found on the grid's cells; labels are the
/// tissues on the grid, box is what they fill. If label and field differ (a component was removed, a
/// hollow was filled), the label counts.
VoxelVolume volume_of_grey(const GreyField& field, const std::vector<std::pair<double, Tissue>>& thresholds, const Grid& grid,
                           const std::vector<Tissue>& labels, const LabelBox& box, const ImportProgress& progress);

}  // namespace cusp::scenarios
