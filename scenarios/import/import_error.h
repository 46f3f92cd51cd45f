/// Why a specimen could not be read, made or written. One list for volume files, meshes, the import worker and the
/// generators, so that a caller of make_specimen describes one set of codes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/base/result.h"

namespace cusp::scenarios {

enum class ImportError : std::uint8_t {
  missing_file,     // no file there
  io,               // it cannot be read or written (permissions, full disk); detail: the system's message
  unknown_format,   // not of a kind that is read here
  bad_header,       // where: file and line or key
  unsupported,      // a legal file that asks for what is not read here; where: the key
  bad_sizes,        // an axis count or size that makes no volume
  bad_spacing,      // voxels are not cubes, or their edge is not a number within limits
  bad_orientation,  // axes are oblique or of a space that is not known
  bad_tissue,       // a code above 31, or a name that contradicts its code; where: voxel or key
  truncated,        // the data end early
  corrupt,          // the data do not unpack, or go on after their end
  too_large,        // more voxels than the limits allow; found before memory is taken
  nothing_solid,    // no voxel is occupied
  no_mesh,          // the file holds no triangle, or none was chosen
  mesh_not_found,   // where: the name or the label that was asked for
  mesh_empty,       // encloses no volume; where: its name
  mesh_open,        // an edge with one triangle only; where: name and place in the file's units
  mesh_not_oriented,  // neighbours wound against each other; where: name and place
  mesh_ambiguous,   // cuts or overlaps itself, so that inside is not defined; where: name
  bad_option,       // unit, voxel size or a name given twice; where: the option
  crashed,          // the import's process ended by a fault
  time_limit,       // it took longer than allowed
  out_of_memory,    // it wanted more memory than allowed
  cancelled,        // the user stopped it
  not_started,      // no process could be started
  unknown_generator,  // where: its name
  code_taken,       // a file's own tissue has the code of a grown tooth's; detail: its name, else its code
};
inline constexpr std::size_t kImportErrors = 27;

using ImportFailure = Failure<ImportError>;

/// Stable keys, as in --json and between the import's process and its parent.
inline constexpr std::array<std::string_view, kImportErrors> kImportErrorKeys = {
    "missing_file",   "io",           "unknown_format", "bad_header",        "unsupported",    "bad_sizes",
    "bad_spacing",    "bad_orientation", "bad_tissue",  "truncated",         "corrupt",        "too_large",
    "nothing_solid",  "no_mesh",      "mesh_not_found", "mesh_empty",        "mesh_open",      "mesh_not_oriented",
    "mesh_ambiguous", "bad_option",   "crashed",        "time_limit",        "out_of_memory",  "cancelled",
    "not_started",    "unknown_generator", "code_taken"};

constexpr std::string_view key_of(ImportError code) noexcept { return kImportErrorKeys[static_cast<std::size_t>(code)]; }

constexpr std::optional<ImportError> import_error_from_key(std::string_view key) noexcept {
  for (std::size_t i = 0; i < kImportErrors; ++i) {
    if (kImportErrorKeys[i] == key) return static_cast<ImportError>(i);
  }
  return std::nullopt;
}

}  // namespace cusp::scenarios
