/// A tick of a scene that asks for phenomena: spindle before the method, drag, vibration and heat after the guard.
#pragma once

#include "engine/removal/heat.h"
#include "engine/removal/spindle.h"
#include "engine/removal/vibration.h"
#include "engine/scene/scene.h"
#include "engine/step/input.h"
#include "engine/step/step.h"

namespace cusp::engine {

struct Tick;

struct PhenomenaState {
  explicit PhenomenaState(const Scene& scene) noexcept;

  SpindleSettings settings;    // of the scene's handpiece
  double stiffest_n_per_mm;    // of the scene's tissues: hardness 1 of the vibration
  // What the next tick depends on.
  SpindleState spindle;
  VibrationState vibration;
  HeatState heat;
};

/// Before the method. Advances the spindle under the push of the tick before; sets Tick::cut and Tick::removal_factor.
/// bur: the one in use, which a wanted one may not be yet.
void turn(PhenomenaState& state, const Scene& scene, const StepInput& input, std::uint16_t bur, const StepOutput& before, double dt_s,
          Tick& tick) noexcept;

/// After the guard: heat, drag and vibration. Drag and vibration are at most kDragShare and kMostVibrationShare of the
/// guarded force, so they are never a pull. The passivity controller does not count them. The sum stays within the
/// guard's limit.
void work(PhenomenaState& state, const Scene& scene, const StepInput& input, Vec3 axis, double dt_s,
          StepOutput& out) noexcept;

/// A tick without force (a fault): the spindle runs down, the tooth cools.
void rest(PhenomenaState& state, double dt_s, StepOutput& out) noexcept;

}  // namespace cusp::engine
