/// Motions of the device point: slides at constant speed along the legs of a shape, and transfers between measurements.
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

/// An endless slide; the same seed gives the same points.
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

/// step(), or a test's replacement for it.
using Stepper = std::function<StepOutput(StepState&, const StepInput&)>;

/// Moves the device point straight to to_mm and waits until a deferring method arrives.
void lead(StepState& state, const Stepper& stepper, Vec3 to_mm, double per_tick_mm);

/// Moves a fresh or used state to an admissible centre by way of home().
void bring(StepState& state, const Stepper& stepper, const Shape& shape, Vec3 centre);

}  // namespace cusp::bench
