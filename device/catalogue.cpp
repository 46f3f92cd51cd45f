#include "device/catalogue.h"

#include <array>

namespace cusp {
namespace {

constexpr std::array<DeviceKind, 2> kKinds = {{
    {.key = "pointer", .device_class = "pointer"},
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
