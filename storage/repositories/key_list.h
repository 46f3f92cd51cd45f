/// Keys in one column of text, with a space between two; the form of a device class. Within storage/repositories only.
#pragma once

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace cusp::storage {

inline std::string joined_keys(const std::vector<std::string>& keys) {
  std::string out;
  for (const std::string& key : keys) out += (out.empty() ? "" : " ") + key;
  return out;
}

inline std::vector<std::string> split_keys(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> out;
  for (std::string key; in >> key;) out.push_back(key);
  return out;
}

/// 1 to 64 of a-z, 0-9 and -.
inline bool is_device_class(const std::string& key) {
  constexpr std::string_view kSigns = "abcdefghijklmnopqrstuvwxyz0123456789-";
  return !key.empty() && key.size() <= 64 && key.find_first_not_of(kSigns) == std::string::npos;
}

}  // namespace cusp::storage
