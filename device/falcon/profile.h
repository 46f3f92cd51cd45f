/// Calibration and preferences of one Falcon. The station stores it under the device's name and passes it to the driver.
#pragma once

#include <cstdint>
#include <optional>

#include "device/falcon/falcon_port.h"

namespace cusp::device {

struct FalconProfile {
  falcon::Calibration calibration{};
  falcon::GravityCalibration gravity{};
  double scale = 0.5;  // mm in the specimen for a mm of the grip; falcon::WorkspaceSettings
  Vec3 centre_m = falcon::kMiddleM;              // of the grip at the start of a session
  std::uint8_t clutch = FalconButtons{}.clutch;  // falcon::status bit of the button; 0: none. As a bur button it then
                                                 // changes no bur
  // Results of the self-test, at the grip; none before the first.
  std::optional<double> damping_ns_per_m, delay_ms, friction_n, moving_kg, encoder_mm;
  friend bool operator==(const FalconProfile&, const FalconProfile&) = default;
};

// Limits of a profile: beyond them a file is damaged or a measurement failed [M].
inline constexpr double kLeastForceGain = 0.25, kMostForceGain = 4.0;
inline constexpr double kMostCentreShiftM = 0.03;  // each way: full force reaches 40 mm about the middle

/// The driver's settings for a session: the middle of the workspace lies at `origin_mm`, and the buttons step through
/// `burs` burs. A number out of range keeps its default (tests/device/falcon/self_test_test.cpp).
FalconSettings settings_for(const FalconProfile& profile, Vec3 origin_mm = Vec3(0.0), std::uint16_t burs = 1);

}  // namespace cusp::device
