/// Files that are read whole into memory: volumes, exercises, packs. A folder, a pipe, a device and a file that is longer than the caller
/// admits are refused before any of it is read. Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/import/import_error.h"
#include "scenarios/import/limits.h"
#include "storage/base/error.h"
#include "ui/modules.h"

namespace cusp::ui {

/// The longest file that read_nrrd() takes: a label map of VolumeLimits::max_voxels samples of 8 bytes each without packing, behind a
/// header of 1 MiB (kMaxHeaderBytes of scenarios/import/packed_data.cpp). Longer than any written one, which has 4 bytes a voxel.
inline constexpr std::uintmax_t kMostVolumeBytes = std::uintmax_t{8} * VolumeLimits{}.max_voxels + (std::uintmax_t{1} << 20);

// Each fails with not_found, file_too_large (longer than `most_bytes`), or io: no regular file, or what the disk refuses, with the
// system's reason as detail. `where` is the file.

/// Calls visit(piece), which may fail, for all that the file holds, in order.
Stored<void> for_pieces(const std::filesystem::path& file, std::uintmax_t most_bytes,
                        const std::function<Stored<void>(std::string_view piece)>& visit);
Stored<std::vector<std::byte>> bytes_of(const std::filesystem::path& file, std::uintmax_t most_bytes = kMostVolumeBytes);
Stored<std::string> text_of_file(const std::filesystem::path& file, std::uintmax_t most_bytes);

/// Such a failure of a volume's file, as readers of volumes name it.
ImportFailure import_failure_of(const StorageFailure& failure);

}  // namespace cusp::ui
