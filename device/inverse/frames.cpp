#include "device/inverse/frames.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace cusp::device::inverse {

namespace {

using nlohmann::json;
using Found = Result<void, FrameError>;

constexpr double kFarthestM = 10.0;      // a reading beyond it is none of this device's
constexpr double kLeastLength = 0.5, kMostLength = 2.0;  // tolerated length of a quaternion that should be unit

/// A member that may be missing; one of another type than `object` is wrong.
Result<const json*, FrameError> object_in(const json& in, const char* key) {
  const auto at = in.find(key);
  if (at == in.end() || at->is_null()) return nullptr;
  if (!at->is_object()) return std::unexpected(FrameError::wrong_type);
  return &*at;
}

Result<double, FrameError> number_in(const json& in, const char* key) {
  const auto at = in.find(key);
  if (at == in.end() || !at->is_number()) return std::unexpected(FrameError::wrong_type);
  const double value = at->get<double>();
  if (!std::isfinite(value)) return std::unexpected(FrameError::not_finite);
  return value;
}

std::string text_in(const json& in, const char* key) {
  const auto at = in.find(key);
  return at != in.end() && at->is_string() ? at->get<std::string>() : std::string();
}

Found read_device(const json& in, Frame::Device& out) {
  if (!in.is_object()) return std::unexpected(FrameError::wrong_type);
  out.id = text_in(in, "device_id");
  const auto config = object_in(in, "config");
  if (!config) return std::unexpected(config.error());
  if (*config != nullptr) out.left_handed = text_in(**config, "handedness") == "left";
  const auto state = object_in(in, "state");
  if (!state) return std::unexpected(state.error());
  if (*state == nullptr) return {};
  const auto place = object_in(**state, "cursor_position");
  if (!place) return std::unexpected(place.error());
  if (*place == nullptr || (*place)->empty()) return {};
  const auto x = number_in(**place, "x"), y = number_in(**place, "y"), z = number_in(**place, "z");
  for (const auto* each : {&x, &y, &z}) {
    if (!*each) return std::unexpected(each->error());
  }
  const Vec3 at(*x, *y, *z);
  if (glm::length(at) > kFarthestM) return std::unexpected(FrameError::not_finite);
  out.position_m = at;
  return {};
}

Found read_handle(const json& in, Frame& out) {
  if (!in.is_object()) return std::unexpected(FrameError::wrong_type);
  const auto state = object_in(in, "state");
  if (!state) return std::unexpected(state.error());
  if (*state == nullptr) return {};
  const auto turned = object_in(**state, "orientation");
  if (!turned) return std::unexpected(turned.error());
  if (*turned != nullptr && !(*turned)->empty()) {
    const auto x = number_in(**turned, "x"), y = number_in(**turned, "y"), z = number_in(**turned, "z"),
               w = number_in(**turned, "w");
    for (const auto* each : {&x, &y, &z, &w}) {
      if (!*each) return std::unexpected(each->error());
    }
    const double length = std::sqrt(*x * *x + *y * *y + *z * *z + *w * *w);
    // All zero: the handle has not reported yet.
    if (length >= kLeastLength && length <= kMostLength) out.orientation = Quat(*w / length, *x / length, *y / length, *z / length);
  }
  const auto buttons = object_in(**state, "buttons");
  if (!buttons) return std::unexpected(buttons.error());
  if (*buttons == nullptr) return {};
  for (const auto& [key, down] : {std::pair<const char*, bool*>{"a", &out.a}, {"b", &out.b}, {"c", &out.c}}) {
    const auto at = (*buttons)->find(key);
    if (at != (*buttons)->end() && at->is_boolean()) *down = at->get<bool>();
  }
  return {};
}

Result<const json*, FrameError> list_in(const json& in, const char* key) {
  const auto at = in.find(key);
  if (at == in.end() || at->is_null()) return nullptr;
  if (!at->is_array()) return std::unexpected(FrameError::wrong_type);
  return &*at;
}

}  // namespace

Result<Frame, FrameError> parse_frame(std::string_view text) {
  if (text.size() > kMostBytes) return std::unexpected(FrameError::too_large);
  const json in = json::parse(text, nullptr, false);
  if (in.is_discarded()) return std::unexpected(FrameError::not_json);
  if (!in.is_object()) return std::unexpected(FrameError::no_object);
  Frame out;
  const auto devices = list_in(in, "inverse3");
  if (!devices) return std::unexpected(devices.error());
  if (*devices != nullptr) {
    for (const json& device : **devices) {
      if (auto read = read_device(device, out.devices.emplace_back()); !read) return std::unexpected(read.error());
    }
  }
  const auto handles = list_in(in, "wireless_verse_grip");
  if (!handles) return std::unexpected(handles.error());
  if (*handles != nullptr && !(*handles)->empty()) {
    if (auto read = read_handle((*handles)->front(), out); !read) return std::unexpected(read.error());
  }
  out.version = text_in(in, "version");
  return out;
}

std::string force_message(std::string_view device, Vec3 force_n) {
  json values = {{"x", force_n.x}, {"y", force_n.y}, {"z", force_n.z}};
  json one = {{"device_id", std::string(device)}, {"commands", {{"set_cursor_force", {{"values", std::move(values)}}}}}};
  json out;
  out["inverse3"] = json::array();
  out["inverse3"].push_back(std::move(one));
  // A device's id came from outside: what is no text in it is replaced, never thrown at.
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace cusp::device::inverse
