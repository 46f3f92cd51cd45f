#include "device/falcon/protocol.h"

#include <algorithm>
#include <utility>

namespace cusp::device::falcon {

namespace {

constexpr std::uint8_t kStart = 0x3C, kEnd = 0x3E, kZero = 0x41;
constexpr std::size_t kBitsAt = 13, kUnknownAt = 14, kEndAt = 15;

bool nibble(std::uint8_t byte) noexcept { return byte >= kZero && byte <= kZero + 15; }

/// Whether the byte is valid at that position of a frame.
bool fits(std::size_t at, std::uint8_t byte) noexcept {
  if (at == 0) return byte == kStart;
  if (at == kEndAt) return byte == kEnd;
  if (at == kBitsAt) return byte >= kZero && byte <= kZero + 127;
  return nibble(byte);
}

}  // namespace

std::array<std::uint8_t, kFrameBytes> encode(const Frame& frame) noexcept {
  std::array<std::uint8_t, kFrameBytes> out{};
  out[0] = kStart;
  std::size_t at = 1;
  for (const std::int16_t word : frame.words) {
    const auto value = static_cast<std::uint16_t>(word);
    for (int shift = 0; shift < 16; shift += 4) out[at++] = static_cast<std::uint8_t>(kZero + ((value >> shift) & 0xF));
  }
  out[kBitsAt] = static_cast<std::uint8_t>(kZero + (frame.bits & 0x7F));
  out[kUnknownAt] = kZero;
  out[kEndAt] = kEnd;
  return out;
}

std::optional<Frame> decode(std::span<const std::uint8_t, kFrameBytes> bytes) noexcept {
  for (std::size_t i = 0; i < kFrameBytes; ++i) {
    if (!fits(i, bytes[i])) return std::nullopt;
  }
  Frame frame;
  std::size_t at = 1;
  for (std::int16_t& word : frame.words) {
    unsigned value = 0;
    for (int shift = 0; shift < 16; shift += 4) value |= static_cast<unsigned>(bytes[at++] - kZero) << shift;
    word = static_cast<std::int16_t>(static_cast<std::uint16_t>(value));
  }
  frame.bits = static_cast<std::uint8_t>(bytes[kBitsAt] - kZero);
  return frame;
}

void FrameParser::drop_to_next_start() noexcept {
  // The buffer's first byte begins no frame: continues at the next byte whose followers all fit.
  std::size_t from = 1;
  for (; from < size_; ++from) {
    bool good = true;
    for (std::size_t i = from; i < size_ && good; ++i) good = fits(i - from, buffer_[i]);
    if (good) break;
  }
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(from), buffer_.begin() + static_cast<std::ptrdiff_t>(size_),
            buffer_.begin());
  dropped_ += from;
  size_ -= from;
  if (size_ == 0) flawed_ = false;
}

std::optional<Frame> FrameParser::push(std::uint8_t byte, Line line) noexcept {
  buffer_[size_++] = byte;
  if (line == Line::flawed) flawed_ = true;
  if (!fits(size_ - 1, byte)) {
    drop_to_next_start();
    return std::nullopt;
  }
  if (size_ < kFrameBytes) return std::nullopt;
  size_ = 0;
  last_flawed_ = std::exchange(flawed_, false);
  return decode(buffer_);
}

}  // namespace cusp::device::falcon
