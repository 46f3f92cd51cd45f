/// Numbers as volume files hold them, made of bytes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace cusp::scenarios {

struct SampleFormat {
  int bytes = 2;  // 1, 2, 4 or 8; of a floating one 4 or 8
  bool is_signed = false;
  bool is_float = false;
  bool big_endian = false;
};

/// Pre: `p` holds format.bytes.
inline double sample_value(const std::byte* p, SampleFormat format) noexcept {
  std::uint64_t bits = 0;
  for (int i = 0; i < format.bytes; ++i)
    bits |= static_cast<std::uint64_t>(p[format.big_endian ? format.bytes - 1 - i : i]) << (8 * i);
  if (format.is_float && format.bytes == 4) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  if (format.is_float) return std::bit_cast<double>(bits);
  if (!format.is_signed) return static_cast<double>(bits);
  if (format.bytes < 8 && (bits >> (8 * format.bytes - 1)) != 0) bits |= ~std::uint64_t{0} << (8 * format.bytes);
  return static_cast<double>(static_cast<std::int64_t>(bits));
}

/// 0xRRGGBB of three or four bytes; 0 if a fourth makes it fully transparent.
inline float colour_value(const std::byte* p, int channels) noexcept {
  if (channels == 4 && p[3] == std::byte{0}) return 0.0f;
  const auto channel = [&](int i) { return static_cast<std::uint32_t>(p[i]); };
  return static_cast<float>(channel(0) << 16 | channel(1) << 8 | channel(2));
}

}  // namespace cusp::scenarios
