/// A hand behind the same seam as any device, in virtual time: wait() never sleeps.
#pragma once

#include "scenarios/operators/hand.h"

namespace cusp::scenarios {

class HandPort final : public HapticPort {
 public:
  /// One sample every `dt_s`.
  explicit HandPort(Hand hand, double dt_s = 0.001);
  Result<void, PortFailure> open() override { return {}; }
  /// The hand's next sample; `gone` once it is done.
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  void write(const Feedback& feedback) noexcept override;
  DeviceLimits limits() const override;
  void close() noexcept override {}
  bool done() const noexcept { return hand_.done(); }
  const Hand& hand() const noexcept { return hand_; }

 private:
  Hand hand_;
  double dt_s_;
  StepOutput felt_;
};

}  // namespace cusp::scenarios
