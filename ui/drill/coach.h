/// What the sentence under the tooth says next, as a code: chosen from the live values, put into words by the screen.
/// Pure; any thread.
#pragma once

#include <cstdint>

#include "scenarios/shapes/outline.h"
#include "ui/session/observer.h"

namespace cusp {

enum class Coach : std::uint8_t {
  begin,         // nothing was cut yet
  pulp_open,
  over_pulp,     // mm: so little dentine is left
  too_deep,      // mm: below the floor
  outside,       // the burr is outside the outline while cutting
  deeper,        // mm: so much is left to the floor
  sideways,      // the floor is reached here
  finish,        // hardly anything is left
  carry_on,      // lifted, or no target
};

struct CoachLine {
  Coach what = Coach::carry_on;
  double mm = 0;
  friend bool operator==(const CoachLine&, const CoachLine&) = default;
};

/// `burr_radius_mm`: of the burr in use.
CoachLine coach(const LiveView& live, const TargetShape& shape, const Leeway& leeway, double burr_radius_mm);

}  // namespace cusp
