/// The header of a NRRD file, checked against the limits before any data is read or reserved.
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
#include "scenarios/modules.h"

namespace cusp::scenarios {

struct NrrdHeader {
  enum class Content : std::uint8_t {
    tissue_and_s,  // four axes, the first of two: tissue, s
    labels,        // one number a voxel: in a specimen a tissue code
    colours,       // images only: four axes, the first of three or four bytes
  };
  Content content = Content::labels;
  int sample_bytes = 2;      // 1, 2, 4 or 8
  bool sample_signed = false;
  bool sample_float = false;  // images only
  int samples = 1;            // along the first of four axes
  bool big_endian = false;
  bool gzip = true;
  IVec3 file_size{0};        // along the file's own spatial axes, fastest first
  std::array<int, 3> axis{0, 1, 2};    // [file axis]: the specimen's axis along which it runs
  std::array<bool, 3> reversed{};      // [file axis]: runs towards minus
  Grid grid;                 // in the specimen's frame
  std::map<std::uint8_t, std::string> names;

  // Of an image instead of axis, reversed and grid:
  std::array<Vec3, 3> step_mm{};  // [file axis], right-anterior-superior
  Vec3 first_mm{0.0};
  double unit_mm = 1.0;           // 0: a unit that is not known
  bool spacing_known = true;
  bool sides_known = true;        // false: the file names no space
};

/// A specimen must have cubic voxels, straight axes and codes; an image need not.
enum class NrrdUse : std::uint8_t { specimen, image };

/// `text`: all lines before the blank one, magic included. `file` begins each `where`, then comes the line's number.
[[nodiscard]] Result<NrrdHeader, ImportFailure> parse_nrrd_header(std::string_view text, const std::string& file,
                                                                  const VolumeLimits& limits,
                                                                  NrrdUse use = NrrdUse::specimen);

/// The header of a tissue-and-s volume, blank line included. Pre: names hold no control characters.
std::string nrrd_header_of(const VoxelVolume& volume);

}  // namespace cusp::scenarios
