/// Measures the weight of grip and arms: a soft spring holds the grip at nine positions, and its mean torque there is the
/// weight. Nobody touches the grip; the base stands upright. Takes about 25 s.
#pragma once

#include <array>
#include <optional>

#include "device/falcon/gravity.h"
#include "device/falcon/trial.h"

namespace cusp::device::falcon {

class Weighing final : public Trial {
 public:
  static constexpr int kPlaces = 9;

  /// `calibration`: applies to readings and torque words.
  Weighing(const Geometry& geometry, const Calibration& calibration) noexcept;
  double share() const noexcept override;
  int step() const noexcept override { return place_; }  // positions done
  /// Mean position and torque of each position so far.
  std::span<const HeldPose> held() const noexcept { return {held_.data(), static_cast<std::size_t>(place_)}; }
  /// nullopt if no weight fits. Pre: done.
  std::optional<GravityCalibration> result() const noexcept;

 private:
  Vec3 wanted(const TrialReading& reading, double dt_s) noexcept override;

  Geometry geometry_;
  Calibration calibration_;
  std::array<HeldPose, kPlaces> held_{};
  int place_ = 0;
  double clock_s_ = 0;
  int counted_ = 0;
  Vec3 from_m_{0.0}, sum_m_{0.0}, sum_nm_{0.0};
  bool began_ = false;
};

}  // namespace cusp::device::falcon
