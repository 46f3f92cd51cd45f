/// A programme that moves a Falcon, to measure it or for a hand to feel it. Pure: a function of its readings and its state.
/// All trials share the same bounds, and give no force after their end.
#pragma once

#include <array>
#include <cstdint>

#include "engine/base/vec.h"

namespace cusp::device::falcon {

/// One reading; the device's frame, metres, seconds since any zero.
struct TrialReading {
  double t_s = 0;
  Vec3 grip_m{0.0};
  std::array<std::int16_t, 3> encoders{};
  std::array<std::int16_t, 3> torque{};  // words of the last packet
  bool fresh = true;                     // false: the device did not answer this time
  bool gone = false;                     // position unknown
};

enum class TrialEnd : std::uint8_t {
  none,         // still running
  done,
  stopped,      // asked to
  device_lost,  // gone, or without an answer for 20 ms
  too_fast,     // faster than a hand that holds it
  out_of_range, // near an end of the travel, or far from the target: something holds the grip
};

/// What every trial keeps to. [M], all of them: gentle for a hand, and no Falcon was tried.
struct TrialBounds {
  double max_n = 4.0;
  double max_m_s = 0.8;
  double rise_n_s = 400.0;                   // no force changes faster, up or down
  double radius_m = 0.040;                   // from the middle, across
  double least_z_m = 0.080, most_z_m = 0.170;
  double range_from_s = 0.0;                 // range unchecked until then: an idle grip starts at its lowest point
  double silence_s = 0.020;
};

class Trial {
 public:
  virtual ~Trial() = default;

  /// Haptic thread; no allocation. The force in the device's frame (x right, y up, z to the user), newtons, after the
  /// bounds; zero once it is over.
  Vec3 advance(const TrialReading& reading) noexcept;
  /// Ends it; the force is zero from the next reading on.
  void stop() noexcept {
    if (end_ == TrialEnd::none) end_ = TrialEnd::stopped;
  }
  TrialEnd end() const noexcept { return end_; }
  /// How far it is, 0 to 1.
  virtual double share() const noexcept = 0;
  /// Which of its parts it is at, counted from 0.
  virtual int step() const noexcept { return 0; }
  /// The force that advance() gave last.
  Vec3 force_n() const noexcept { return force_n_; }

 protected:
  explicit Trial(const TrialBounds& bounds) noexcept : bounds_(bounds) {}
  /// What it wants now; `dt_s` since the last reading, 0 at the first.
  virtual Vec3 wanted(const TrialReading& reading, double dt_s) noexcept = 0;
  void finish() noexcept { end_ = TrialEnd::done; }
  void give_up(TrialEnd why) noexcept { end_ = why; }
  /// Of the grip, smoothed over some 5 ms; m/s.
  Vec3 speed() const noexcept { return speed_; }

  TrialBounds bounds_;

 private:
  TrialEnd end_ = TrialEnd::none;
  Vec3 force_n_{0.0}, last_m_{0.0}, speed_{0.0};
  double last_s_ = 0, last_fresh_s_ = 0, began_s_ = 0;
  bool began_ = false;
};

}  // namespace cusp::device::falcon
