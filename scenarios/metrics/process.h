/// What is measured while the student works: time and force. One add() a tick, on whichever thread follows the ticks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/step/step.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Length of the force before the guard, N. nullopt: nothing is touched, or the proxy has not converged yet (StepOutput::deferred):
/// the spring is then longer than the push by the way that is left.
[[nodiscard]] std::optional<double> known_force_n(const StepOutput& output) noexcept;

class Process {
 public:
  /// Takes one tick's output; no heap, no lock. Force is known_force_n(), weighted by the time in which it is known. Coolant
  /// and warmth of the output count only if the scene has heat.
  void add(const StepOutput& output) noexcept;

  /// Of a cut that nobody played: so long it took, so long of that the bur worked dry; s. No force and no warmth.
  static Process lasting(double time_s, double dry_s) noexcept;

  double time_s() const noexcept { return static_cast<double>(elapsed_us_) * 1e-6; }
  double cutting_s() const noexcept { return static_cast<double>(cutting_us_) * 1e-6; }
  bool touched() const noexcept { return contact_us_ > 0; }
  double force_peak_n() const noexcept { return peak_n_; }
  Vec3 peak_at_mm() const noexcept { return peak_at_mm_; }
  double dry_s() const noexcept { return static_cast<double>(dry_us_) * 1e-6; }
  int overheated() const noexcept { return overheated_; }             // dry-cutting events
  Vec3 overheated_at_mm() const noexcept { return overheated_at_mm_; }  // of the first
  double heat_peak_k() const noexcept { return heat_peak_k_; }
  Vec3 heat_peak_at_mm() const noexcept { return heat_peak_at_mm_; }
  /// Mean over the time in contact; 0 when nothing was touched.
  double force_mean_n() const noexcept { return contact_us_ > 0 ? impulse_ / static_cast<double>(contact_us_) : 0.0; }

  /// All of it, exact to the bit, little-endian: an attempt continues from it.
  std::vector<std::byte> save() const;
  /// nullopt when the bytes are none of save()'s.
  static std::optional<Process> restore(std::span<const std::byte> bytes);

 private:
  /// Every field, in the order of save().
  template <class Self, class Visit>
  static void visit(Self& self, Visit&& one) {
    one(self.elapsed_us_);
    one(self.contact_us_);
    one(self.cutting_us_);
    one(self.peak_n_);
    one(self.impulse_);
    one(self.peak_at_mm_);
    one(self.dry_us_);
    one(self.overheated_);
    one(self.heat_peak_k_);
    one(self.overheated_at_mm_);
    one(self.heat_peak_at_mm_);
  }

  std::uint64_t elapsed_us_ = 0, contact_us_ = 0, cutting_us_ = 0;
  double peak_n_ = 0, impulse_ = 0;  // N, N·µs
  Vec3 peak_at_mm_{0.0};
  std::uint64_t dry_us_ = 0;
  int overheated_ = 0;
  double heat_peak_k_ = 0;
  Vec3 overheated_at_mm_{0.0}, heat_peak_at_mm_{0.0};
};

}  // namespace cusp::scenarios
