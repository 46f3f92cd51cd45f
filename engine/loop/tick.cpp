#include "engine/loop/tick.h"

#include <algorithm>
#include <utility>

namespace cusp::engine {

namespace {

double softest_of(const Scene& scene) {
  const Specimen& specimen = *scene.specimen;
  std::array<bool, kTissueCodes> there{};
  const IVec3 n = specimen.brick_count();
  for (int b = 0; b < n.x * n.y * n.z; ++b) {
    const int last = specimen.uniform(b) ? 1 : kBrickVoxels;
    for (int o = 0; o < last; ++o) there[index_of(specimen.tissue_in(b, o))] = true;
  }
  double softest = 0;
  for (std::size_t t = 1; t < kTissueCodes; ++t) {
    const double k = scene.tissues[t].stiffness_n_per_mm;
    if (there[t] && (softest == 0 || k < softest)) softest = k;
  }
  return softest > 0 ? softest : 1.0;
}

}  // namespace

Ticker::Ticker(StepState state, HandOver& hand_over)
    : state_(std::move(state)), hand_over_(hand_over), output_(state_.last()), softest_n_per_mm_(softest_of(state_.scene())) {
  bur_ = output_.bur;
  hand_over_.ticks.store(output_.tick, std::memory_order_release);
}

Feedback Ticker::zero_force() const noexcept {
  Feedback feedback;
  feedback.proxy_mm = output_.proxy_mm;
  feedback.stiffness_n_per_mm = output_.stiffness_n_per_mm > 0 ? output_.stiffness_n_per_mm : softest_n_per_mm_;
  feedback.normal = normal_;
  feedback.faulted = output_.faulted;
  feedback.bur = bur_;
  return feedback;
}

void Ticker::publish(Sample::Status device) noexcept {
  LoopLatest latest;
  latest.output = output_;
  latest.contact_normal = normal_;
  latest.orientation = orientation_;
  latest.phase = phase_;
  latest.end = end_;
  latest.fault = state_.fault();
  latest.device = device;
  latest.wanted_bur = bur_;
  latest.ring_warning = hand_over_.inputs.size() >= hand_over_.inputs.capacity() / 4 * 3;
  hand_over_.latest.write(latest);
  hand_over_.ticks.store(output_.tick, std::memory_order_release);
  hand_over_.end.store(end_, std::memory_order_release);
  hand_over_.phase.store(phase_, std::memory_order_release);
}

void Ticker::end(LoopEnd why) noexcept {
  if (phase_ == LoopPhase::ended) return;
  phase_ = LoopPhase::ended;
  end_ = why;
  publish(Sample::Status::fresh);
}

std::uint16_t Ticker::fragment_name_half() noexcept {
  if (second_half_ != 0) return std::exchange(second_half_, std::uint16_t{0});
  std::uint32_t name = 0;
  if (!hand_over_.fragments.pop(name)) return 0;
  second_half_ = static_cast<std::uint16_t>(name & 0x7fffu);
  return static_cast<std::uint16_t>(0x8000u | name >> 15);
}

void Ticker::take_requests(std::uint16_t port_bur) noexcept {
  if (phase_ == LoopPhase::ready) phase_ = LoopPhase::running;
  switch (want_.exchange(Want::nothing, std::memory_order_acq_rel)) {
    case Want::pause:
      if (phase_ == LoopPhase::running) phase_ = LoopPhase::paused;
      break;
    case Want::resume:
      if (phase_ != LoopPhase::running) {
        phase_ = LoopPhase::running;
        rearm_ = true;
      }
      break;
    case Want::nothing: break;
  }
  const auto burs = state_.scene().burs.size();
  if (port_bur != port_bur_) {
    port_bur_ = port_bur;
    if (port_bur < burs) bur_ = port_bur;
  }
  if (const auto wanted = want_bur_.exchange(kNoBur, std::memory_order_acq_rel); wanted < burs) {
    bur_ = static_cast<std::uint16_t>(wanted);
  }
}

StepInput Ticker::input_of(const Sample& sample, std::uint32_t elapsed_us) noexcept {
  StepInput input = quantise(sample, elapsed_us, last_input_);
  // A bur is not changed against tissue: the record names the one that cuts.
  input.bur = output_.contact ? output_.bur : bur_;
  input.fragment = fragment_name_half();
  if (rearm_ || (sample.buttons & StepInput::kRearm) != 0) input.buttons |= StepInput::kRearm;
  if (coolant_.load(std::memory_order_acquire)) input.buttons |= StepInput::kCoolant;
  rearm_ = false;
  return input;
}

void Ticker::add_digest() noexcept {
  digest_.add(state_, output_);
  // A full ring drops the mark. The digest contains all ticks before it, so the next comparison covers the dropped one.
  if (output_.tick % kMarkTicks == 0) static_cast<void>(hand_over_.marks.push({output_.tick, digest_.value()}));
}

Feedback Ticker::tick(const Sample& sample, std::uint32_t elapsed_us) noexcept {
  if (phase_ == LoopPhase::ended) return zero_force();
  take_requests(sample.bur);
  if (phase_ != LoopPhase::running) {
    publish(sample.status);
    return zero_force();
  }

  const StepInput input = input_of(sample, elapsed_us);
  // Stored before the step, so that the record contains every input that changed the state.
  if (!hand_over_.inputs.push(input)) {
    end(LoopEnd::ring_full);
    return zero_force();
  }
  output_ = step(state_, input);
  last_input_ = input;
  orientation_ = sample.orientation;
  add_digest();
  if (output_.contact) {
    const double length = glm::length(output_.force_raw_n);
    if (length > 1e-9) normal_ = output_.force_raw_n / length;
  }
  if (output_.faulted) {
    if (rearm_by_itself_) {
      rearm_ = true;
    } else {
      phase_ = LoopPhase::held;
    }
  }
  publish(sample.status);

  Feedback feedback = zero_force();
  feedback.force_n = output_.force_n;
  feedback.in_contact = output_.contact;
  return feedback;
}

}  // namespace cusp::engine
