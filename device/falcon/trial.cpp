#include "device/falcon/trial.h"

#include <algorithm>
#include <cmath>

namespace cusp::device::falcon {

namespace {

constexpr double kSpeedSmoothS = 0.005;

Vec3 shortened(Vec3 v, double most) noexcept {
  const double length = glm::length(v);
  return length > most ? v * (most / length) : v;
}

}  // namespace

Vec3 Trial::advance(const TrialReading& reading) noexcept {
  if (end_ == TrialEnd::none && reading.gone) end_ = TrialEnd::device_lost;
  if (!began_) {
    began_ = true;
    last_m_ = reading.grip_m;
    last_s_ = last_fresh_s_ = began_s_ = reading.t_s;
  }
  if (reading.fresh) {
    const double dt = reading.t_s - last_fresh_s_;
    if (dt > 0) speed_ += ((reading.grip_m - last_m_) / dt - speed_) * std::min(1.0, dt / kSpeedSmoothS);
    last_m_ = reading.grip_m;
    last_fresh_s_ = reading.t_s;
  } else if (end_ == TrialEnd::none && reading.t_s - last_fresh_s_ > bounds_.silence_s) {
    end_ = TrialEnd::device_lost;
  }
  if (end_ == TrialEnd::none) {
    const double across = std::hypot(reading.grip_m.x, reading.grip_m.y);
    const bool in_range = across <= bounds_.radius_m && reading.grip_m.z >= bounds_.least_z_m && reading.grip_m.z <= bounds_.most_z_m;
    const bool checked = reading.t_s - began_s_ >= bounds_.range_from_s || !std::isfinite(across);
    // A NaN position is out of range, a NaN speed too fast.
    if (!in_range && checked) {
      end_ = TrialEnd::out_of_range;
    } else if (!(glm::length(speed_) <= bounds_.max_m_s)) {
      end_ = TrialEnd::too_fast;
    }
  }
  const double dt_s = std::max(0.0, reading.t_s - last_s_);
  last_s_ = reading.t_s;
  if (end_ != TrialEnd::none) return force_n_ = Vec3(0.0);
  const Vec3 asked = shortened(wanted(reading, dt_s), bounds_.max_n);
  if (end_ != TrialEnd::none || !std::isfinite(asked.x + asked.y + asked.z)) return force_n_ = Vec3(0.0);
  return force_n_ += shortened(asked - force_n_, bounds_.rise_n_s * dt_s);
}

}  // namespace cusp::device::falcon
