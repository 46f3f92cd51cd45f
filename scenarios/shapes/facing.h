/// The named face of a region that a piece of cut surface was to be. Millimetres, specimen frame.
#pragma once

#include "scenarios/format/region.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// A face of a leaf, as a place is seen from it.
struct LeafFace {
  FaceName face = FaceName::side_wall;
  double out_mm = 0;         // how far the place lies out of the face's own surface; negative: inside
  Vec3 out{0.0, 0.0, 1.0};   // out of the leaf there, of length 1
};

/// A face faces a piece of cut surface if their normals lean less than 45 degrees (dental.md 2.2: more is a wall of a floor,
/// or a floor of a wall). Of those the nearest counts, its distance taken to the patch that the leaf's other faces bound: a
/// floor that was cut a millimetre short still belongs to its floor, whichever wall stands nearer.
struct Facing {
  FaceName face = FaceName::side_wall;
  double beyond_mm = 0;  // out of the face; negative: short of it
  double beside_mm = 0;  // beside its patch; 0 where the place lies over it
  double wall_mm = 0;    // out of the nearest wall of the same leaf
  double floor_mm = 0;   // out of its nearest floor
  FaceName floor = FaceName::pulpal_floor;  // that floor's name
  Vec3 into_void{0.0, 0.0, 1.0};            // the face's own normal there, of length 1
};

/// Cosine of 45 degrees.
inline constexpr double kFacingCosine = 0.70710678;

}  // namespace cusp::scenarios
