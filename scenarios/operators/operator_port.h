/// A scripted operator as a HapticPort, in virtual time: wait() never sleeps.
#pragma once

#include "scenarios/operators/scripted_operator.h"

namespace cusp::scenarios {

class OperatorPort final : public HapticPort {
 public:
  /// One sample every `dt_s`.
  explicit OperatorPort(ScriptedOperator scripted, double dt_s = 0.001);
  Result<void, PortFailure> open() override { return {}; }
  /// The operator's next sample; `gone` once it is done.
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  void write(const Feedback& feedback) noexcept override;
  DeviceLimits limits() const override;
  void close() noexcept override {}
  bool done() const noexcept { return operator_.done(); }
  const ScriptedOperator& scripted_operator() const noexcept { return operator_; }

 private:
  ScriptedOperator operator_;
  double dt_s_;
  StepOutput felt_;
};

}  // namespace cusp::scenarios
