/// Lists the connected Falcons, over libusb 1.0.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/base/haptic_port.h"
#include "engine/base/result.h"

namespace cusp::device::falcon {

/// A connected Falcon.
struct FalconOnBus {
  std::string name;     // for make_usb_link(): the serial number if it is unique, else the port
  std::string port;     // USB port, "1-4.2"
  std::string serial;   // empty if it has none, or may not be opened
  bool denied = false;  // this user may not open it (falcon/permissions.h)
  friend bool operator==(const FalconOnBus&, const FalconOnBus&) = default;
};

/// One thread, not the haptic one.
class FalconWatch {
 public:
  virtual ~FalconWatch() = default;
  /// In order of their ports. Opens a new device to read its serial number, once more at each call while it does not give it.
  virtual std::vector<FalconOnBus> list() = 0;
  /// Whether a Falcon came or went since the last call, or one did not give its serial number; true at the first call. Does
  /// not wait.
  virtual bool changed() noexcept = 0;
};

/// Fails with io if libusb does not start.
Result<std::unique_ptr<FalconWatch>, PortFailure> watch_usb_falcons();

}  // namespace cusp::device::falcon
