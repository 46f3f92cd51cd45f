/// Specimen volumes as NRRD files. Written: NRRD0005, uint16, sizes `2 nx ny nz` (tissue, s in 1/65535), x fastest,
/// space right-anterior-superior, millimetres, gzip, tissue names as key/values `tissue 16:=pulp stone`.
/// Read besides: a plain 3-D map of tissue codes (any integer type, gzip or raw), whose surface is then known to half
/// a voxel only; its s is the distance to the nearest voxel of the other side.
/// Any thread. Nothing is kept between calls; sizes are checked against the limits before memory is taken.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>

#include "engine/base/result.h"
#include "engine/volume/voxel_volume.h"
#include "scenarios/import/import_error.h"
#include "scenarios/import/limits.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// `where` of a failure is the file's name, then the line, key or voxel. Axes in another order or direction (LPS, flipped,
/// permuted) are turned into the specimen frame; oblique ones are refused. A label map is cropped to what it holds and
/// padded by four voxels.
[[nodiscard]] Result<VoxelVolume, ImportFailure> read_nrrd(const std::filesystem::path& file,
                                                           const VolumeLimits& limits = {});
/// The same of a stream of that many bytes, from where it stands.
[[nodiscard]] Result<VoxelVolume, ImportFailure> read_nrrd(std::istream& in, std::uintmax_t bytes, const std::string& name,
                                                           const VolumeLimits& limits = {});

/// VoxelVolume::names of a file, of its header alone: microseconds. Empty for a header that read_nrrd() refuses.
[[nodiscard]] std::map<std::uint8_t, std::string> nrrd_names(const std::filesystem::path& file);

/// A WholeFile (whole_file.h): there is the old file or the whole new one. The same volume gives the same bytes. Refuses
/// (bad_tissue) what read_nrrd would not give back: codes of no tissue, s > 0 in an empty voxel, a name for a code below 16.
[[nodiscard]] Result<void, ImportFailure> write_nrrd(const VoxelVolume& volume, const std::filesystem::path& file);

}  // namespace cusp::scenarios
