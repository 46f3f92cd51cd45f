/// HID devices over hidapi's hidraw backend. Its global functions are not made for several threads: they are called one
/// at a time here, so that each thread may hold a bus of its own. hidapi's header stays in the .cpp.
#pragma once

#include <memory>

#include "device/hid/hid_bus.h"

namespace cusp::device::hid {

/// Null when hidapi does not start.
std::unique_ptr<HidBus> make_hidapi_bus();

}  // namespace cusp::device::hid
