#include "scenarios/operators/operator_port.h"

namespace cusp::scenarios {

OperatorPort::OperatorPort(ScriptedOperator scripted, double dt_s) : operator_(std::move(scripted)), dt_s_(dt_s) {
  felt_.device_mm = felt_.proxy_mm = operator_.start_mm();
}

Sample OperatorPort::wait(std::chrono::steady_clock::time_point) noexcept {
  if (operator_.done()) {
    Sample over;
    over.position_mm = felt_.device_mm;
    return over;
  }
  const Sample sample = operator_.next(felt_, dt_s_);
  felt_.device_mm = sample.position_mm;
  return sample;
}

void OperatorPort::write(const Feedback& feedback) noexcept {
  felt_.proxy_mm = feedback.proxy_mm;
  felt_.force_n = feedback.force_n;
  felt_.contact = feedback.in_contact;
  felt_.stiffness_n_per_mm = feedback.in_contact ? feedback.stiffness_n_per_mm : 0.0;
  felt_.faulted = feedback.faulted;
}

DeviceLimits OperatorPort::limits() const {
  DeviceLimits limits;
  limits.name = "Scripted hand";
  limits.device_class = "scripted";
  limits.max_stiffness_n_per_mm = 20.0;  // no device that could become unstable
  limits.closed_loop = false;
  limits.has_own_clock = true;
  return limits;
}

}  // namespace cusp::scenarios
