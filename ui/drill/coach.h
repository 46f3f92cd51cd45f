/// The next coach message as a code, chosen from the live values; DrillStage::coach_text() has its text.
/// Pure; any thread.
#pragma once

#include <cstdint>

#include "scenarios/format/scenario.h"
#include "scenarios/shapes/target.h"
#include "ui/modules.h"
#include "ui/session/observer.h"

namespace cusp::ui {

enum class Coach : std::uint8_t {
  begin,         // nothing was cut yet
  pulp_open,
  over_pulp,     // mm: so little dentine is left
  too_deep,      // mm: below the floor
  outside,       // the bur is outside the outline while cutting
  deeper,        // mm: so much is left to the floor
  nearly,        // mm: the floor is near
  sideways,      // the floor is reached here
  finish,        // hardly anything is left
  carry_on,      // lifted
  held_cut,      // a cut is held that counts for nothing: in an assessment and without a target, too
  quiet,         // no target, or the attempt stands: no message
};

/// Icon and colour of the message: on the way, worth a look, or wrong.
enum class CoachTone : std::uint8_t { good, look, bad };

struct CoachLine {
  Coach what = Coach::carry_on;
  double mm = 0;
  friend bool operator==(const CoachLine&, const CoachLine&) = default;
};

/// Below the floor is worth a look within the leeway and wrong beyond it.
CoachTone tone_of(const CoachLine& line, const Leeway& leeway) noexcept;

/// Whether `line` is to be spoken after `spoken` was: something else, or the same but by kWorthSayingMm apart.
bool worth_saying(const CoachLine& spoken, const CoachLine& line) noexcept;

/// mm: twice the last digit that the message shows; at every tenth a screen reader would never pause.
inline constexpr double kWorthSayingMm = 0.2;

/// Whether the attempt stands: paused, held, or without its device. The loop's last values are then stale: the force is
/// off and the handpiece stands.
bool stands_still(const LiveView& live) noexcept;

/// Only about the present: a place that the bur has left gets no message. `bur_radius_mm`: of the bur in use.
CoachLine coach(const LiveView& live, const TargetShape& shape, const Leeway& leeway, double bur_radius_mm);

}  // namespace cusp::ui
