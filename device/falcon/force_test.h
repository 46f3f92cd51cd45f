/// Lets a hand feel that every direction pushes as it should: six pushes one after the other, each rising over two
/// seconds, held for one, and gone again. The hand holds the grip; one that is let go ends it.
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
  /// Which way it pushes now; what `share` says of the six.
  ForceWay way() const noexcept;
  int step() const noexcept override { return static_cast<int>(way()); }

 private:
  Vec3 wanted(const TrialReading& reading, double dt_s) noexcept override;
  double newtons_, clock_s_ = 0;
};

}  // namespace cusp::device::falcon
