/// What the laboratory's figures mean, each defined once. All are fed tick by tick, hold no heap and know no clock.
/// Units: mm, N, mJ (N mm), ms unless a name says otherwise.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "engine/base/vec.h"
#include "engine/lab/closed_loop.h"

namespace cusp::engine::lab {

/// energy_mj: the largest value of the sum of held force times true motion over a contact episode. An episode lasts
/// while a force is held; gaps under 20 ms do not end it, and what moves in them counts (their force is zero).
class ContactEnergy {
 public:
  static constexpr int kGapMs = 20;
  void add(const LoopTick& tick) noexcept { add(tick.held_any, tick.energy_mj); }
  void add(bool contact, double energy_mj) noexcept;
  double most_mj() const noexcept { return most_; }  // 0 before any contact: what is given back is not negative
  double sum_mj() const noexcept { return sum_; }    // of the episode that is on, or of the last one
  int episodes() const noexcept { return episodes_; }

 private:
  double sum_ = 0.0, most_ = 0.0;
  int gap_ = kGapMs, episodes_ = 0;
};

/// Peak to peak, energy and limit over a window of time at the end of a run: what decides whether a stiffness is
/// stable. Motion is true motion along three axes at right angles, given at the start, so that one may lie along the
/// press. Net energy is what the held force gave beyond what its own mean over the window would have given on the same
/// way: a wall that carries 1 N gives out 0.01 mJ for each 10 um that the device stands further out at the window's end
/// than at its beginning, which a spring does too and which is no vibration. Over whole cycles both are the same.
class Steadiness {
 public:
  static constexpr double kWindowS = 0.8, kMostSteps = 2.0, kMostEnergyMj = 0.01;
  enum class Verdict : std::uint8_t { steady, moves, feeds, over_limit };

  Steadiness() = default;
  Steadiness(Vec3 along, Vec3 across) noexcept;
  /// Every tick of the run; in_window: of its final kWindowS.
  void add(const LoopTick& tick, bool in_window) noexcept;
  /// encoder_step_mm: of the device; motion of more than two of them is none of rest.
  Verdict verdict(double encoder_step_mm) const noexcept;

  double peak_to_peak_mm() const noexcept;  // the largest of the three axes
  double energy_mj() const noexcept;        // net, out of the wall
  /// Of the axis that moves most: how often it turns back by more than half of its peak to peak. 0 when it does so less
  /// than twice.
  double cycle_hz() const noexcept;

 private:
  std::array<Vec3, 3> axes_{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  Vec3 low_{std::numeric_limits<double>::infinity()}, high_{-std::numeric_limits<double>::infinity()};
  std::array<Vec3, static_cast<std::size_t>(kWindowS * 1000.0)> window_{};  // along the axes, for cycle_hz
  std::size_t count_ = 0;
  Vec3 from_{0.0}, to_{0.0}, moment_{0.0};  // ends of the window; sum of the held force over its ticks
  double energy_ = 0.0;                     // given, all of it
  bool over_ = false;
};

/// Stuck: over 50 ms the exact proxy moved by more than 0.1 mm and the method's by less than a tenth of that.
class StuckWatch {
 public:
  static constexpr int kWindowMs = 50;
  static constexpr double kMovedMm = 0.1, kShare = 0.1;
  void add(Vec3 exact_mm, Vec3 method_mm) noexcept;  // once a millisecond
  bool stuck() const noexcept { return longest_ > 0; }
  int stuck_ms() const noexcept { return longest_; }  // longest time; 0 when never

 private:
  std::array<Vec3, kWindowMs> exact_{}, method_{};
  std::int64_t count_ = 0;
  int running_ = 0, longest_ = 0;
};

/// How much of a force's change is a push and not a letting go: the change from `before` to `now` without its part that
/// only shortens `before`. N.
double rise_n(Vec3 before_n, Vec3 now_n) noexcept;

/// force_step: rise of force from tick to tick less that of the exact proxy at the same device points, outside first
/// contact and ticks where the guard acted; guard_step: the rise in those, whole. A method that loses its force for
/// less than kGapMs while the exact proxy holds on has lost no contact: the rise when it comes back counts.
class ForceSteps {
 public:
  static constexpr int kGapMs = ContactEnergy::kGapMs;
  /// The tick's force_step in mN, or nothing when it does not count. exact_n: force of the exact proxy.
  std::optional<double> add(Vec3 force_n, Vec3 exact_n, bool guard_acted) noexcept;
  /// What came before no longer counts as a neighbour (a swap, a re-arm).
  void interrupt() noexcept {
    have_ = false;
    gone_ = kGapMs;
  }
  double force_step_mn() const noexcept { return step_; }
  double guard_step_mn() const noexcept { return guard_; }

 private:
  Vec3 force_{0.0}, exact_{0.0};
  bool have_ = false;
  int gone_ = kGapMs;  // ticks without a force since the method had one, the exact proxy in contact in all of them
  double step_ = 0.0, guard_ = 0.0;
};

/// Deepest that a bur has been in tissue, by the exact clearance at its pose. um.
class Penetration {
 public:
  void add(double clearance_mm) noexcept {
    if (!(-clearance_mm * 1000.0 <= most_)) most_ = -clearance_mm * 1000.0;
  }
  double most_um() const noexcept { return most_; }

 private:
  double most_ = 0.0;
};

}  // namespace cusp::engine::lab
