/// What a scene may ask for beyond contact, friction and wear; with none asked, nothing of it is reserved or computed.
#pragma once

#include "engine/removal/heat.h"
#include "engine/removal/spindle.h"
#include "engine/removal/vibration.h"

namespace cusp {

struct Phenomena {
  Handpiece handpiece = Handpiece::none;
  bool vibration = false;  // felt where there is a handpiece
  bool heat = false;       // without a handpiece: as if it turned at kUnknownRpm while the cut is pressed

  constexpr bool any() const noexcept { return handpiece != Handpiece::none || vibration || heat; }
  friend bool operator==(const Phenomena&, const Phenomena&) = default;
};

}  // namespace cusp
