/// Whether the Inverse3's service runs on this computer.
#pragma once

#include "device/inverse/inverse_link.h"

namespace cusp::device::inverse {

/// Whether anybody listens there. On loopback the system answers at once; nothing is said to whoever listens.
bool service_listens(const ServiceAddress& address) noexcept;

}  // namespace cusp::device::inverse
