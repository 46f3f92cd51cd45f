/// The devices that can be chosen, by key. Words are ui's.
#pragma once

#include <span>
#include <string_view>

namespace cusp {

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

}  // namespace cusp
