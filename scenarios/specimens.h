/// The one place that turns what a scenario says of its specimen into voxels: a generator's or a file's.
#pragma once

#include <filesystem>

#include "engine/base/result.h"
#include "engine/volume/voxel_volume.h"
#include "scenarios/format/scenario.h"
#include "scenarios/import/import_error.h"

namespace cusp {

/// Generators: "paper-block" (always the paper's 128^3; voxel_mm is not read), "block" and "layered-block" (voxel_mm), "tooth" (fdi, seed,
/// voxel_mm). Without a generator `volume` is a plain file name in `scenario_folder` (NRRD). Seconds at most; not for the
/// haptic thread. `where` of a failure is the key of scenario.json or the file.
[[nodiscard]] Result<VoxelVolume, ImportFailure> make_specimen(const SpecimenSource& source,
                                                               const std::filesystem::path& scenario_folder);

}  // namespace cusp
