/// A bur: a cutting head on a neck and a shank that collide and never cut. Pivot: on the axis, one radius above the tip
/// (a round bur's: the ball's centre). Lengths in mm, along the axis from the pivot towards the shank.
#pragma once

#include <string>

#include "engine/tool/profile.h"

namespace cusp::engine {

struct Bur {
  std::string name;              // catalogue number, "2" or "1/4"; the screen shows it with the diameter
  double radius_mm = 0.5;        // of the cutting head where it is widest
  double neck_radius_mm = 0.3;   // from the pivot up to neck_length_mm; inside the head it has no effect
  double neck_length_mm = 4.0;
  double shank_radius_mm = 0.8;  // FG shank, from the neck's end
  double shank_length_mm = 12.0;
  Profile head{};                // none: a ball of radius_mm about the pivot
  friend bool operator==(const Bur&, const Bur&) = default;
};

}  // namespace cusp::engine
