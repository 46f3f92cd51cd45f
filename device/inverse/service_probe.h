/// Whether the Inverse3's service runs on this computer.
#pragma once

#include "device/inverse/inverse_link.h"

namespace cusp::device::inverse {

/// Whether a service listens at the address. Sends nothing. On loopback the system answers at once. If the service's queue of
/// connections is full, or a firewall drops the question, the answer is false after 0.2 s. Thread: one that may wait.
bool service_listens(const ServiceAddress& address) noexcept;

}  // namespace cusp::device::inverse
