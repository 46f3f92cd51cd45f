#include "engine/lab/hand_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cusp::engine {

namespace {
/// Step of the delay line.
constexpr double kLineStepS = 0.001;
/// Longest step of the integration: well below the period of mass and grip (0.15 kg on 1 N/mm: 77 ms).
constexpr double kMostStepS = 0.001;
}  // namespace

HandModel::HandModel(const HandSettings& settings, Vec3 start_mm)
    : settings_(settings), position_mm_(start_mm), random_(settings.seed) {
  const auto places = static_cast<std::size_t>(std::max(0.0, std::round(settings.delay_s / kLineStepS))) + 1;
  late_.assign(places, start_mm);
}

double HandModel::uniform() noexcept {
  // SplitMix64: the same numbers on every machine.
  std::uint64_t z = (random_ += 0x9E3779B97F4A7C15ull);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) / 4503599627370496.0 - 1.0;  // 2^52
}

Vec3 HandModel::advance(Vec3 wanted_mm, Vec3 force_n, double dt_s) {
  for (carry_s_ += dt_s; carry_s_ >= kLineStepS - 1e-9; carry_s_ -= kLineStepS) {
    late_[at_] = wanted_mm;
    at_ = (at_ + 1) % late_.size();
  }
  // Tremor: a resonance at tremor_hz, driven by noise; its rms is tremor_mm (stationary variance of the oscillator).
  const double omega = 2.0 * std::numbers::pi * settings_.tremor_hz;
  constexpr double kTremorDamping = 0.15;
  const int steps = std::max(1, static_cast<int>(std::ceil(dt_s / kMostStepS)));
  const double dt = dt_s / steps;
  const double stiffness = settings_.stiffness_n_per_mm * 1000.0;  // N/m
  const double damping = 2.0 * settings_.damping_ratio * std::sqrt(stiffness * settings_.mass_kg);
  for (int i = 0; i < steps; ++i) {
    if (settings_.tremor_mm > 0.0) {
      // White noise of uniform numbers (variance 1/3), scaled to the wanted variance.
      const double kick = settings_.tremor_mm * std::sqrt(4.0 * kTremorDamping * omega * omega * omega * dt * 3.0);
      for (int a = 0; a < 3; ++a) {
        tremor_rate_[a] +=
            dt * (-omega * omega * tremor_mm_[a] - 2.0 * kTremorDamping * omega * tremor_rate_[a]) + kick * uniform();
        tremor_mm_[a] += dt * tremor_rate_[a];
      }
    }
    // Semi-implicit: the spring at the old place, the damper at the new velocity.
    const Vec3 goal = late_[at_] + tremor_mm_;
    const Vec3 pull = stiffness * (goal - position_mm_) * 1e-3 + force_n;  // N
    velocity_mm_s_ = (velocity_mm_s_ + 1e3 * dt / settings_.mass_kg * pull) / (1.0 + dt * damping / settings_.mass_kg);
    position_mm_ += dt * velocity_mm_s_;
  }
  return position_mm_;
}

}  // namespace cusp::engine
