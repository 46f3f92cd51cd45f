#include "device/hid/settings_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

namespace cusp::device::hid {

namespace {

using nlohmann::json;

json object_of(std::string_view text) {
  json out = json::parse(text, nullptr, false);
  return out.is_object() ? out : json::object();
}

/// nullopt: no whole number, or one beyond INT64_MAX, which get() would take for a negative one.
std::optional<std::int64_t> whole_number(const json& in) {
  constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (!in.is_number_integer() || (in.is_number_unsigned() && in.get<std::uint64_t>() > kMost)) return std::nullopt;
  return in.get<std::int64_t>();
}

template <class T>
bool take(const json& in, const char* key, T& out) {
  const auto at = in.find(key);
  if (at == in.end()) return false;
  if constexpr (std::is_same_v<T, bool>) {
    if (!at->is_boolean()) return false;
    out = at->get<bool>();
  } else if constexpr (std::is_integral_v<T>) {
    const auto value = whole_number(*at);
    if (!value || *value < std::numeric_limits<T>::min() || *value > std::numeric_limits<T>::max()) return false;
    out = static_cast<T>(*value);
  } else {
    if (!at->is_number()) return false;
    out = at->template get<T>();
  }
  return true;
}

json of(const ControlId& id) { return {{"page", id.page}, {"usage", id.usage}, {"index", id.index}}; }

std::optional<ControlId> control(const json& in, const char* key) {
  const auto at = in.find(key);
  ControlId id;
  if (at == in.end() || !at->is_object() || !take(*at, "page", id.page) || !take(*at, "usage", id.usage) ||
      !take(*at, "index", id.index))
    return std::nullopt;
  return id;
}

double within(double value, double least, double most, double usual) {
  return std::isfinite(value) && value >= least && value <= most ? value : usual;
}

}  // namespace

std::string to_text(const PedalSettings& settings) {
  json out = {{"on", settings.on},
              {"vendor", settings.vendor},
              {"product", settings.product},
              {"interface", settings.interface_number},
              {"released", settings.calibration.released_raw()},
              {"pressed", settings.calibration.pressed_raw()},
              {"dead_zone", settings.calibration.dead_zone()}};
  if (settings.drill) out["drill"] = of(*settings.drill);
  if (settings.coolant) out["coolant"] = of(*settings.coolant);
  return out.dump();
}

PedalSettings pedal_settings_from(std::string_view text) {
  const json in = object_of(text);
  PedalSettings out;
  take(in, "on", out.on);
  take(in, "vendor", out.vendor);
  take(in, "product", out.product);
  take(in, "interface", out.interface_number);
  std::int32_t released = 0, pressed = 0;
  double dead_zone = -1.0;
  if (take(in, "released", released) && take(in, "pressed", pressed) && take(in, "dead_zone", dead_zone))
    out.calibration = PedalCalibration::from(released, pressed, dead_zone).value_or(out.calibration);
  out.drill = control(in, "drill");
  out.coolant = control(in, "coolant");
  return out;
}

std::string to_text(const SpaceMouseSettings& settings) {
  return json{{"on", settings.on},       {"rest", settings.rest},   {"dead_zone", settings.dead_zone},
              {"full", settings.full_scale}, {"speed", settings.speed}, {"turns", settings.turns},
              {"moves", settings.moves}}
      .dump();
}

SpaceMouseSettings space_mouse_settings_from(std::string_view text) {
  const json in = object_of(text);
  const SpaceMouseSettings usual;
  SpaceMouseSettings out;
  take(in, "on", out.on);
  take(in, "dead_zone", out.dead_zone);
  take(in, "full", out.full_scale);
  take(in, "speed", out.speed);
  take(in, "turns", out.turns);
  take(in, "moves", out.moves);
  out.dead_zone = within(out.dead_zone, 0.0, 0.4, usual.dead_zone);
  out.full_scale = within(out.full_scale, 50.0, 32767.0, usual.full_scale);
  out.speed = within(out.speed, 0.2, 3.0, usual.speed);
  const auto rest = in.find("rest");
  if (rest != in.end() && rest->is_array() && rest->size() == out.rest.size()) {
    for (std::size_t i = 0; i < out.rest.size(); ++i) {
      const auto value = whole_number((*rest)[i]);
      if (value && *value >= -1000 && *value <= 1000) out.rest[i] = static_cast<std::int16_t>(*value);
    }
  }
  return out;
}

}  // namespace cusp::device::hid
