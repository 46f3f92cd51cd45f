/// A scenario's specimen source as voxels: from a generator or a file.
#pragma once

#include <filesystem>

#include "engine/base/result.h"
#include "engine/volume/voxel_volume.h"
#include "scenarios/format/scenario.h"
#include "scenarios/import/import_error.h"
#include "scenarios/modules.h"
#include "scenarios/teeth/tooth.h"

namespace cusp::scenarios {

/// Generators: "paper-block" (always the paper's 128^3; voxel_mm is not read), "block" and "layered-block" (voxel_mm), "tooth" (fdi, seed,
/// voxel_mm). Without a generator `volume` is a plain file name in `scenario_folder` (NRRD). Seconds at most; not for the
/// haptic thread. `where` of a failure is the key of scenario.json or the file. A tooth stops early, with
/// ImportError::cancelled, once *cancel is true, and reports its progress.
[[nodiscard]] Result<VoxelVolume, ImportFailure> make_specimen(const SpecimenSource& source,
                                                               const std::filesystem::path& scenario_folder,
                                                               ToothCancel cancel = nullptr,
                                                               const ToothProgress& progress = {});

/// What a "tooth" source asks of the generator.
[[nodiscard]] ToothRequest tooth_request(const SpecimenSource& source);

/// The tissues that a "tooth" source will hold, by code; empty for any other source.
[[nodiscard]] std::vector<Tissue> tissues_of(const SpecimenSource& source);

/// The rest of the jaw of a source that asks for it, as scenery: no voxels. Empty for any other source. Seconds; not for
/// the haptic thread. Cancelled as above.
[[nodiscard]] Result<std::vector<JawSurface>, ImportFailure> make_scenery(const SpecimenSource& source,
                                                                          ToothCancel cancel = nullptr);

}  // namespace cusp::scenarios
