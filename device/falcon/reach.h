/// Rejects positions of the grip that a hand cannot have reached. An accepted position lies within kMostMPerS times the
/// elapsed time, plus kStepM, of the last accepted one. After a gap of more than kRemembered two in a row must agree, so
/// that no error locks the filter. It cannot detect a flipped bit within that bound. Pure; no allocation.
#pragma once

#include <optional>

#include "device/falcon/link.h"
#include "engine/base/vec.h"

namespace cusp::device::falcon {

class Reach {
 public:
  /// m/s; a hand moves a handpiece slower.
  static constexpr double kMostMPerS = 2.0;
  /// m; one count of all three arms at once: kCoarsestMmPerTick * sqrt(3).
  static constexpr double kStepM = 1e-4;
  /// After a longer gap the last position is not used; two that agree start anew.
  static constexpr LinkTime kRemembered = std::chrono::milliseconds(20);

  /// `asked`: departure of the packet that this position answers. Pre: never earlier than the last one.
  bool accepts(Vec3 grip_m, LinkTime asked) noexcept {
    const bool begun = last_ && asked - last_->asked <= kRemembered;
    const bool within = begun && reaches(*last_, grip_m, asked);
    if (begun && accepted_ && !within) return false;
    // The first position after a gap is rejected; the next one is compared with it.
    last_ = Place{grip_m, asked};
    return accepted_ = within;
  }
  void forget() noexcept {
    last_.reset();
    accepted_ = false;
  }

 private:
  struct Place {
    Vec3 grip_m{0.0};
    LinkTime asked{0};
  };
  static bool reaches(const Place& from, Vec3 to_m, LinkTime asked) noexcept {
    const double s = std::chrono::duration<double>(asked - from.asked).count();
    return glm::length(to_m - from.grip_m) <= kMostMPerS * s + kStepM;
  }

  std::optional<Place> last_;
  bool accepted_ = false;  // false: last_ is the first after a gap
};

}  // namespace cusp::device::falcon
