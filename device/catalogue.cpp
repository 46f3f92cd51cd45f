#include "device/catalogue.h"

#include <array>

namespace cusp {
namespace {

constexpr std::array<DeviceKind, 4> kKinds = {{
    {.key = "pointer", .device_class = "pointer"},
    {.key = "falcon", .device_class = "falcon"},
    {.key = "emulated-falcon", .device_class = "emulated-falcon", .offered = false},
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

}  // namespace cusp
