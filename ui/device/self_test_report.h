/// What a technician gets of a self-test: one JSON text, the same in every language. No window.
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <string>

#include "device/falcon/profile.h"
#include "device/falcon/self_test.h"
#include "ui/modules.h"
#include "ui/session/device_bench.h"

namespace cusp::ui {

struct ReportedDevice {
  std::string kind, name;      // "falcon", "FT000001"
  std::string station;         // this computer's name
  std::string firmware_sha256;
  QDateTime when;
};

QByteArray self_test_report(const ReportedDevice& device, const falcon::SelfTestResult& found, const FalconProfile& profile,
                            const BenchView& bench);

/// The stiffest that a scene may be with this profile, N/mm (engine/step/stiffness_rule.h).
struct AllowedStiffness {
  double n_per_mm = 0;
  bool assumed = false;  // damping or delay is not known of this Falcon
};
AllowedStiffness allowed_stiffness(const FalconProfile& profile);

}  // namespace cusp::ui
