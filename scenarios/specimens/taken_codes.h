/// Codes of a grown tooth's tissues (scenarios/teeth/own_tissues.h) that a volume from elsewhere gives to tissues of its own.
#pragma once

#include <optional>
#include <string>

#include "engine/volume/voxel_volume.h"
#include "scenarios/import/import_error.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// ImportError::code_taken if the volume holds or names such a code by another name than a grown tooth: the measures would take the
/// author's tissue for a neighbour, or for firm caries. `where` is `name`; detail: the author's name of the tissue, else its code. What Cusp
/// wrote of a grown tooth passes. Tens of milliseconds. Any thread.
[[nodiscard]] std::optional<ImportFailure> refuse_taken_codes(const VoxelVolume& volume, const std::string& name);

}  // namespace cusp::scenarios
