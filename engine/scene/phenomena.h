/// Phenomena beyond contact, friction and wear. A scene without them reserves and computes nothing for them.
#pragma once

#include <cstdint>

namespace cusp::engine {

enum class Handpiece : std::uint8_t {
  none,      // the scene has no spindle: a pressed cut removes at the tissue's own speed
  turbine,   // air: fast; slows under load and stalls
  electric,  // constant speed up to its largest torque
  slow,      // contra-angle; the pedal sets the speed from least_rpm up
};

struct Phenomena {
  Handpiece handpiece = Handpiece::none;
  bool vibration = false;  // has an effect with a handpiece
  bool heat = false;       // without a handpiece: at kUnknownRpm while the cut button is pressed

  constexpr bool any() const noexcept { return handpiece != Handpiece::none || vibration || heat; }
  friend bool operator==(const Phenomena&, const Phenomena&) = default;
};

}  // namespace cusp::engine
