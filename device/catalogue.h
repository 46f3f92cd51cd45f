/// The kinds of device that a user can choose, by key, and the devices that are connected now. ui has their names.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cusp::device {

namespace inverse {
struct ServiceAddress;
}

struct DeviceKind {
  std::string_view key;           // "pointer", "falcon", "emulated-falcon", "scripted": of settings and command line
  std::string_view device_class;  // of statistics; never mixed
  bool needs_file = false;        // plays a file that the caller names
  bool offered = true;            // in the list for students
  bool self_test = false;         // the device page measures it
};

/// The first is the default.
std::span<const DeviceKind> device_kinds() noexcept;
/// nullptr if no kind has that key.
const DeviceKind* device_kind(std::string_view key) noexcept;

/// A device that can be used now.
struct FoundDevice {
  std::string kind;     // DeviceKind::key
  std::string name{};   // serial number, else the USB port; empty if the kind has one device only
  std::string port{};   // USB port, "1-4.2"; empty for a software device
  bool denied = false;  // connected, but this user may not open it
  friend bool operator==(const FoundDevice&, const FoundDevice&) = default;
};

/// Lists the connected devices. One thread, not the haptic one.
class DeviceWatch {
 public:
  virtual ~DeviceWatch() = default;
  /// Falcons in order of their USB ports, an Inverse3 if its service listens, the emulated Falcon, then mouse and keys.
  virtual std::vector<FoundDevice> list() = 0;
  /// Whether a device came or went since the last call; true at the first call.
  virtual bool changed() noexcept = 0;
};
/// Uses libusb. If libusb does not start, list() still has the software devices. Not for the window's thread: where a firewall drops
/// what goes to the Inverse3's service, list() and changed() wait for 0.2 s, every 3 s at most.
std::unique_ptr<DeviceWatch> watch_devices();
/// The same, with the Inverse3's service at another address.
std::unique_ptr<DeviceWatch> watch_devices_at(const inverse::ServiceAddress& service);

/// Appends the software devices, the emulated Falcon and the pointer, to a list of hardware.
std::vector<FoundDevice> with_software_devices(std::vector<FoundDevice> hardware);

}  // namespace cusp::device
