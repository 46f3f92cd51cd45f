/// The devices that can be chosen, by key, and those that are plugged in now. Words are ui's.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>


namespace cusp::device {

struct DeviceKind {
  std::string_view key;           // "pointer", "falcon", "emulated-falcon", "scripted": of settings and command line
  std::string_view device_class;  // of statistics; never mixed
  bool needs_file = false;        // must be told what to play
  bool offered = true;            // in the list that a student sees
};

/// The first is the default.
std::span<const DeviceKind> device_kinds() noexcept;
/// nullptr when there is none of that key.
const DeviceKind* device_kind(std::string_view key) noexcept;

/// One that could be drilled with now.
struct FoundDevice {
  std::string kind;     // DeviceKind::key
  std::string name{};   // which of several: a serial number, else the socket; empty where there is one alone
  std::string port{};   // the socket that it hangs on, "1-4.2"; empty for what is no hardware
  bool denied = false;  // there, and this user may not open it
  friend bool operator==(const FoundDevice&, const FoundDevice&) = default;
};

/// What is plugged in. One thread, not the haptic one.
class DeviceWatch {
 public:
  virtual ~DeviceWatch() = default;
  /// Falcons in order of their sockets, an Inverse3 where its service listens, then the emulated Falcon, then mouse and
  /// keys.
  virtual std::vector<FoundDevice> list() = 0;
  /// Whether one came or went since the last call (true the first time). Does not wait.
  virtual bool changed() noexcept = 0;
};
/// Over libusb. Where that does not start, what is no hardware is listed all the same.
std::unique_ptr<DeviceWatch> watch_devices();

/// What the catalogue adds to every list of hardware, in order.
std::vector<FoundDevice> with_those_of_no_hardware(std::vector<FoundDevice> hardware);

}  // namespace cusp::device
