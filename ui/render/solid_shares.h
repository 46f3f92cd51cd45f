/// How solid the surroundings are, coarse and quick to ask: means over cells of 4 and 8 voxels. Light that reaches a
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

  enum class Cell : std::uint8_t { four, eight };  // voxels on a side
  /// Mean solid fraction about a place, 0 to 1, interpolated between cells. `voxel`: in voxels, whole at their centres.
  float at(Cell cell, Vec3f voxel) const noexcept;
  /// The same over a wider neighbourhood, blended without edges.
  float smooth_at(Cell cell, Vec3f voxel) const noexcept;

 private:
  /// Means of one size of cell, with two empty cells beyond the grid on every side.
  struct Level {
    static constexpr int kEdge = 2;
    IVec3 size{0};
    std::vector<std::uint8_t> cell;  // [x][y][z], x fastest
    std::size_t index(IVec3 c) const noexcept { return static_cast<std::size_t>(c.x + size.x * (c.y + size.y * c.z)); }
    void resize(IVec3 cells);
    void set(IVec3 c, std::uint32_t value) noexcept { cell[index(c + kEdge)] = static_cast<std::uint8_t>(value); }
  };
  const Level& level(Cell cell) const noexcept { return levels_[static_cast<std::size_t>(cell)]; }

  std::array<Level, 2> levels_;  // by Cell
};

/// Light from around that reaches a surface place, 0 to 1: five cones through the shares. `voxel` as above.
float ambient_at(const SolidShares& shares, Vec3f voxel, Vec3f normal, float voxel_mm) noexcept;

}  // namespace cusp::ui
