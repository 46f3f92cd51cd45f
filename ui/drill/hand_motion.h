/// Whether somebody holds the device of an attempt. One that nobody holds trembles by less than kHandMm where it lies on the tooth.
#pragma once

#include <cmath>
#include <optional>

#include "engine/base/vec.h"
#include "ui/modules.h"

namespace cusp::ui {

class HandMotion {
 public:
  static constexpr double kHandMm = 0.5;  // a hand at rest moves as far within seconds
  static constexpr double kHandDeg = 3.0;

  /// True at first, and once the device is farther than kHandMm or kHandDeg from where it was at the last true.
  bool moved(Vec3 at_mm, Quat turn) {
    constexpr double kSameTurn = 0.99965732;  // cosine of half kHandDeg
    if (last_ && glm::length(at_mm - last_->at_mm) <= kHandMm && std::abs(glm::dot(turn, last_->turn)) >= kSameTurn) return false;
    last_ = {at_mm, turn};
    return true;
  }

 private:
  struct Place {
    Vec3 at_mm;
    Quat turn;
  };
  std::optional<Place> last_;
};

}  // namespace cusp::ui
