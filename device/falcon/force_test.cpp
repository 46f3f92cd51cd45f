#include "device/falcon/force_test.h"

#include <algorithm>
#include <array>

namespace cusp::device::falcon {

namespace {

constexpr double kRiseS = 2.0, kHoldS = 1.0, kFallS = 0.5, kRestS = 0.5;
constexpr double kOneS = kRiseS + kHoldS + kFallS + kRestS;
constexpr int kWays = 6;
// A hand that holds on moves with it no faster than this [M].
constexpr double kReleasedMS = 0.30;
constexpr double kSoftenNsPerM = 3.0;

TrialBounds bounds() noexcept {
  TrialBounds out;
  out.max_n = ForceTest::kMostN + 1.0;  // and what softens it
  out.max_m_s = kReleasedMS;
  return out;
}

}  // namespace

ForceTest::ForceTest(double newtons) noexcept
    : Trial(bounds()), newtons_(newtons > 0.0 ? std::min(newtons, kMostN) : 0.0) {}

double ForceTest::share() const noexcept {
  return end() == TrialEnd::done ? 1.0 : std::min(1.0, clock_s_ / (kWays * kOneS));
}

ForceWay ForceTest::way() const noexcept {
  return static_cast<ForceWay>(std::clamp(static_cast<int>(clock_s_ / kOneS), 0, kWays - 1));
}

Vec3 ForceTest::wanted(const TrialReading&, double dt_s) noexcept {
  clock_s_ += dt_s;
  if (clock_s_ >= kWays * kOneS) {
    finish();
    return Vec3(0.0);
  }
  const double s = clock_s_ - kOneS * static_cast<int>(clock_s_ / kOneS);
  const double share = s < kRiseS ? s / kRiseS : s < kRiseS + kHoldS ? 1.0 : std::max(0.0, 1.0 - (s - kRiseS - kHoldS) / kFallS);
  constexpr std::array<Vec3, kWays> kDirections = {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0),
                                                   Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)};
  return kDirections[static_cast<std::size_t>(way())] * (newtons_ * share) - speed() * kSoftenNsPerM;
}

}  // namespace cusp::device::falcon
