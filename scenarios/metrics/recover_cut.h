/// A prepared specimen from a volume file: which cuts left it. Not for the haptic thread; a second for a molar at 0.1 mm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "engine/base/result.h"
#include "engine/volume/volume.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Why a volume is not one of the specimen's. `where` of the failure is empty; `detail` has a number where one is named.
enum class RecoverError : std::uint8_t {
  other_voxel,    // edge of the voxels; detail: the file's, mm
  other_frame,    // voxels between those of the specimen
  other_tissue,   // tissue where the specimen has none; detail: mm3 of it
  other_surface,  // the same tissue, but a surface that no cut explains: a label volume knows it to half a voxel
  too_much_cut,   // more bricks than a volume keeps
};

/// Tissue beyond the specimen up to this is rounding of another program: a cube of three voxels.
inline constexpr std::size_t kForeignVoxels = 27;

/// F = min(B, C) of the file gives the cut field C wherever it lies below the base B. Beside the mouth of a cut C is
/// continued by four voxels along its own slope, which is exact for a plane; there the surface is not F's. Voxels
/// outside the file's grid are empty.
[[nodiscard]] Result<Volume, Failure<RecoverError>> recover_cut(std::shared_ptr<const Specimen> specimen,
                                                                const VoxelVolume& prepared);

}  // namespace cusp::scenarios
