/// How the device point moves: slides at a constant speed along a shape's legs, presses from just above a spot.
#pragma once

#include <functional>

#include "engine/lab/closed_loop.h"
#include "engine/step/step.h"
#include "tests/bench/shapes.h"
#include "tests/modules.h"

namespace cusp::bench {

inline constexpr std::uint32_t kTickUs = 1000;
inline constexpr int kPresses = 2000;

enum class Button : std::uint8_t { up, down };

/// The device point quantised as a device's sample is; Button::down cuts.
StepInput input_at(Vec3 device_mm, Button button = Button::up);

StepInput input_of(const lab::Reading& reading);

/// Endless; the same seed gives the same points.
class Slide {
 public:
  Slide(const Shape& shape, double speed_mm_s, std::uint64_t seed);
  /// The first device point, then one a tick.
  Vec3 next();

 private:
  const Shape& shape_;
  double per_tick_mm_;
  Random random_;
  Leg leg_;
  double done_mm_ = 0.0;
  bool first_ = true;
};

/// Steps that are counted or broken on purpose go through here too.
using Stepper = std::function<StepOutput(StepState&, const StepInput&)>;

/// Leads the bur straight from wherever it is and lets it arrive. Used between measurements.
void lead(StepState& state, const Stepper& stepper, Vec3 to_mm, double per_tick_mm);

/// Puts a fresh or used state at an admissible centre, by way of home.
void bring(StepState& state, const Stepper& stepper, const Shape& shape, Vec3 centre);

}  // namespace cusp::bench
