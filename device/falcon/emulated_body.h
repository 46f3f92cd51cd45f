/// The emulated grip's mass, damping, friction and weight, moved by the motors. Trials measure them, and tests compare the
/// results with the settings.
#pragma once

#include <optional>

#include "device/falcon/emulator.h"
#include "device/falcon/gravity.h"

namespace cusp::device::falcon {

struct EmulatedBodySettings {
  double moving_kg = 0.2;
  double damping_ns_per_m = 2.0;
  double friction_n = 0.1;        // Coulomb's
  GravityCalibration weight{};    // of grip and arms; the mass above is what moves
  LinkTime motor_delay{0};        // from a torque word to its torque; up to 10 ms
};

class EmulatedBody {
 public:
  EmulatedBody(Emulator& falcon, const EmulatedBodySettings& settings) noexcept;

  /// Simulates up to `now`; called by EmulatedLink::on_time. Until the arms are homed, the grip moves out and in at 0.06 m/s.
  /// No allocation.
  void advance(LinkTime now) noexcept;
  /// Force of a hand, added to the motors'.
  void set_hand_n(Vec3 force_n) noexcept { hand_n_ = force_n; }

 private:
  void home(double dt_s) noexcept;

  static constexpr std::size_t kPast = 256;
  Emulator& falcon_;
  EmulatedBodySettings settings_;
  Vec3 speed_{0.0}, hand_n_{0.0};
  double out_m_s_ = 0.06;
  std::array<Vec3, kPast> past_{};  // forces of the motors, a step apart
  std::size_t past_at_ = 0;
  std::optional<LinkTime> before_;
};

}  // namespace cusp::device::falcon
