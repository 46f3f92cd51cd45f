/// The picture's mesh, one patch per brick. A crossed cell gives a vertex at its surface point, a crossed voxel edge a
/// quad. Patches of one level close without gaps, because both patches compute a border's vertex alike. Thread: the
/// volume's owner (the mirror's).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/volume/surface_cells.h"

namespace cusp::engine {

struct PatchVertex {
  Vec3f position_mm{0.0f};  // specimen frame; on the surface
  Vec3f normal{0.0f};       // unit, out of the tissue
  Tissue tissue = Tissue::empty;
  bool cut = false;         // left by a bur
};

/// Levels: cells of one voxel, or of two voxels outside the region of interest.
inline constexpr int kFinePatch = 1;
inline constexpr int kCoarsePatch = 2;

struct Patch {
  int brick = -1;
  int level = kFinePatch;
  std::vector<PatchVertex> vertices;
  /// Triangles, three indices each, counter-clockwise seen from outside. The first `own` indices tile the surface with
  /// the other patches of the same level. The rest (coarse patches only) reach one cell under the neighbours and close
  /// the seam to fine ones.
  std::vector<std::uint16_t> indices;
  std::size_t own = 0;
};

/// The patch of one brick; empty if no surface crosses it. level: kFinePatch or kCoarsePatch. Equal fields give equal
/// patches.
Patch build_patch(const Volume& volume, int brick, int level);

/// Bricks whose patches may change if values of `brick` change, by rising index: itself and its neighbours. A surface
/// point reads a few voxels about its cell.
std::vector<int> patches_touched_by(const Specimen& specimen, int brick);

/// False if no patch of this brick can have a triangle: the brick and its neighbours are uniform and alike, and none is
/// cut.
bool may_have_surface(const Volume& volume, int brick) noexcept;

}  // namespace cusp::engine
