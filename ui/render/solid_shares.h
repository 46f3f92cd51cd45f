/// How solid the surroundings are, coarse and quick to ask: means over cells of 2, 4 and 8 voxels. Light that reaches a
/// place is reckoned from them. Thread: the volume's owner.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/volume/volume.h"
#include "ui/modules.h"

namespace cusp::ui {

class SolidShares {
 public:
  SolidShares() = default;
  /// Of the volume as it stands.
  explicit SolidShares(const Volume& volume);
  /// Reads a brick anew.
  void update(const Volume& volume, int brick);

  enum class Cell : std::uint8_t { two, four, eight };  // voxels on a side
  /// Mean solid fraction about a place, 0 to 1, interpolated between cells. `voxel`: in voxels, whole at their centres.
  float at(Cell cell, Vec3f voxel) const noexcept;

  /// Mean of a wide neighbourhood: cells of 8 voxels, blended without edges.
  float mean_about(Vec3f voxel) const noexcept;

 private:
  float of_two(IVec3 cell) const noexcept;
  float of_four(IVec3 cell) const noexcept;
  float of_eight(IVec3 cell) const noexcept;
  int brick_index(IVec3 brick) const noexcept;

  IVec3 bricks_{0};
  std::vector<std::int32_t> place_;               // [brick]: place in two_; -1: all of it is as eight_ says
  std::vector<std::array<std::uint8_t, 64>> two_;  // [place][x + 4 y + 16 z]
  std::vector<std::array<std::uint8_t, 8>> four_;  // [brick][x + 2 y + 4 z]
  std::vector<std::uint8_t> eight_;                // [brick]
};

/// Light from around that reaches a surface place, 0 to 1: five cones through the shares. `voxel` as above.
float ambient_at(const SolidShares& shares, Vec3f voxel, Vec3f normal, float voxel_mm) noexcept;

}  // namespace cusp::ui
