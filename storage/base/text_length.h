/// Lengths of typed texts as people count them: in characters (code points of UTF-8), not in bytes. Pure; any thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace cusp::storage {

/// Whether the text has `least` to `most` characters. The limit of bytes bounds what is no UTF-8.
[[nodiscard]] constexpr bool has_length(std::string_view text, std::size_t least, std::size_t most) noexcept {
  constexpr std::size_t kMostBytes = 4;  // of a character. Source: RFC 3629
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  const auto length = static_cast<std::size_t>(std::ranges::count_if(text, begins));
  return length >= least && length <= most && text.size() <= kMostBytes * most;
}

}  // namespace cusp::storage
