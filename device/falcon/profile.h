/// What was measured of one Falcon and how its user wants it: kept by the station under the device's name, and handed to
/// the driver each time.
#pragma once

#include <cstdint>
#include <optional>

#include "device/falcon/falcon_port.h"

namespace cusp::device {

struct FalconProfile {
  falcon::Calibration calibration{};
  falcon::GravityCalibration gravity{};
  double scale = 0.5;  // mm in the specimen for a mm of the grip; falcon::WorkspaceSettings
  Vec3 centre_m = falcon::kMiddleM;              // of the grip, where a go begins
  std::uint8_t clutch = FalconButtons{}.clutch;  // falcon::status bit of the button; 0: none. A bur's button that is it
                                                 // changes no bur any more
  // Of the self-test, at the grip; not known until it was run.
  std::optional<double> damping_ns_per_m, delay_ms, friction_n, moving_kg, encoder_mm;
  friend bool operator==(const FalconProfile&, const FalconProfile&) = default;
};

// What a profile may say; beyond these a file was damaged or a measurement went wrong [M].
inline constexpr double kLeastForceGain = 0.25, kMostForceGain = 4.0;
inline constexpr double kMostCentreShiftM = 0.03;  // each way: full force reaches 40 mm about the middle

/// The driver's settings for a go: the middle of the device's workspace lies at `origin_mm`, the grip's buttons go
/// through so many burs. Numbers that no Falcon has (tests/device/falcon/self_test_test.cpp) are left at their defaults.
FalconSettings settings_for(const FalconProfile& profile, Vec3 origin_mm = Vec3(0.0), std::uint16_t burs = 1);

}  // namespace cusp::device
