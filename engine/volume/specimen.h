/// The scenario's volume: bricks of 8x8x8, immutable after load, shared by the loop, its mirror and the graders. All
/// space outside the grid is empty. Memory grows with the surface, not with the grid. A brick that is all empty, or all
/// of one sound tissue, takes four bytes. A brick that the surface crosses takes a kilobyte, with mixed tissues one and
/// a half. Any thread (read only).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "engine/volume/base_surface.h"
#include "engine/volume/voxel_volume.h"

namespace cusp::engine {

/// How s is read (design, "The volume").
enum class Reading : std::uint8_t {
  filled,  // the paper's: s is 0 or 1 at the start, a voxel is there while s > 0, wear lowers s
  banded,  // s is a clamped distance, a voxel is there while s >= 1/2, removal carves
};

inline constexpr int kBrickEdge = 8;
inline constexpr int kBrickVoxels = 512;

/// Position of a voxel within its brick: x fastest. Pre: 0 <= local < 8.
inline int brick_offset(int x, int y, int z) noexcept { return x | y << 3 | z << 6; }

/// The voxels of one brick, each at its brick_offset.
struct BrickVoxels {
  std::array<std::uint16_t, kBrickVoxels> s;
  std::array<Tissue, kBrickVoxels> tissue;
};

/// Content of a brick of the grid. A tissue: the brick is wholly solid of it (Tissue::empty: wholly empty). Nothing:
/// the source has written its 512 voxels. Voxels outside the grid are not read. Called once for each brick, by rising
/// index.
using BrickSource = std::function<std::optional<Tissue>(IVec3 brick, BrickVoxels& voxels)>;

class Specimen {
 public:
  /// Builds brick by brick, without a dense form: a block of 1024^3 voxels needs no more memory than it keeps. A filled
  /// reading has 1 for s >= 1/2 and else 0, so both readings begin with the same occupied voxels. Not for the haptic
  /// thread.
  static std::shared_ptr<const Specimen> build(const Grid& grid, Reading reading, const BrickSource& source,
                                               std::map<std::uint8_t, std::string> names = {});
  /// Of a dense volume. If tissue reaches the volume's edge, a banded reading needs voxels outside for the surface. The
  /// grid then grows by kRoomVoxels on every side, and the volume's edge is a face.
  static std::shared_ptr<const Specimen> build(const VoxelVolume& dense, Reading reading);
  static constexpr int kRoomVoxels = 4;

  const Grid& grid() const noexcept { return grid_; }
  Reading reading() const noexcept { return reading_; }
  IVec3 brick_count() const noexcept { return bricks_; }
  /// Index of a brick, x fastest; -1 outside.
  int brick_index(IVec3 brick) const noexcept {
    if (brick.x < 0 || brick.y < 0 || brick.z < 0 || brick.x >= bricks_.x || brick.y >= bricks_.y ||
        brick.z >= bricks_.z)
      return -1;
    return brick.x + bricks_.x * (brick.y + bricks_.y * brick.z);
  }
  IVec3 brick_at(int index) const noexcept {
    return {index % bricks_.x, index / bricks_.x % bricks_.y, index / (bricks_.x * bricks_.y)};
  }

  std::uint16_t s(IVec3 v) const noexcept {
    const int b = brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
    return b < 0 ? std::uint16_t{0} : s_in(b, brick_offset(v.x & 7, v.y & 7, v.z & 7));
  }
  Tissue tissue(IVec3 v) const noexcept {
    const int b = brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
    return b < 0 ? Tissue::empty : tissue_in(b, brick_offset(v.x & 7, v.y & 7, v.z & 7));
  }
  std::uint16_t s_in(int brick, int offset) const noexcept {
    const std::int32_t p = place_[static_cast<std::size_t>(brick)];
    return p < 0 ? uniform_s(p) : s_[static_cast<std::size_t>(p) * kBrickVoxels + static_cast<std::size_t>(offset)];
  }
  Tissue tissue_in(int brick, int offset) const noexcept {
    const std::int32_t p = place_[static_cast<std::size_t>(brick)];
    if (p < 0) return uniform_tissue(p);
    const Tissues& t = tissues_[static_cast<std::size_t>(p)];
    if (t.mixed < 0) return s_in(brick, offset) > 0 ? t.only : Tissue::empty;
    return tissue_[static_cast<std::size_t>(t.mixed) * kBrickVoxels + static_cast<std::size_t>(offset)];
  }
  /// True if all 512 voxels are alike: wholly empty, or wholly solid and of one tissue.
  bool uniform(int brick) const noexcept { return place_[static_cast<std::size_t>(brick)] < 0; }
  /// The tissue of every voxel with s > 0; empty if several are mixed or the brick is empty.
  Tissue only_tissue(int brick) const noexcept {
    const std::int32_t p = place_[static_cast<std::size_t>(brick)];
    return p < 0 ? uniform_tissue(p) : tissues_[static_cast<std::size_t>(p)].only;
  }
  /// The 512 s values of a brick; nullptr if it is uniform.
  const std::uint16_t* s_of(int brick) const noexcept {
    const std::int32_t p = place_[static_cast<std::size_t>(brick)];
    return p < 0 ? nullptr : &s_[static_cast<std::size_t>(p) * kBrickVoxels];
  }

  /// Surface points of a banded specimen; none for a filled one.
  const BaseSurface& surface() const noexcept { return surface_; }

  /// Bytes held, and a hash of grid, reading, tissues and s (the same on every machine).
  std::size_t bytes() const noexcept;
  std::uint64_t hash() const noexcept { return hash_; }
  const std::map<std::uint8_t, std::string>& names() const noexcept { return names_; }

  /// Back to the dense form (for files and metrics).
  VoxelVolume dense() const;

 private:
  /// Tissues of a brick that is not uniform.
  struct Tissues {
    std::int32_t mixed = -1;      // place in tissue_ where several are mixed
    Tissue only = Tissue::empty;  // else the one
  };
  // A uniform brick's place encodes its tissue: -1 empty, -2 wholly solid of tissue 1, and so on.
  static constexpr std::int32_t place_of(Tissue uniform) noexcept { return -1 - static_cast<std::int32_t>(uniform); }
  static constexpr Tissue uniform_tissue(std::int32_t place) noexcept { return static_cast<Tissue>(-1 - place); }
  static constexpr std::uint16_t uniform_s(std::int32_t place) noexcept {
    return place == -1 ? std::uint16_t{0} : kSolid;
  }
  /// Stores a brick that is not uniform. Returns its place.
  std::int32_t append(const BrickVoxels& voxels);

  Grid grid_;
  Reading reading_ = Reading::banded;
  IVec3 bricks_{0};
  std::vector<std::int32_t> place_;  // [brick]: place in s_ and tissues_, below 0 uniform
  std::vector<std::uint16_t> s_;     // [place][512]
  std::vector<Tissues> tissues_;     // [place]
  std::vector<Tissue> tissue_;       // [mixed][512]
  BaseSurface surface_;
  std::map<std::uint8_t, std::string> names_;
  std::uint64_t hash_ = 0;
};

}  // namespace cusp::engine
