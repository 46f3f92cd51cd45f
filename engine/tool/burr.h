/// A burr: a cutting ball on a neck and a shank that collide and never cut. Pivot: the ball's centre. Lengths in mm.
#pragma once

#include <string>

namespace cusp {

struct Burr {
  std::string name;              // catalogue number, "2" or "1/4"; a person sees it with the diameter
  double radius_mm = 0.5;        // of the cutting ball
  double neck_radius_mm = 0.3;   // from the ball's centre up to neck_length_mm
  double neck_length_mm = 4.0;
  double shank_radius_mm = 0.8;  // FG shank, from the neck's end
  double shank_length_mm = 12.0;
  friend bool operator==(const Burr&, const Burr&) = default;
};

}  // namespace cusp
