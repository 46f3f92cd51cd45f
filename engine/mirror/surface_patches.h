/// The picture's mesh, one patch per brick, from the surface points that are felt: one vertex per crossing cell, one
/// quad round each crossing voxel edge. Patches of one level close without gaps: a vertex on a border is computed
/// alike by both patches. Thread: whichever owns the volume (the mirror's).
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

/// How dense a patch is: cells of one voxel, or of two for what lies outside the region of interest.
inline constexpr int kFinePatch = 1;
inline constexpr int kCoarsePatch = 2;

struct Patch {
  int brick = -1;
  int level = kFinePatch;
  std::vector<PatchVertex> vertices;
  /// Triangles, three each, counter-clockwise seen from outside. The first `own` of them tile the surface with the
  /// other patches of the same level; the rest (coarse patches only) reach one cell under the neighbours on every side
  /// and close the seam where those are fine.
  std::vector<std::uint16_t> indices;
  std::size_t own = 0;
};

/// The patch of one brick as the volume stands; empty when no surface passes. level: kFinePatch or kCoarsePatch.
/// Deterministic: equal fields give equal patches.
Patch build_patch(const Volume& volume, int brick, int level);

/// Bricks whose patches may change when values of `brick` change: itself and those beside it (a surface point reads
/// a few voxels about its cell), in index order.
std::vector<int> patches_touched_by(const Specimen& specimen, int brick);

/// False when no patch of this brick can have a triangle: it and its upper and lower neighbours are uniform and alike,
/// and none is cut. Quick; for the first build.
bool may_have_surface(const Volume& volume, int brick) noexcept;

}  // namespace cusp::engine
