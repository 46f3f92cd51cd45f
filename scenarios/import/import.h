/// Closed triangle meshes (OBJ, STL, PLY, and what else assimp reads) to a specimen volume. Foreign readers are not to be
/// trusted with foreign files: a program calls these through worker.h, in a process of their own.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/volume/voxel_volume.h"
#include "scenarios/import/import_error.h"
#include "scenarios/import/limits.h"

namespace cusp {

/// The direction of the file that becomes the specimen's +z (occlusal). The turn keeps right hands right.
enum class UpAxis : std::uint8_t { z, y, x, minus_z, minus_y, minus_x };
inline constexpr std::array<std::string_view, 6> kUpAxisKeys = {"z", "y", "x", "-z", "-y", "-x"};  // as typed

struct MeshImport {
  std::filesystem::path path;
  double unit_mm = 1.0;  // length of one unit of the file, > 0
  /// Name of a mesh in the file, and what it is made of. Meshes that are not named are left out. Where meshes overlap
  /// the one of least volume wins, so an inner mesh stands in an outer one whatever the order here.
  std::vector<std::pair<std::string, Tissue>> tissues;
  double voxel_mm = 0.1;
  UpAxis up = UpAxis::z;
  VolumeLimits limits;
};

/// One mesh of a file, for a preview before its tissue is chosen. Lengths in the file's own units and axes.
struct MeshInfo {
  std::string name;
  std::size_t triangles = 0;
  Vec3 low{0.0}, high{0.0};  // bounding box
  double volume = 0.0;       // enclosed, in cubic units; 0 unless closed and oriented
  bool closed = false;       // no edge has an odd number of triangles
  bool oriented = false;     // neighbours are wound alike
  friend bool operator==(const MeshInfo&, const MeshInfo&) = default;
};

/// Share done, 0 to 1; called on the calling thread.
using ImportProgress = std::function<void(double)>;

/// Meshes of a file in the order in which the file names them; parts of one name are one mesh.
[[nodiscard]] Result<std::vector<MeshInfo>, ImportFailure> list_meshes(const std::filesystem::path& path);

/// Reads, checks and voxelises. The file's coordinates times unit_mm are the specimen's; s is the exact distance to the
/// triangles within the band, padded by four voxels. Each mesh must be closed and wound alike (all inside out is
/// mended). Not for the haptic thread: seconds.
[[nodiscard]] Result<VoxelVolume, ImportFailure> import_mesh(const MeshImport& what, const ImportProgress& progress = {});

}  // namespace cusp
