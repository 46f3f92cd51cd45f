#include "device/falcon/transport_bus.h"

#include <array>
#include <cstdint>

#include "device/falcon/ftdi.h"

namespace cusp::device::falcon {

Result<Context, PortFailure> start_libusb() {
  libusb_context* context = nullptr;
  const int error = libusb_init(&context);
  if (error != 0) return fail(PortError::io, "libusb", libusb_error_name(error));
  return Context(context);
}

bool is_falcon(libusb_device* device, libusb_device_descriptor& descriptor) noexcept {
  return libusb_get_device_descriptor(device, &descriptor) == 0 && descriptor.idVendor == kVendor &&
         descriptor.idProduct == kProduct;
}

std::string port_of(libusb_device* device) {
  std::array<std::uint8_t, 7> ports{};  // USB allows seven tiers
  const int count = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
  std::string out = std::to_string(libusb_get_bus_number(device));
  if (count <= 0) return out + "-address" + std::to_string(libusb_get_device_address(device));
  for (int i = 0; i < count; ++i) {
    out += (i == 0 ? "-" : ".") + std::to_string(ports[static_cast<std::size_t>(i)]);
  }
  return out;
}

std::string serial_of(libusb_device_handle* handle, const libusb_device_descriptor& descriptor) {
  if (descriptor.iSerialNumber == 0) return {};
  std::array<unsigned char, 128> text{};
  const int size =
      libusb_get_string_descriptor_ascii(handle, descriptor.iSerialNumber, text.data(), static_cast<int>(text.size()));
  if (size <= 0) return {};
  return {reinterpret_cast<const char*>(text.data()), static_cast<std::size_t>(size)};
}

}  // namespace cusp::device::falcon
