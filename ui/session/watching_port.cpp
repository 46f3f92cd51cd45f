#include "ui/session/watching_port.h"

#include "device/hid/pedalled_sample.h"
#include "engine/step/input.h"

namespace cusp::ui {

Sample WatchingPort::wait(std::chrono::steady_clock::time_point deadline) noexcept {
  Sample sample = port_.wait(deadline);
  const auto now = std::chrono::steady_clock::now();
  sample = pedalled(sample, pedal_.get(), now);
  const LoopPhase phase = loop_->hand_over().phase.load(std::memory_order_acquire);
  // As the guard has it, the first sample cannot be late.
  const bool stood = before_ && now - *before_ > kSilent;
  if (stood) loop_->pause();
  if (phase == LoopPhase::running) stalled_.store(stood, std::memory_order_release);
  before_ = now;
  const bool idle = idle_.load(std::memory_order_acquire);
  const bool stands = idle || phase == LoopPhase::paused || phase == LoopPhase::held;
  if (held_) {
    held_->take(sample, stands ? HeldCut::Attempt::stands : HeldCut::Attempt::runs);
    ignores_cut_.store(!idle && held_->ignores(), std::memory_order_release);
  }
  if (!idle && was_idle_) sample.buttons |= StepInput::kRearm;
  was_idle_ = idle;
  return sample;
}

void WatchingPort::write(const Feedback& feedback) noexcept {
  // Until the sample that re-arms, the step's force has not ramped in.
  if (!was_idle_ && !idle_.load(std::memory_order_acquire)) return port_.write(feedback);
  Feedback quiet = feedback;
  quiet.force_n = Vec3(0.0);
  port_.write(quiet);
}

}  // namespace cusp::ui
