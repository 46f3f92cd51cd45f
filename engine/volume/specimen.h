/// The scenario's volume as the engine holds it: bricks of 8x8x8, immutable after loading, shared by the loop, its
/// mirror and the graders. Outside the box lies endless empty space. A brick that is all empty, or all of one sound
/// tissue, costs four bytes; one that the surface crosses costs a kilobyte, and half as much again where tissues mix.
/// So memory grows with the surface, not with the box. Any thread (read only).
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

/// Says what a brick of the grid holds: a tissue for one that is wholly solid of it, Tissue::empty for one that is
/// wholly empty, nothing for one whose 512 voxels it has written. Voxels outside the grid need not be written; what is
/// said of them is not read. Asked once for each brick, in the order of their indices.
using BrickSource = std::function<std::optional<Tissue>(IVec3 brick, BrickVoxels& voxels)>;

class Specimen {
 public:
  /// Takes bricks as they come, without a dense form of all: a block of 1024^3 voxels is built in the room that it
  /// keeps. s >= 1/2 becomes 1 and the rest 0 for a filled reading, so both readings begin with the same occupied
  /// voxels. Not for the haptic thread.
  static std::shared_ptr<const Specimen> build(const Grid& grid, Reading reading, const BrickSource& source,
                                               std::map<std::uint8_t, std::string> names = {});
  /// Of a dense volume. Where tissue reaches its edge a banded reading has no room for the surface there: then the grid
  /// grows by kRoomVoxels on every side, and the edge of the volume is a face.
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
  /// True when all 512 voxels are alike: wholly empty or wholly solid and of one tissue.
  bool uniform(int brick) const noexcept { return place_[static_cast<std::size_t>(brick)] < 0; }
  /// The tissue of every voxel with s > 0, where it is one; empty where several are mixed or nothing is there.
  Tissue only_tissue(int brick) const noexcept {
    const std::int32_t p = place_[static_cast<std::size_t>(brick)];
    return p < 0 ? uniform_tissue(p) : tissues_[static_cast<std::size_t>(p)].only;
  }
  /// The 512 s values of a brick that is not uniform; nullptr for one that is.
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
  // A uniform brick's place says what it is of: -1 empty, -2 wholly solid of tissue 1, and so on.
  static constexpr std::int32_t place_of(Tissue uniform) noexcept { return -1 - static_cast<std::int32_t>(uniform); }
  static constexpr Tissue uniform_tissue(std::int32_t place) noexcept { return static_cast<Tissue>(-1 - place); }
  static constexpr std::uint16_t uniform_s(std::int32_t place) noexcept {
    return place == -1 ? std::uint16_t{0} : kSolid;
  }

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
