#include "ui/drill/idle_port.h"

#include <chrono>

#include "device/hid/pedalled_sample.h"
#include "engine/step/input.h"

namespace cusp::ui {

Sample IdlePort::wait(std::chrono::steady_clock::time_point deadline) noexcept {
  Sample sample = port_->wait(deadline);
  sample = pedalled(sample, pedal_.get(), std::chrono::steady_clock::now());
  const bool idle = idle_.load(std::memory_order_acquire);
  held_.take(sample, idle ? HeldCut::Attempt::stands : HeldCut::Attempt::runs);
  ignores_cut_.store(!idle && held_.ignores(), std::memory_order_release);
  if (!idle && was_idle_) sample.buttons |= StepInput::kRearm;
  was_idle_ = idle;
  return sample;
}

void IdlePort::write(const Feedback& feedback) noexcept {
  // Until the sample that re-arms, the step's force has not ramped in.
  if (!was_idle_ && !idle_.load(std::memory_order_acquire)) return port_->write(feedback);
  Feedback quiet = feedback;
  quiet.force_n = Vec3(0.0);
  port_->write(quiet);
}

}  // namespace cusp::ui
