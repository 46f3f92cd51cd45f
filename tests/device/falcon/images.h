/// Boot images made up for tests: the right shape, no firmware of anybody.
#pragma once

#include <cstdint>
#include <vector>

namespace cusp::test {

/// Blocks of so many words each, filled from a counter so that a shifted echo shows.
inline std::vector<std::uint8_t> boot_image(const std::vector<std::uint32_t>& block_words = {100, 1500, 900}) {
  std::vector<std::uint8_t> out;
  const auto word = [&out](std::uint32_t value) {
    out.push_back(static_cast<std::uint8_t>(value & 0xFF));
    out.push_back(static_cast<std::uint8_t>((value >> 8) & 0xFF));
  };
  word(0x08AA);
  for (int i = 0; i < 8; ++i) word(0);
  word(0x003F);
  word(0x8002);  // the entry point that all known images have
  std::uint32_t to = 0x3F8000, fill = 0x1234;
  for (const std::uint32_t size : block_words) {
    word(size);
    word(to >> 16);
    word(to & 0xFFFF);
    for (std::uint32_t i = 0; i < size; ++i) word(fill = (fill * 25173 + 13849) & 0xFFFF);
    to += size;
  }
  word(0);
  return out;
}

}  // namespace cusp::test
