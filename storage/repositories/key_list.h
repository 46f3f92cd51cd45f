/// Keys in one column of text, with a space between two. Within storage/repositories only.
#pragma once

#include <sstream>
#include <string>
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

}  // namespace cusp::storage
