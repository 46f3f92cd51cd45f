/// The last stage of the step: what keeps the hand safe. Force may fall at any rate; it rises no faster than the slew,
/// never beyond the limit, from zero after a start; it fades where it throws the device, and gives back no more energy
/// than a spring would; a fault takes it away until it is re-armed. Thread: haptic.
///
/// Frozen inputs. Equal positions prove nothing: a hand that rests on the device reads the same encoder count for
/// seconds. What tells is whether the device has answered: a port marks a sample that is not new as `late` (it counts
/// packets, or has none by the deadline), and when for longer than stale_ms nothing new has come, that is a fault. A
/// device that goes on answering with encoders that hang gives a force that no longer changes, within the limit; only
/// the port can know that.
#pragma once

#include "engine/scene/scene.h"
#include "engine/step/passivity.h"
#include "engine/step/step.h"

namespace cusp::engine {

struct GuardState {
  Fault fault = Fault::none;
  double ramp_ms = 0.0;     // since start, bur change or re-arm
  Vec3 given_n{0.0};        // in the tick before
  std::uint16_t acted = 0;  // GuardPart bits of the tick before
  double stale_ms = 0.0;    // since the device last said something new
  Vec3 velocity_mm_s{0.0};  // of the device, low-passed
  PassivityState passivity;
};

/// A fault of this input, or none. `jump_mm`: how far the device point moved since the input before; `stale_ms`: with
/// this input, how long the device has said nothing new.
Fault judge(const GuardSettings& settings, const StepInput& input, double jump_mm, double stale_ms,
            bool first) noexcept;

/// Force for the hand (N); `acts` gets the GuardParts that changed it, and those that did in the tick before, for its
/// way back is their doing too. What rises is what the force gains along itself or aside, whatever it lets go at once.
/// A raw force that is not finite latches Fault::not_finite. `moved_mm`: of the device point since the input before.
Vec3 guarded(const GuardSettings& settings, GuardState& state, const GuardTick& tick, Vec3 moved_mm,
             std::uint16_t& acts) noexcept;

/// The force is taken away: ramp, slew, velocity and passivity begin anew.
void release(GuardState& state) noexcept;

}  // namespace cusp::engine
