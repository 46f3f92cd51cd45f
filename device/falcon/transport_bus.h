/// What link and watch share of libusb: a context, the devices on the bus, and their identification. Only for
/// transport_*.cpp.
#pragma once

#include <libusb-1.0/libusb.h>

#include <memory>
#include <span>
#include <string>

#include "engine/base/haptic_port.h"
#include "engine/base/result.h"

namespace cusp::device::falcon {

struct ContextEnd {
  void operator()(libusb_context* context) const noexcept { libusb_exit(context); }
};
using Context = std::unique_ptr<libusb_context, ContextEnd>;

/// Fails with io when libusb does not start.
Result<Context, PortFailure> start_libusb();

/// The devices of the bus; unreferenced with the list.
class DeviceList {
 public:
  explicit DeviceList(libusb_context* context) noexcept : count_(libusb_get_device_list(context, &list_)) {}
  ~DeviceList() {
    if (list_ != nullptr) libusb_free_device_list(list_, 1);
  }
  DeviceList(const DeviceList&) = delete;
  DeviceList& operator=(const DeviceList&) = delete;
  std::span<libusb_device* const> all() const noexcept {
    return {list_, count_ > 0 ? static_cast<std::size_t>(count_) : 0};
  }

 private:
  libusb_device** list_ = nullptr;
  ssize_t count_;
};

/// Whether vendor and product are a Falcon's. Fills in `descriptor`.
bool is_falcon(libusb_device* device, libusb_device_descriptor& descriptor) noexcept;
/// The USB port, "1-4.2".
std::string port_of(libusb_device* device);
/// Empty if it has none. Blocks up to a second if the device does not answer.
std::string serial_of(libusb_device_handle* handle, const libusb_device_descriptor& descriptor);

}  // namespace cusp::device::falcon
