/// The link over libusb 1.0, asynchronous: three reads are always under way; events answer writes and requests, all on the
/// thread that calls wait(). The loop sends no request. libusb allocates and locks, between two ticks.
#pragma once

#include <memory>
#include <string>

#include "device/falcon/link.h"
#include "engine/base/haptic_port.h"
#include "engine/base/result.h"

namespace cusp::device::falcon {

/// A link to the Falcon of that name (FalconOnBus::name or ::port), or to the first one if `name` is empty. Each open
/// searches again, so that a replugged Falcon is found: by its serial number, else at its USB port. No other takes its
/// place. Fails with io if libusb does not start.
Result<std::unique_ptr<FalconLink>, PortFailure> make_usb_link(std::string name);

}  // namespace cusp::device::falcon
