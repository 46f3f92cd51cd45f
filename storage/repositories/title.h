/// Text by language as JSON, for the tables that keep titles. Within storage only.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/format/scenario.h"
#include "storage/modules.h"

namespace cusp::storage {

inline std::string title_to_json(const LocalText& title) {
  return nlohmann::json(title).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}
/// Empty for anything but an object of texts.
inline LocalText title_from_json(const std::string& text) {
  LocalText out;
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return out;
  for (const auto& [language, value] : json.items()) {
    if (value.is_string()) out[language] = value.get<std::string>();
  }
  return out;
}

}  // namespace cusp::storage
