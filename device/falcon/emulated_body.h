/// What hangs on the emulated grip: a mass with damping, friction and weight, which the motors move when no hand does.
/// For trials, whose measurements can be held against what was set here.
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

  /// Moves on to `now`: give it to EmulatedLink::on_time. While the arms are not homed a hand pulls the grip out and
  /// pushes it in, as slowly as a person. No allocation.
  void live(LinkTime now) noexcept;
  /// Of a hand, besides the motors'.
  void set_hand_n(Vec3 force_n) noexcept { hand_n_ = force_n; }
  Vec3 speed_m_s() const noexcept { return speed_; }

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
