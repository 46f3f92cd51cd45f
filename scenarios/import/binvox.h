/// .binvox files: runs of one byte a voxel, x slowest, then z, y fastest. Any thread.
/// Format: the author's page (patrickmin.com/binvox/binvox.html): a voxel's normalised centre (i + 1/2) / n, times
/// `scale`, plus `translate`, n being the largest of the three sizes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/import/image.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// The whole header: write_binvox of a read file gives it back bit for bit.
struct Binvox {
  IVec3 size{0};  // voxels along x, y, z
  Vec3 translate{0.0};
  double scale = 1.0;
  std::vector<std::uint8_t> value;  // [z][y][x], 0: nothing
  friend bool operator==(const Binvox&, const Binvox&) = default;
};

/// Of a stream of that many bytes. `name` begins each `where`. Runs that end early or go on too long are refused; the
/// sizes are held against the limits and against the runs that there can be before memory is taken.
[[nodiscard]] Result<Binvox, ImportFailure> read_binvox(std::istream& in, std::uintmax_t bytes, const std::string& name,
                                                        const VolumeLimits& limits = {});
[[nodiscard]] Result<Binvox, ImportFailure> read_binvox(const std::filesystem::path& file, const VolumeLimits& limits = {});

/// A WholeFile (whole_file.h): the old file or the whole new one.
[[nodiscard]] Result<void, ImportFailure> write_binvox(const Binvox& what, const std::filesystem::path& file);

/// Labels on cubic voxels. The file has no unit: spacing_known is false, and one unit stands as a millimetre.
[[nodiscard]] Result<Image, ImportFailure> image_of(const Binvox& what, const std::string& name, const VolumeLimits& limits);
/// 1 where s >= 1/2: a .binvox holds neither tissues nor surfaces finer than a voxel.
Binvox binvox_of(const VoxelVolume& volume);

}  // namespace cusp::scenarios
