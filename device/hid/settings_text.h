/// Settings of pedal and SpaceMouse as text, stored with the station. A value that cannot be read keeps its default.
#pragma once

#include <string>
#include <string_view>

#include "device/hid/pedal.h"
#include "device/hid/space_mouse.h"

namespace cusp::device::hid {

std::string to_text(const PedalSettings& settings);
PedalSettings pedal_settings_from(std::string_view text);

std::string to_text(const SpaceMouseSettings& settings);
SpaceMouseSettings space_mouse_settings_from(std::string_view text);

}  // namespace cusp::device::hid
