/// Lower-case hex of bytes. Pure; any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace cusp::storage {

std::string hex_of(std::span<const std::uint8_t> bytes);
/// False, and `out` in any state, unless `hex` is exactly two characters of lower-case hex for each byte.
[[nodiscard]] bool bytes_from_hex(std::string_view hex, std::span<std::uint8_t> out) noexcept;

}  // namespace cusp::storage
