/// An image made into a specimen: which numbers are which tissue, on cubic voxels.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/import/image.h"
#include "scenarios/import/remarks.h"
#include "scenarios/import/up_axis.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

struct ImageTissues {
  /// Labels and colours: the tissue of a number. What is not named is left out.
  std::vector<std::pair<std::uint32_t, Tissue>> labels;
  /// Instead, for grey values: the tissue from this value on, up to the next one's. Tissue::empty leaves a range out, so
  /// that metal above enamel can go. Below the first there is nothing.
  std::vector<std::pair<double, Tissue>> thresholds;
  std::optional<Tissue> hollows;   // what nothing from outside reaches becomes this: the pulp of a scanned tooth
  bool largest_component = false;      // keeps the largest connected component: drops noise, table, neighbours

  double unit_mm = 1.0;            // length of one of the file's own, > 0
  std::optional<double> voxel_mm;  // none: the least of the spacings
  UpAxis up = UpAxis::z;
};

/// The tissue of a value by thresholds, which are in rising order.
Tissue tissue_at(double value, const std::vector<std::pair<double, Tissue>>& thresholds) noexcept;

/// Labels: the nearest voxel of the file; the surface is known to half a voxel of the file. Grey values: trilinear, and
/// the surface is where they cross a threshold, with exact distances to it. Resampled to cubes, with a remark.
/// Seconds; limits are held before memory is taken. Codes: bad_option, bad_tissue, too_large, nothing_solid; mesh_not_found, of a label
/// that no voxel has.
[[nodiscard]] Result<VoxelVolume, ImportFailure> volume_of_image(const Image& image, const ImageTissues& what,
                                                                 const std::string& name, const VolumeLimits& limits,
                                                                 std::vector<ImportRemark>& remarks,
                                                                 const ImportProgress& progress = {});

}  // namespace cusp::scenarios
