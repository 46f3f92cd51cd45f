/// Measures mass, damping, friction, delay and encoder steps of a Falcon whose grip nobody holds. A soft spring sweeps the
/// grip along each axis at several speeds while small pushes shake it. Takes about 25 s.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "device/falcon/motion_fit.h"
#include "device/falcon/trial.h"

namespace cusp::device::falcon {

struct SelfTestResult {
  std::array<std::optional<MotionFit>, 3> axes;  // x right, y up, z to the user
  std::array<int, 3> least_counts{};             // smallest step that each arm's encoder made; 1 when all is well
  std::array<int, 3> most_counts{};              // largest in one reading; far more than 20 at these speeds is a lost count
  std::uint64_t readings = 0, missing = 0;

  /// For DeviceLimits: the least damping and the longest delay of the axes. nullopt unless all three were fitted.
  std::optional<double> damping_ns_per_m() const noexcept;
  std::optional<double> delay_ms() const noexcept;
  std::optional<double> friction_n() const noexcept;   // the most
  std::optional<double> moving_kg() const noexcept;    // the most
  std::optional<double> encoder_mm() const noexcept;   // coarsest step at the grip
};

class SelfTest final : public Trial {
 public:
  SelfTest();
  double share() const noexcept override;
  /// Axis that is moved now or next, 0 to 2.
  int step() const noexcept override { return axis_; }
  /// Once it is over. Takes a tenth of a second: not on the haptic thread.
  SelfTestResult result() const;
  /// What it has recorded along an axis.
  const std::vector<MotionSample>& record(int axis) const { return records_[static_cast<std::size_t>(axis)]; }

 private:
  enum class Stage { travel, sweep };
  /// Where the spring leads, with what speed, and the push that shakes the axis.
  struct Target {
    Vec3 position_m{0.0}, velocity_m_s{0.0};
    double shake_n = 0;
  };
  Vec3 wanted(const TrialReading& reading, double dt_s) noexcept override;
  Target travel_target() noexcept;
  Target sweep_target(double dt_s) noexcept;
  void record_sweep(const TrialReading& reading) noexcept;
  void count(const TrialReading& reading) noexcept;

  Stage stage_ = Stage::travel;
  int axis_ = 0;
  double stage_s_ = 0, way_m_ = 0, direction_ = 1, chip_s_ = 0;
  Vec3 from_m_{0.0}, carried_n_{0.0};
  bool began_ = false;
  std::uint32_t bits_ = 0xACE1u;
  bool second_half_ = false;
  std::array<std::vector<MotionSample>, 3> records_;
  std::array<std::int16_t, 3> last_{};
  bool counted_ = false;
  std::array<int, 3> least_counts_{}, most_counts_{};
  std::uint64_t readings_ = 0, missing_ = 0;
};

}  // namespace cusp::device::falcon
