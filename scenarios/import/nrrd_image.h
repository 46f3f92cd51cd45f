/// Any NRRD volume as an image, where nrrd.h reads only what may be a specimen as it stands: voxels that are no cubes,
/// oblique axes, grey values, a leading axis of colours, spacings that are not a number. Any thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>

#include "scenarios/import/image.h"

namespace cusp::scenarios {

[[nodiscard]] Result<Image, ImportFailure> read_nrrd_image(std::istream& in, std::uintmax_t bytes, const std::string& name,
                                                           const VolumeLimits& limits = {},
                                                           const ImportProgress& progress = {});
[[nodiscard]] Result<Image, ImportFailure> read_nrrd_image(const std::filesystem::path& file,
                                                           const VolumeLimits& limits = {},
                                                           const ImportProgress& progress = {});
/// Whether the file is a specimen volume as read_nrrd() takes it: tissues with their solid fractions.
bool nrrd_is_specimen(const std::filesystem::path& file);

}  // namespace cusp::scenarios
