/// The surface reading of a banded volume, for drawing and measuring. Each cell that the surface s = 1/2 crosses has
/// one point and one normal. Cell (i,j,k) lies between voxel centres (i,j,k) and (i+1,j+1,k+1).
#pragma once

#include "engine/volume/volume.h"

namespace cusp::engine {

struct SurfacePoint {
  Vec3 point_mm{0.0};   // on the surface; may lie a little outside its cell
  Vec3 normal{0.0};     // unit, out of the tissue
  Tissue tissue = Tissue::empty;  // of the most solid corner
  bool cut = false;     // left by a bur, not the specimen's own surface
};

/// The point where the surface of min(B, C) crosses the cell. False if the corners' occupancies are alike.
/// For a filled reading: the mean of the edge crossings and the normal of the neighbourhood. Thread: the volume's
/// owner.
bool surface_point(const Volume& volume, IVec3 cell, SurfacePoint& out) noexcept;

/// Signed distance (mm, negative in tissue) and unit normal of the base field alone, by CellField. Exact for |d| < 2
/// voxels, which is the band.
double base_distance_mm(const Specimen& specimen, Vec3 at_mm, Vec3* normal) noexcept;

}  // namespace cusp::engine
