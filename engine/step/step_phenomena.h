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

/// Before the method. Takes what pressed on the bur in the tick before, moves the spindle, and says whether the bur
/// cuts and at which share of the tissues' speeds.
void turn(PhenomenaState& state, const Scene& scene, const StepInput& input, const StepOutput& before, double dt_s,
          Tick& tick) noexcept;

/// After the guard: heat, and what the hand feels of the turning. Drag and vibration are at most kDragShare and
/// kMostVibrationShare of the guarded force, so they are nothing where the guard gives nothing, never pull, and stay
/// outside of the passivity controller's account; the sum stays within the guard's limit.
void work(PhenomenaState& state, const Scene& scene, const StepInput& input, Vec3 axis, double dt_s,
          StepOutput& out) noexcept;

/// Of a tick without force (a fault): runs down, cools down.
void rest(PhenomenaState& state, double dt_s, StepOutput& out) noexcept;

}  // namespace cusp::engine
