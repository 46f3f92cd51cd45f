/// What an imported specimen may measure. Reckoned from headers and bounding boxes before memory is taken.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cusp::scenarios {

struct VolumeLimits {
  int max_edge_voxels = 2048;                            // along one axis
  std::size_t max_voxels = std::size_t{512} * 512 * 512;  // 400 MB dense (3 bytes a voxel); a molar at 0.05 mm has 17 M
  double min_voxel_mm = 0.005;                           // finer than any scanner of teeth
  double max_voxel_mm = 5.0;                             // slice distance of a coarse CT
  std::uintmax_t max_mesh_bytes = std::uintmax_t{512} << 20;  // a jaw of ten million triangles as binary STL
};

/// Empty voxels that generators and importers leave around a specimen: the band reaches 2.75 voxels out.
inline constexpr int kPadVoxels = 4;

}  // namespace cusp::scenarios
