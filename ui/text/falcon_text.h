/// Text for a Falcon's phases and failures. Needs no window.
#pragma once

#include <QCoreApplication>
#include <QString>

#include "device/falcon/force_test.h"
#include "device/falcon/self_test.h"
#include "device/falcon/session.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"

namespace cusp::ui {

struct FalconText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::Falcon)
};

/// "Loading its firmware, 40 %": what it does now.
QString phase_text(const falcon::SessionState& state);
/// What people can do meanwhile; empty if nothing. In homing and ready as homing_text().
QString help_text(const falcon::SessionState& state);
/// What to do with the grip until all arms are homed; which of them still have to move.
QString homing_text(std::uint8_t homed);
/// Why a Falcon did not open, and the way out.
Message describe_falcon(const PortFailure& failure);
/// Why a firmware file is refused, for a file that somebody named.
Message describe_image(const falcon::ImageFailure& failure);
/// Why a test is over; empty while it is not, and when it was done.
QString end_text(falcon::TrialEnd end);
/// Which way the force test pushes the grip now.
QString way_text(falcon::ForceWay way);
/// What a self-test found, and how stiff exercises may be, in N/mm. Pre: damping and delay were found.
QString measured_text(const falcon::SelfTestResult& found, double stiffness_before, double stiffness_now);

/// "Falcon FT000001", "Emulated Falcon, driven by mouse", "Mouse and keys".
QString device_title(const std::string& kind, const std::string& name);

}  // namespace cusp::ui
