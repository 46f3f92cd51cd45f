#include "tests/bench/motions.h"

#include "tests/bench/frame.h"

namespace cusp::bench {

namespace {
constexpr double kTransferMm = 1.0;    // a tick, between measurements
constexpr int kArriveTicks = 200;  // wait for a deferring method at most
}  // namespace

StepInput input_at(Vec3 device_mm, Button button) {
  Sample sample;
  sample.status = Sample::Status::fresh;
  sample.position_mm = device_mm;
  sample.buttons = button == Button::down ? StepInput::kCut : 0;
  return quantise(sample, kTickUs, StepInput{});
}

StepInput input_of(const lab::Reading& reading) {
  StepInput input;
  input.x = reading.x;
  input.y = reading.y;
  input.z = reading.z;
  input.elapsed_us = reading.elapsed_us;
  return input;
}

Slide::Slide(const Shape& shape, double speed_mm_s, std::uint64_t seed)
    : shape_(shape), per_tick_mm_(speed_mm_s * kTickUs * 1e-6), random_(seed), leg_(shape.leg(random_, nullptr)) {}

Vec3 Slide::next() {
  if (first_) {
    first_ = false;
    return leg_.at(0.0);
  }
  done_mm_ += per_tick_mm_;
  while (done_mm_ > leg_.length_mm) {
    done_mm_ -= leg_.length_mm;
    const Vec3 end = leg_.at(leg_.length_mm);
    leg_ = shape_.leg(random_, &end);
  }
  return leg_.at(done_mm_);
}

void lead(StepState& state, const Stepper& stepper, Vec3 to_mm, double per_tick_mm) {
  const Vec3 from = state.last().tick == 0 ? to_mm : state.last().device_mm;
  const int ticks = static_cast<int>(length(to_mm - from) / per_tick_mm) + 1;
  StepOutput out;
  for (int k = 1; k <= ticks; ++k)
    out = stepper(state, input_at(from + (to_mm - from) * (static_cast<double>(k) / ticks)));
  for (int k = 0; k < kArriveTicks && out.deferred; ++k) out = stepper(state, input_at(to_mm));
}

void bring(StepState& state, const Stepper& stepper, const Shape& shape, Vec3 centre) {
  lead(state, stepper, shape.home(), kTransferMm);
  lead(state, stepper, centre, kTransferMm);
}

}  // namespace cusp::bench
