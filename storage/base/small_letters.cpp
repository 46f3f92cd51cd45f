#include "storage/base/small_letters.h"

namespace cusp::storage {
namespace {

/// Below U+0800. Source: Unicode, UnicodeData.txt, simple lowercase mappings.
constexpr unsigned small_of(unsigned c) noexcept {
  const auto within = [c](unsigned first, unsigned last) { return c >= first && c <= last; };
  if (within('A', 'Z') || within(0xC0, 0xD6) || within(0xD8, 0xDE)) return c + 0x20;
  if (c == 0x130) return 'i';  // capital I with a dot
  if (c == 0x178) return 0xFF;
  if (within(0x100, 0x137) || within(0x14A, 0x177)) return c | 1;
  if (within(0x139, 0x148) || within(0x179, 0x17E)) return c + (c & 1);
  if (c == 0x386) return 0x3AC;  // Greek with an accent
  if (within(0x388, 0x38A)) return c + 0x25;
  if (c == 0x38C) return 0x3CC;
  if (within(0x38E, 0x38F)) return c + 0x3F;
  if (c == 0x3C2) return 0x3C3;  // sigma at a word's end: both have one capital
  if (within(0x391, 0x3AB) || within(0x410, 0x42F)) return c + 0x20;
  if (within(0x400, 0x40F)) return c + 0x50;
  return c;
}

}  // namespace

std::string small_letters(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto first = static_cast<unsigned char>(text[i]);
    const auto second = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    const bool pair = (first & 0xE0) == 0xC0 && (second & 0xC0) == 0x80;
    const unsigned c = small_of(pair ? (first & 0x1Fu) << 6 | (second & 0x3Fu) : first);
    if (!pair && first >= 0x80) {
      out += text[i];
      continue;
    }
    if (c < 0x80) {
      out += static_cast<char>(c);
    } else {
      out += static_cast<char>(0xC0 | c >> 6);
      out += static_cast<char>(0x80 | (c & 0x3F));
    }
    if (pair) ++i;
  }
  return out;
}

}  // namespace cusp::storage
