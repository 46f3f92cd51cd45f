/// A place beside a region: its signed distance and the nearest named face. Millimetres.
#pragma once

#include "scenarios/format/region.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// The nearest face is the one whose own surface the place lies furthest out of; at a rounded edge the bisector divides.
struct Near {
  double distance_mm = 0;  // from the region; negative inside. The sign is exact; 1 mm of way changes it by at most 1 mm
  double wall_mm = 0;      // out of the nearest face that is a wall
  double floor_mm = 0;     // out of the nearest face that is a floor; it is the nearest of all where this is >= wall_mm
  FaceName face = FaceName::side_wall;
  FaceName wall = FaceName::side_wall;      // the nearest face that is a wall
  FaceName floor = FaceName::pulpal_floor;  // the nearest that is a floor
};

}  // namespace cusp::scenarios
