#include "device/falcon/profile.h"

#include <cmath>

namespace cusp::device {

namespace {

// As the limits of profile.h [M].
constexpr double kMostTrimRad = 0.1, kMostGripKg = 1.0, kMostArmKgM = 0.05;
constexpr double kMostDamping = 20.0, kMostDelayMs = 20.0, kMostEncoderMm = 1.0;

bool within(double value, double low, double high) noexcept { return value >= low && value <= high; }

std::optional<double> kept(std::optional<double> value, double high) noexcept {
  return value && within(*value, 0.0, high) ? value : std::nullopt;
}

}  // namespace

FalconSettings settings_for(const FalconProfile& profile, Vec3 origin_mm, std::uint16_t burs) {
  FalconSettings out;
  const Vec3 trim = profile.calibration.trim_rad;
  if (within(trim.x, -kMostTrimRad, kMostTrimRad) && within(trim.y, -kMostTrimRad, kMostTrimRad) &&
      within(trim.z, -kMostTrimRad, kMostTrimRad))
    out.calibration.trim_rad = trim;
  if (within(profile.calibration.force_gain, kLeastForceGain, kMostForceGain))
    out.calibration.force_gain = profile.calibration.force_gain;
  if (within(profile.gravity.grip_kg, 0.0, kMostGripKg) && within(profile.gravity.arm_kg_m, 0.0, kMostArmKgM))
    out.gravity = profile.gravity;
  if (within(profile.scale, falcon::Workspace::kMinScale, falcon::Workspace::kMaxScale))
    out.workspace.scale = profile.scale;
  const Vec3 shift = profile.centre_m - falcon::kMiddleM;
  if (within(shift.x, -kMostCentreShiftM, kMostCentreShiftM) && within(shift.y, -kMostCentreShiftM, kMostCentreShiftM) &&
      within(shift.z, -kMostCentreShiftM, kMostCentreShiftM))
    out.workspace.centre_m = profile.centre_m;
  out.workspace.origin_mm = origin_mm;
  FalconButtons& does = out.buttons;
  if (profile.clutch == 0 || profile.clutch == does.clutch || profile.clutch == does.next_bur ||
      profile.clutch == does.previous_bur) {
    if (profile.clutch == does.next_bur) does.next_bur = 0;
    if (profile.clutch == does.previous_bur) does.previous_bur = 0;
    does.clutch = profile.clutch;
  }
  out.burs = burs;
  out.damping_ns_per_m = kept(profile.damping_ns_per_m, kMostDamping);
  out.delay_ms = kept(profile.delay_ms, kMostDelayMs);
  out.encoder_mm = kept(profile.encoder_mm, kMostEncoderMm);
  return out;
}

}  // namespace cusp::device
