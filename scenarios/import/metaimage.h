/// MetaImage volumes: .mha with its data, .mhd with the data in files beside it (one, a list, or slices numbered by a
/// pattern, padded with zeros or not). Coordinates are left-posterior-superior, as ITK has them. Any thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>

#include "scenarios/import/image.h"

namespace cusp::scenarios {

/// A file beside the header, by its plain name: its stream and its length; no stream when there is none.
struct SideFile {
  std::unique_ptr<std::istream> in;
  std::uintmax_t bytes = 0;
};
using SideFiles = std::function<SideFile(const std::string& name)>;

/// `bytes`: length of the header's own file. `name` begins each `where`. Only plain names are asked of `beside`: a
/// header that names a file elsewhere is refused.
[[nodiscard]] Result<Image, ImportFailure> read_metaimage(std::istream& in, std::uintmax_t bytes, const std::string& name,
                                                          const SideFiles& beside, const VolumeLimits& limits = {},
                                                          const ImportProgress& progress = {});
[[nodiscard]] Result<Image, ImportFailure> read_metaimage(const std::filesystem::path& file, const VolumeLimits& limits = {},
                                                          const ImportProgress& progress = {});

}  // namespace cusp::scenarios
