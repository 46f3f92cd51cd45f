/// The seam between Cusp and the system's HID devices: hidapi, or a test's own bus. A bus and its readers belong to one
/// thread; several threads may each have a bus.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/base/haptic_port.h"
#include "engine/base/result.h"

namespace cusp::device::hid {

/// One interface of a connected device.
struct HidDevice {
  std::string path;                      // what open() takes: "/dev/hidraw3"
  std::uint16_t vendor = 0, product = 0;
  int interface_number = -1;
  std::string name;                      // the maker's; may be empty
  std::string serial;                    // may be empty
  std::vector<std::uint8_t> descriptor;  // the report descriptor; empty if it could not be read
  friend bool operator==(const HidDevice&, const HidDevice&) = default;
};

struct HidRead {
  enum class Kind : std::uint8_t { report, nothing, lost };
  Kind kind = Kind::nothing;
  std::size_t size = 0;  // bytes of the report, its number first if the device uses numbers
};

/// One open device; the destructor closes it.
class HidReader {
 public:
  virtual ~HidReader() = default;
  /// The next report, or nothing after `at_most`. Cuts off what does not fit.
  virtual HidRead read(std::span<std::uint8_t> into, std::chrono::milliseconds at_most) noexcept = 0;
};

class HidBus {
 public:
  virtual ~HidBus() = default;
  /// All connected devices, one entry per interface, in order of their paths.
  virtual std::vector<HidDevice> list() = 0;
  /// not_found, no_permission, io.
  virtual Result<std::unique_ptr<HidReader>, PortFailure> open(const std::string& path) = 0;
};

}  // namespace cusp::device::hid
