/// Whether the Inverse3's service runs on this computer.
#pragma once

#include "device/inverse/inverse_link.h"

namespace cusp::device::inverse {

/// Whether a service listens at the address. On loopback the system answers at once. Sends nothing.
bool service_listens(const ServiceAddress& address) noexcept;

}  // namespace cusp::device::inverse
