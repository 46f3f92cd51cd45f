/// The text part of a NRRD file: what it says, checked against the limits, before anything is read or reserved.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/volume/voxel_volume.h"
#include "scenarios/import/import_error.h"
#include "scenarios/import/limits.h"

namespace cusp {

struct NrrdHeader {
  enum class Content : std::uint8_t {
    tissue_and_s,  // four axes, the first of two: tissue, s
    labels,        // tissue codes alone
  };
  Content content = Content::labels;
  int sample_bytes = 2;      // 1, 2, 4 or 8
  bool sample_signed = false;
  bool big_endian = false;
  bool gzip = true;
  IVec3 file_size{0};        // along the file's own spatial axes, fastest first
  std::array<int, 3> axis{0, 1, 2};    // [file axis]: the specimen's axis along which it runs
  std::array<bool, 3> reversed{};      // [file axis]: runs towards minus
  Grid grid;                 // in the specimen's frame
  std::map<std::uint8_t, std::string> names;
};

/// `text`: all lines before the blank one, magic included. `file` begins each `where`, then comes the line's number.
[[nodiscard]] Result<NrrdHeader, ImportFailure> parse_nrrd_header(std::string_view text, const std::string& file,
                                                                  const VolumeLimits& limits);

/// The header of a tissue-and-s volume, blank line included. Pre: names hold no control characters.
std::string nrrd_header_of(const VoxelVolume& volume);

}  // namespace cusp
