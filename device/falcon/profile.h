/// What was measured of one Falcon: kept by the station under the device's name, and handed to the driver each time.
#pragma once

#include <cstdint>
#include <optional>

#include "device/falcon/falcon_port.h"

namespace cusp {

struct FalconProfile {
  falcon::Calibration calibration{};
  falcon::GravityCalibration gravity{};
  double scale = 0.5;  // mm in the specimen for a mm of the grip; falcon::WorkspaceSettings
  // Of the self-test, at the grip; not known until it was run.
  std::optional<double> damping_ns_per_m, delay_ms, friction_n, moving_kg, encoder_mm;
  friend bool operator==(const FalconProfile&, const FalconProfile&) = default;
};

/// The driver's settings for a go: the middle of the device's workspace lies at `origin_mm`, the grip's buttons go
/// through so many burrs. Numbers that no Falcon has (tests/device/falcon/profile_test.cpp) are left at their defaults.
FalconSettings settings_for(const FalconProfile& profile, Vec3 origin_mm = Vec3(0.0), std::uint16_t burrs = 1);

}  // namespace cusp
