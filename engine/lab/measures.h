/// Definitions of the laboratory's figures. Each class receives a tick at a time, and has no heap and no clock.
/// Units: mm, N, mJ (N mm), ms unless a name has its own.
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
  /// A millisecond's part of a sum.
  struct Share {
    bool contact = false;  // a force was held
    double energy_mj = 0.0;
  };
  void add(const LoopTick& tick) noexcept { add(Share{tick.held_any, tick.energy_mj}); }
  void add(const Share& share) noexcept;
  double most_mj() const noexcept { return most_; }  // 0 before any contact
  double sum_mj() const noexcept { return sum_; }    // of the present episode, or of the last one
  int episodes() const noexcept { return episodes_; }

 private:
  double sum_ = 0.0, most_ = 0.0;
  int gap_ = kGapMs, episodes_ = 0;
};

/// Peak to peak, energy and limit over the final window of a press, which decide whether a stiffness is stable. Motion
/// is true motion along three axes at right angles; the caller may choose one along the press. Net energy is the work
/// of the held force less the work of its mean over the window. A wall at 1 N gives 0.01 mJ for each 10 um that the
/// device moves out during the window. A spring does that, too, and it is no vibration. Over whole cycles both works
/// are equal.
class Steadiness {
 public:
  static constexpr double kWindowS = 0.8, kMostSteps = 2.0, kMostEnergyMj = 0.01;
  enum class Verdict : std::uint8_t { steady, moves, feeds, over_limit };

  Steadiness() = default;
  Steadiness(Vec3 along, Vec3 across) noexcept;
  /// Part of the press that a tick belongs to.
  enum class Part : std::uint8_t { before_window, in_window };
  /// Every tick of the press; its final kWindowS are in the window.
  void add(const LoopTick& tick, Part part) noexcept;
  /// encoder_step_mm: of the device. Motion of more than two steps is no rest.
  Verdict verdict(double encoder_step_mm) const noexcept;

  double peak_to_peak_mm() const noexcept;  // the largest of the three axes
  double energy_mj() const noexcept;        // net, out of the wall
  /// Frequency of the axis that moves most: of turns by more than half of its peak to peak. 0 for less than two turns.
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

/// Part of a force's change that pushes: the change from `before` to `now` without the part that only shortens
/// `before`. N.
double rise_n(Vec3 before_n, Vec3 now_n) noexcept;

/// force_step: rise of force from tick to tick, less that of the exact proxy at the same device points. First contact
/// and ticks where the guard acted do not count. guard_step: the whole rise in the guard's ticks. A method's gap of
/// less than kGapMs while the exact proxy has contact does not end the contact: the returning force counts.
class ForceSteps {
 public:
  static constexpr int kGapMs = ContactEnergy::kGapMs;
  struct Tick {
    Vec3 force_n{0.0}, exact_n{0.0};  // of the method, and of the exact proxy
    bool guard_acted = false;
  };
  /// The tick's force_step in mN, or nothing if it does not count.
  std::optional<double> add(const Tick& tick) noexcept;
  /// The next tick has no predecessor (after a change of bur or specimen, or a re-arm).
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

/// Largest depth of a bur in tissue, by the exact clearance at its pose. um.
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
