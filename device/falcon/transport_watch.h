/// The Falcons that are plugged in, over libusb 1.0.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/base/haptic_port.h"
#include "engine/base/result.h"

namespace cusp::device::falcon {

/// One that is plugged in.
struct FalconOnBus {
  std::string name;     // what make_usb_link() takes: the serial number if it has one of its own, else the port
  std::string port;     // "1-4.2": the socket that it hangs on
  std::string serial;   // empty when it has none, or when it may not be opened
  bool denied = false;  // this user may not open it (falcon/permissions.h)
  friend bool operator==(const FalconOnBus&, const FalconOnBus&) = default;
};

/// Which Falcons there are. One thread, not the haptic one.
class FalconWatch {
 public:
  virtual ~FalconWatch() = default;
  /// In order of their ports. A device is opened once after it came, to read its serial number.
  virtual std::vector<FalconOnBus> list() = 0;
  /// Whether one came or went since the last call (true the first time). Does not wait.
  virtual bool changed() noexcept = 0;
};

/// Fails with io when libusb does not start.
Result<std::unique_ptr<FalconWatch>, PortFailure> watch_usb_falcons();

}  // namespace cusp::device::falcon
