/// Text for what a pedal has: its controls and its devices. Thread: GUI.
#pragma once

#include <QString>
#include <vector>

#include "device/hid/hid_bus.h"
#include "device/hid/pedal.h"
#include "ui/modules.h"

namespace cusp::ui {

/// "Pedal 2", "Right brake", "Key F13".
QString control_name(const hid::Control& control);
QString control_name(hid::ControlId id, hid::ControlKind kind);
/// As the device reports it; of one that it does not have, by its page.
hid::ControlKind control_kind(hid::ControlId id, const std::vector<hid::Control>& controls);
/// The maker's name, or its numbers where it has none.
QString hid_name(const hid::HidDevice& device);

}  // namespace cusp::ui
