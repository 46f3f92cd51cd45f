#include "device/falcon/self_test.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "device/falcon/kinematics.h"

namespace cusp::device::falcon {

namespace {

// [M], all: soft against a loop of 3 ms of delay, and within what a Falcon may push anywhere.
constexpr double kSpringNPerM = 200.0, kDamperNsPerM = 5.0, kCarryPerS = 2.0, kMostCarryN = 2.5;
constexpr double kTravelS = 1.6, kSweepS = 7.0, kReachM = 0.012;
constexpr std::array<double, 4> kSpeedsMS = {0.05, 0.10, 0.16, 0.22};
constexpr double kShakeN = 0.8, kChipS = 0.013;
constexpr double kLeadM = 0.030;  // a spring stretched further means that something holds the grip
constexpr std::size_t kMostSamples = 12'000;
constexpr Vec3 kMiddle = kMiddleM;

double smooth(double s) noexcept {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

template <class Pick, class Better>
std::optional<double> of_axes(const std::array<std::optional<MotionFit>, 3>& axes, Pick pick, Better better) {
  std::optional<double> out;
  for (const auto& axis : axes) {
    if (!axis) return std::nullopt;
    const double value = pick(*axis);
    if (!out || better(value, *out)) out = value;
  }
  return out;
}

}  // namespace

std::optional<double> SelfTestResult::damping_ns_per_m() const noexcept {
  const auto least = of_axes(axes, [](const MotionFit& f) { return f.damping_ns_per_m; }, std::less<>());
  return least ? std::optional(std::max(*least, 0.0)) : std::nullopt;
}
std::optional<double> SelfTestResult::delay_ms() const noexcept {
  return of_axes(axes, [](const MotionFit& f) { return f.delay_ms; }, std::greater<>());
}
std::optional<double> SelfTestResult::friction_n() const noexcept {
  const auto most = of_axes(axes, [](const MotionFit& f) { return f.friction_n; }, std::greater<>());
  return most ? std::optional(std::max(*most, 0.0)) : std::nullopt;
}
std::optional<double> SelfTestResult::moving_kg() const noexcept {
  return of_axes(axes, [](const MotionFit& f) { return f.mass_kg; }, std::greater<>());
}
std::optional<double> SelfTestResult::encoder_mm() const noexcept {
  const int coarsest = *std::max_element(least_counts.begin(), least_counts.end());
  if (*std::min_element(least_counts.begin(), least_counts.end()) < 1) return std::nullopt;
  return coarsest * kCoarsestMmPerTick;
}

SelfTest::SelfTest() : Trial(TrialBounds{.range_from_s = kTravelS}) {
  for (auto& record : records_) record.reserve(kMostSamples);
}

double SelfTest::share() const noexcept {
  if (end() == TrialEnd::done) return 1.0;
  const double one = kTravelS + kSweepS;
  return std::min(1.0, (axis_ * one + stage_s_ + (stage_ == Stage::sweep ? kTravelS : 0.0)) / (3.0 * one));
}

void SelfTest::count(const TrialReading& reading) noexcept {
  ++readings_;
  if (!reading.fresh) {
    ++missing_;
    return;
  }
  if (counted_) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int step = std::abs(reading.encoders[i] - last_[i]);
      if (step == 0) continue;
      if (least_counts_[i] == 0 || step < least_counts_[i]) least_counts_[i] = step;
      most_counts_[i] = std::max(most_counts_[i], step);
    }
  }
  last_ = reading.encoders;
  counted_ = true;
}

Vec3 SelfTest::wanted(const TrialReading& reading, double dt_s) noexcept {
  count(reading);
  if (!began_) {
    began_ = true;
    from_m_ = reading.grip_m;
  }
  stage_s_ += dt_s;
  const Target target = stage_ == Stage::travel ? travel_target() : sweep_target(dt_s);
  const Vec3 off = target.position_m - reading.grip_m;
  if (glm::length(off) > kLeadM && stage_ == Stage::sweep) give_up(TrialEnd::out_of_range);
  // An integral part carries what the spring alone cannot: weight before its calibration.
  carried_n_ += off * (kSpringNPerM * kCarryPerS * dt_s);
  const double carried = glm::length(carried_n_);
  if (carried > kMostCarryN) carried_n_ *= kMostCarryN / carried;
  Vec3 push = off * kSpringNPerM + (target.velocity_m_s - speed()) * kDamperNsPerM + carried_n_;
  push[axis_] += target.shake_n;
  if (stage_ == Stage::sweep) record_sweep(reading);
  return push;
}

SelfTest::Target SelfTest::travel_target() noexcept {
  Target out;
  out.position_m = from_m_ + (kMiddle - from_m_) * smooth(stage_s_ / (0.8 * kTravelS));
  if (stage_s_ >= kTravelS) {
    stage_ = Stage::sweep;
    stage_s_ = way_m_ = chip_s_ = 0;
    direction_ = 1;
  }
  return out;
}

/// To and fro along the axis, each quarter of the sweep at the next speed, with small pushes by chance.
SelfTest::Target SelfTest::sweep_target(double dt_s) noexcept {
  Target out;
  const auto turn = std::min(kSpeedsMS.size() - 1, static_cast<std::size_t>(stage_s_ / kSweepS * kSpeedsMS.size()));
  way_m_ += direction_ * kSpeedsMS[turn] * dt_s;
  if (std::abs(way_m_) > kReachM) direction_ = way_m_ > 0 ? -1.0 : 1.0;
  out.position_m = kMiddle;
  out.position_m[axis_] += way_m_;
  out.velocity_m_s[axis_] = direction_ * kSpeedsMS[turn];
  chip_s_ += dt_s;
  if (chip_s_ >= kChipS) {
    chip_s_ = 0;
    // The opposite push follows each random one: together they do not move the grip.
    second_half_ = !second_half_;
    if (!second_half_) {
      const std::uint32_t bit = ((bits_ >> 0) ^ (bits_ >> 2) ^ (bits_ >> 3) ^ (bits_ >> 5)) & 1u;
      bits_ = (bits_ >> 1) | (bit << 15);
    }
  }
  out.shake_n = ((bits_ & 1u) != 0) != second_half_ ? kShakeN : -kShakeN;
  return out;
}

void SelfTest::record_sweep(const TrialReading& reading) noexcept {
  auto& record = records_[static_cast<std::size_t>(axis_)];
  if (stage_s_ >= kSweepS) {
    stage_ = Stage::travel;
    stage_s_ = 0;
    from_m_ = reading.grip_m;
    if (++axis_ == 3) {
      axis_ = 2;
      finish();
    }
  } else if (reading.fresh && record.size() < kMostSamples) {
    // The bounds decide the force after this call: the next reading writes it.
    if (!record.empty()) record.back().force_n = force_n()[axis_];
    record.push_back({reading.t_s, reading.grip_m[axis_], 0.0});
  }
}

SelfTestResult SelfTest::result() const {
  SelfTestResult out;
  out.least_counts = least_counts_;
  out.most_counts = most_counts_;
  out.readings = readings_;
  out.missing = missing_;
  for (std::size_t i = 0; i < 3; ++i) out.axes[i] = fit_motion(records_[i]);
  return out;
}

}  // namespace cusp::device::falcon
