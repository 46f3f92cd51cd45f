/// The service's JSON as values, and forces as JSON. Pure. Any bytes may be given. The fields are those that public
/// clients of version 3 read and write [M].
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"

namespace cusp::device::inverse {

/// Metres and newtons in the device's own frame: x right, y away from the user, z up [M].
struct Reading {
  Vec3 position_m{0.0};
  std::optional<Quat> orientation;  // of a wireless handle, if there is one; unit
  bool a = false, b = false, c = false;  // its buttons
};

struct Frame {
  struct Device {
    std::string id;
    std::optional<Vec3> position_m;  // none before its first reading
    bool left_handed = false;        // only in the first message
  };
  std::vector<Device> devices;
  std::optional<Quat> orientation;
  bool a = false, b = false, c = false;
  std::string version;               // of the service; may be empty
};

enum class FrameError : std::uint8_t { not_json, no_object, wrong_type, not_finite, too_large };

inline constexpr std::size_t kMostBytes = 64 * 1024;

Result<Frame, FrameError> parse_frame(std::string_view text);

/// The message that sets the force until the next one. Pre: finite.
std::string force_message(std::string_view device, Vec3 force_n);

}  // namespace cusp::device::inverse
