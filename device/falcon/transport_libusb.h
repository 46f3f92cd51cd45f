/// The link over libusb 1.0. Asynchronous: three reads are always under way, writes and requests are submitted and
/// answered by events, all on the thread that calls wait(); no request is sent in the loop. libusb itself allocates and
/// locks: that lies between two ticks. libusb's header stays in transport_*.
#pragma once

#include <memory>
#include <string>

#include "device/falcon/link.h"
#include "engine/base/haptic_port.h"
#include "engine/base/result.h"

namespace cusp::device::falcon {

/// A link to the Falcon of that name (FalconOnBus::name or ::port), or to the first there is when `name` is empty. It
/// is found each time the driver asks to open, so that one that was unplugged is found again. Fails with io when libusb
/// does not start.
Result<std::unique_ptr<FalconLink>, PortFailure> make_usb_link(std::string name);

}  // namespace cusp::device::falcon
