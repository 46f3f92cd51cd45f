/// Pictures of a grown tooth: orthographic views in grazing light from the upper left, which shows
/// flat slopes and ribs that a frontal light hides, and sections in the tissues' colours.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/volume/voxel_volume.h"
#include "tests/modules.h"
#include "tests/scenarios/teeth/jaw.h"

namespace cusp::test {

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // [y][x][3]
  Picture(int w, int h);
  /// Copies `from` with its middle at (x, y); what falls outside is cut off.
  void put(const Picture& from, int x, int y);
  /// False when the file cannot be written.
  bool save_png(const std::string& path) const;
};

/// Looks along `into`, `up` is up in the picture (both unit axes). Scale: pixels per mm.
Picture view(const VoxelVolume& volume, Vec3 into, Vec3 up, double px_per_mm);

/// A jaw from above: its voxels and, about them, its scenery.
Picture view_of_jaw(const Jaw& jaw, double px_per_mm);

/// The tissues in a section that follows the pulp: at each height the cut runs through the middle of the pulp found on
/// either side, within `keep` (a half of the tooth, or all of it). `into` is x or y.
Picture pulp_section(const VoxelVolume& volume, Vec3 into, Vec3 up, double px_per_mm,
                     const std::function<bool(Vec3)>& keep);

}  // namespace cusp::test
