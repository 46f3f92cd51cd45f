/// A DeviceWatch whose looking is done on a thread of its own: USB and the Inverse3's service may take their time to
/// answer, the window asks for what was found last.
#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include "device/catalogue.h"
#include "ui/modules.h"

namespace cusp::ui {

/// `make` is called on that thread, and the watch made there is asked once an `every`. Before the first answer changed()
/// is false and list() has what is no hardware. No call waits, nor does the destructor: a watch that hangs is waited for when the program
/// ends.
std::unique_ptr<DeviceWatch> watch_in_background(std::function<std::unique_ptr<DeviceWatch>()> make = watch_devices,
                                                 std::chrono::milliseconds every = std::chrono::seconds(1));

}  // namespace cusp::ui
