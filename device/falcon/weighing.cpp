#include "device/falcon/weighing.h"

#include <algorithm>

namespace cusp::device::falcon {

namespace {

// Soft, and far from ringing on what the laboratory knows [M]. It sags by the weight over the spring: some 7 mm for 2 N.
constexpr double kHoldNPerM = 300.0, kHoldNsPerM = 8.0;
constexpr double kDrawS = 1.3, kSettleS = 1.0, kMeanS = 0.5;
constexpr double kAsideM = 0.016;

Vec3 place_of(int index) noexcept {
  return {kAsideM * (index / 3 - 1), kAsideM * (index % 3 - 1), kMiddleM.z};
}

}  // namespace

Weighing::Weighing(const Geometry& geometry, const Calibration& calibration) noexcept
    : Trial(TrialBounds{.max_n = 6.0, .radius_m = 0.045, .range_from_s = kDrawS + kSettleS}), geometry_(geometry), calibration_(calibration) {}

double Weighing::share() const noexcept {
  if (end() == TrialEnd::done) return 1.0;
  return std::min(1.0, (place_ + clock_s_ / (kDrawS + kSettleS + kMeanS)) / kPlaces);
}

Vec3 Weighing::wanted(const TrialReading& reading, double dt_s) noexcept {
  if (!began_) {
    began_ = true;
    from_m_ = reading.grip_m;
  }
  clock_s_ += dt_s;
  const Vec3 to = place_of(place_);
  const Vec3 target = from_m_ + (to - from_m_) * std::min(1.0, clock_s_ / kDrawS);
  if (clock_s_ > kDrawS + kSettleS && reading.fresh) {
    sum_m_ += reading.grip_m;
    sum_nm_ += torque_of_counts(calibration_, reading.torque);
    ++counted_;
  }
  if (clock_s_ >= kDrawS + kSettleS + kMeanS && counted_ > 0) {
    const Vec3 mean = sum_m_ / static_cast<double>(counted_);
    const auto legs = inverse(geometry_, mean);
    const auto rows = legs ? jacobian(geometry_, *legs) : std::nullopt;
    if (!rows) {
      give_up(TrialEnd::out_of_range);
      return Vec3(0.0);
    }
    held_[static_cast<std::size_t>(place_)] = {{mean, *legs, *rows}, sum_nm_ / static_cast<double>(counted_)};
    from_m_ = to;
    clock_s_ = 0;
    counted_ = 0;
    sum_m_ = sum_nm_ = Vec3(0.0);
    if (++place_ == kPlaces) {
      finish();
      return Vec3(0.0);
    }
  }
  return (target - reading.grip_m) * kHoldNPerM - speed() * kHoldNsPerM;
}

std::optional<GravityCalibration> Weighing::result() const noexcept {
  return end() == TrialEnd::done ? fit_gravity(geometry_, held_) : std::nullopt;
}

}  // namespace cusp::device::falcon
