/// The last stage of the spring's force, before drag and vibration: bounds what the device gets. The force may fall at
/// any rate. It rises no faster than the slew, stays within the limit, and starts from zero. It fades where it throws the device. It returns
/// no more energy than a spring. A fault sets it to zero until re-armed. Thread: haptic. Wait-free.
///
/// Frozen inputs: equal positions prove nothing, because a resting hand repeats one encoder count for seconds. A port
/// marks a sample that is not new as `late`; if none is new for stale_ms, that is a fault. The port detects hanging
/// encoders of a device that still answers. The force then stays constant and within the limit.
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
  double stale_ms = 0.0;    // since the device's last new sample
  Vec3 velocity_mm_s{0.0};  // of the device, low-passed
  PassivityState passivity;
};

/// Whether an input came before. The first one can neither jump nor be late.
enum class InputPlace : std::uint8_t { first, later };

/// An input beside those before it.
struct InputHistory {
  double jump_mm = 0.0;   // way of the device point since the input before
  double stale_ms = 0.0;  // since the last new sample, this input included
  InputPlace place = InputPlace::later;
};

/// The fault of this input, or none.
Fault judge(const GuardSettings& settings, const StepInput& input, const InputHistory& history) noexcept;

/// The force for the device, N. moved_mm: of the device point since the input before.
/// acts: GuardParts that changed the force in this tick or the one before: the force's return is their effect, too.
/// The slew bounds the part of the force that is new, along the last force or across it; a fall counts as none.
/// If the raw force is not finite, Fault::not_finite latches.
Vec3 guarded(const GuardSettings& settings, GuardState& state, const GuardTick& tick, Vec3 moved_mm,
             std::uint16_t& acts) noexcept;

/// Sets the force to zero: ramp, slew, velocity and passivity start again.
void release(GuardState& state) noexcept;

}  // namespace cusp::engine
