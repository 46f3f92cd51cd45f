/// A specimen as bytes for the database: a session keeps the voxels that it began with, so that its replay never depends
/// on a generator of another day.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/volume/voxel_volume.h"
#include "ui/modules.h"

namespace cusp::ui {

std::vector<std::byte> specimen_bytes(const VoxelVolume& volume);
/// nullopt when the bytes are not a whole specimen. Sizes are checked before memory is taken.
std::optional<VoxelVolume> specimen_from_bytes(std::span<const std::byte> bytes);

}  // namespace cusp::ui
