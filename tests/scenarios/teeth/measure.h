/// Measures teeth on their voxels alone, by other ways than the generator's: crossings of s = 1/2, floods, columns.
#pragma once

#include <functional>
#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/teeth/landmarks.h"
#include "tests/modules.h"

namespace cusp::test {

/// Furthest crossing of the surface along an axis (0 x, 1 y, 2 z; sign ±1) over all grid lines whose z is in [low, high].
double extent(const VoxelVolume& volume, int axis, int sign, double z_low, double z_high);

/// Mirrored: quadrants 2 and 4.
enum class Quadrant : std::uint8_t { as_tabled, mirrored };
/// Lengths as teeth.json defines them; CEJ heights are those of the mesial and distal side.
ToothDims measured_dims(const VoxelVolume& volume, double cej_mesial, double cej_distal, Quadrant quadrant = Quadrant::as_tabled);

/// Connected components of the voxels that `wanted` accepts, joined over faces.
int components(const VoxelVolume& volume, const std::function<bool(std::size_t)>& wanted);

/// Peaks of the surface seen from above that stand at least `prominence_mm` over the way to a higher one.
int peaks(const VoxelVolume& volume, double prominence_mm);

/// Distance in mm from the surface at a place, by trilinear s; only within the band.
double distance_mm(const VoxelVolume& volume, Vec3 at_mm);

/// Tissue of the voxel at a place; empty when s < 1/2 there.
Tissue tissue_at(const VoxelVolume& volume, Vec3 at_mm);

/// Least distance from a pulp voxel above `z_from` to one that is neither pulp nor dentine; `most_mm` when none is nearer.
double pulp_cover_mm(const VoxelVolume& volume, double z_from, double most_mm);

/// mm of a tissue straight below a place on the surface.
double thickness_below(const VoxelVolume& volume, Vec3 top, Tissue tissue);

/// Heights inside a molar as Deutsch and Musikant 2004 measured them (mm): from the mesiobuccal cusp's tip, over the
/// middle of the chamber, down to the roots' parting.
struct PulpHeights {
  double cusp_to_ceiling = 0, chamber = 0, cusp_to_floor = 0;
  double floor_to_furcation = 0, ceiling_to_furcation = 0, cusp_to_furcation = 0;
};
PulpHeights pulp_heights(const VoxelVolume& volume, Vec3 cusp_tip);
/// Their means and standard deviations (dental.md 3.2): upper, or lower molars.
struct Quoted {
  double mean, deviation;
};
struct QuotedHeights {
  Quoted cusp_to_ceiling, chamber, cusp_to_floor, floor_to_furcation, ceiling_to_furcation, cusp_to_furcation;
};
inline constexpr QuotedHeights kUpperMolars{{6.24, 0.88}, {1.88, 0.69}, {8.08, 0.88}, {3.05, 0.79}, {4.91, 1.06}, {11.15, 1.21}};
inline constexpr QuotedHeights kLowerMolars{{6.36, 0.93}, {1.57, 0.68}, {7.95, 0.79}, {2.96, 0.78}, {4.55, 0.91}, {10.90, 1.21}};
/// How many standard deviations the furthest of the six is from its mean.
double furthest_from_quoted(const PulpHeights& heights, const QuotedHeights& quoted);

/// Components of the whole, and of each of enamel, dentine, cementum and pulp: all 1 in a sound tooth.
struct Components {
  int whole = 0, enamel = 0, dentine = 0, cementum = 0, pulp = 0;
  bool all_one() const noexcept { return whole == 1 && enamel == 1 && dentine == 1 && cementum == 1 && pulp == 1; }
};
Components components_of_tissues(const VoxelVolume& volume);

}  // namespace cusp::test
