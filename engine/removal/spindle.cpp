#include "engine/removal/spindle.h"

#include <cmath>

namespace cusp::engine {

namespace {

constexpr double kTau = 6.283185307179586;
/// Slower than this a loaded bur stands, a coasting one is still.
constexpr double kStandsShare = 0.01;
constexpr double kRecoverShare = 0.5;
/// Drag is whole from this share of the free speed on: it begins softly.
constexpr double kWholeDragShare = 0.1;

}  // namespace

void advance(SpindleState& state, const SpindleSettings& settings, double pedal, double push_n, double radius_mm,
             double dt_s) noexcept {
  if (!(settings.free_rpm > 0.0)) return;
  pedal = within(pedal, 0.0, 1.0);
  dt_s = within(dt_s, 0.0, 1.0);
  const double load = within(push_n, 0.0, 1e6) * (within(radius_mm, 0.0, 1e3) / kStallRadiusMm) / settings.stall_n;
  const double share =
      pedal > 0.0 ? (settings.least_rpm + pedal * (settings.free_rpm - settings.least_rpm)) / settings.free_rpm : 0.0;
  // The load at which what drives is spent: less pedal, less of it where the speed is what gives way.
  const double most = settings.sag > 0.0 && share < settings.sag ? share / settings.sag : 1.0;

  if (state.stalled && (pedal == 0.0 || load <= kRecoverShare * most)) state.stalled = false;
  double target = share - settings.sag * load;
  if (load >= most || state.stalled || !(target > 0.0)) target = 0.0;
  target *= settings.free_rpm;
  const double lag_s = target > state.rpm ? settings.up_s : pedal > 0.0 ? settings.load_s : settings.coast_s;
  state.rpm += (target - state.rpm) * (dt_s / (dt_s + lag_s));
  if (target == 0.0 && state.rpm < kStandsShare * settings.free_rpm) {
    state.rpm = 0.0;
    if (pedal > 0.0 && load >= most) state.stalled = true;
  }
  state.rpm = within(state.rpm, 0.0, settings.free_rpm);
}

double removal_factor(const SpindleState& state, const SpindleSettings& settings) noexcept {
  if (!(settings.free_rpm > 0.0)) return 1.0;
  return within(state.rpm / settings.free_rpm, 0.0, 1.0);
}

double surface_speed_mm_s(double rpm, double radius_mm) noexcept { return kTau / 60.0 * rpm * radius_mm; }

Vec3 drag_n(Vec3 force_n, Vec3 axis, double speed_share) noexcept {
  const double force = std::sqrt(glm::dot(force_n, force_n));
  if (!(force > 1e-9) || !(force < 1e6)) return Vec3(0.0);
  // Clockwise seen from the shank is a spin of -axis; the tissue lies at -normal: its motion there is axis x normal, and
  // the tissue holds against it. The length is the sine between axis and normal.
  const Vec3 against = -glm::cross(axis, force_n / force);
  double size = kDragShare * force;
  if (size > kMostDragN) size = kMostDragN;
  return against * (size * within(speed_share / kWholeDragShare, 0.0, 1.0));
}

}  // namespace cusp::engine
