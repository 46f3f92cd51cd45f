/// What a scene may ask for beyond contact, friction and wear; with none asked, nothing of it is reserved or computed.
#pragma once

#include <cstdint>

namespace cusp::engine {

enum class Handpiece : std::uint8_t {
  none,      // the scene has no spindle: a pressed cut removes at the tissue's own speed
  turbine,   // air: fast, soft; sags under load and stalls
  electric,  // holds its speed until its torque is spent
  slow,      // contra-angle; the pedal sets it from least_rpm up
};

struct Phenomena {
  Handpiece handpiece = Handpiece::none;
  bool vibration = false;  // felt where there is a handpiece
  bool heat = false;       // without a handpiece: as if it turned at kUnknownRpm while the cut is pressed

  constexpr bool any() const noexcept { return handpiece != Handpiece::none || vibration || heat; }
  friend bool operator==(const Phenomena&, const Phenomena&) = default;
};

}  // namespace cusp::engine
