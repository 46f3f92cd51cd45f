/// HID devices over hidapi's hidraw backend. hidapi's global functions are not thread-safe: a mutex serialises them here, so
/// that each thread may have a bus of its own.
#pragma once

#include <memory>

#include "device/hid/hid_bus.h"

namespace cusp::device::hid {

/// nullptr if hidapi does not start.
std::unique_ptr<HidBus> make_hidapi_bus();

}  // namespace cusp::device::hid
