/// Outer corners: where three sharp edges of a specimen meet. No cell near one is explained by two faces, so the edges'
/// pieces end short of it, or run on into the air. Only + - * / sqrt. At load; any thread.
#pragma once

#include <vector>

#include "engine/volume/base_surface.h"

namespace cusp::engine {

/// A place of BaseSurface as it is made.
struct BasePlace {
  /// Of an edge `vector` is its bend; of a point beside it the other face's normal, other_d the distance to that face.
  struct Detail {
    double other_d = 0.0;
    Vec3 vector{0.0};
  };
  int brick = 0;
  std::uint16_t place = 0;  // BaseNormal::place
  Tissue tissue = Tissue::empty;
  int details = 0;
  Vec3 at{0.0};         // voxels from the brick's first voxel centre
  Vec3 direction{0.0};  // normal, or an edge's tangent
  Detail detail[2];
};

/// Ends the edges at each corner, and each of its three faces at both others. Elsewhere nothing changes. Pre and post:
/// points by brick, then by cell.
void add_outer_corners(const Specimen& specimen, std::vector<BasePlace>& points);

/// Tissue of a cell's most solid voxel; ties go to the lowest.
Tissue corner_tissue(const Specimen& specimen, IVec3 cell) noexcept;

}  // namespace cusp::engine
