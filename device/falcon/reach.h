/// Which places of the grip are believed. A believed place lies within kMostMPerS times the time since, and kStepM, of the
/// one believed before it; after a gap of more than kRemembered two in a row have to agree, so that nothing locks out for
/// ever. A bit that flips unreported within that bound cannot be known. Pure; no allocation.
#pragma once

#include <optional>

#include "device/falcon/link.h"
#include "engine/base/vec.h"

namespace cusp::device::falcon {

class Reach {
 public:
  /// Faster than a hand drives a handpiece.
  static constexpr double kMostMPerS = 2.0;
  /// A count of all three arms at once: kCoarsestMmPerTick * sqrt(3).
  static constexpr double kStepM = 1e-4;
  /// A place that old tells nothing of the next: two that agree begin anew.
  static constexpr LinkTime kRemembered = std::chrono::milliseconds(20);

  /// `asked`: when the packet left that told of this place; never earlier than the one before.
  bool believes(Vec3 grip_m, LinkTime asked) noexcept {
    const bool begun = last_ && asked - last_->asked <= kRemembered;
    const bool within = begun && reaches(*last_, grip_m, asked);
    if (begun && believed_ && !within) return false;
    // The first place after a gap is not believed by itself; the next one is held against it.
    last_ = Place{grip_m, asked};
    return believed_ = within;
  }
  void forget() noexcept {
    last_.reset();
    believed_ = false;
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
  bool believed_ = false;  // last_ was; else it is the first after a gap
};

}  // namespace cusp::device::falcon
