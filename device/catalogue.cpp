#include "device/catalogue.h"

#include <array>

namespace cusp::device {
namespace {

constexpr std::array<DeviceKind, 5> kKinds = {{
    {.key = "pointer", .device_class = "pointer"},
    {.key = "falcon", .device_class = "falcon", .self_test = true},
    {.key = "emulated-falcon", .device_class = "emulated-falcon", .self_test = true},
    {.key = "inverse3", .device_class = "inverse3"},
    {.key = "scripted", .device_class = "scripted", .needs_file = true, .offered = false},
}};

}  // namespace

std::span<const DeviceKind> device_kinds() noexcept { return kKinds; }

const DeviceKind* device_kind(std::string_view key) noexcept {
  for (const DeviceKind& kind : kKinds) {
    if (kind.key == key) return &kind;
  }
  return nullptr;
}

std::vector<FoundDevice> with_software_devices(std::vector<FoundDevice> hardware) {
  hardware.push_back({.kind = "emulated-falcon"});
  hardware.push_back({.kind = "pointer"});
  return hardware;
}

}  // namespace cusp::device
