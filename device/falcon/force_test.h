/// Shows a hand that every direction pushes correctly: six pushes in turn, each rising over 2 s, held for 1 s, then falling.
/// The hand holds the grip; a released grip ends the test.
#pragma once

#include "device/falcon/trial.h"

namespace cusp::device::falcon {

enum class ForceWay : std::uint8_t { right, left, up, down, to_user, away };

class ForceTest final : public Trial {
 public:
  static constexpr double kMostN = 3.0;

  /// Newtons, cut to [0, kMostN].
  explicit ForceTest(double newtons) noexcept;
  double share() const noexcept override;
  /// Direction of the present push.
  ForceWay way() const noexcept;
  int step() const noexcept override { return static_cast<int>(way()); }

 private:
  Vec3 wanted(const TrialReading& reading, double dt_s) noexcept override;
  double newtons_, clock_s_ = 0;
};

}  // namespace cusp::device::falcon
