/// The Falcon's run-time frames, both ways the same shape: '<', three 16-bit words as nibbles, a byte of bits, a byte
/// that nobody explained, '>'. Pure: bytes in, frames out. No allocation, no clock. Source: facts 1.8.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace cusp::device::falcon {

inline constexpr std::size_t kFrameBytes = 16;

/// One frame. Host to device: torque commands and control bits. Device to host: encoder counts and status bits.
/// Order of the words: arm 1 (top), 2 (right), 3 (left), seen from the front.
struct Frame {
  std::array<std::int16_t, 3> words{};
  std::uint8_t bits = 0;  // 0 to 127; the wire adds 0x41
  friend bool operator==(const Frame&, const Frame&) = default;
};

/// Bits that the host sends.
namespace control {
inline constexpr std::uint8_t kHoming = 0x01, kGreen = 0x02, kBlue = 0x04, kRed = 0x08;
inline constexpr std::uint8_t kLeds = kGreen | kBlue | kRed;
}  // namespace control

/// Bits that the device sends. The homed bits are reported only while homing mode is on.
namespace status {
inline constexpr std::uint8_t kPlus = 0x01, kForward = 0x02, kCentre = 0x04, kMinus = 0x08;
inline constexpr std::uint8_t kButtons = kPlus | kForward | kCentre | kMinus;
inline constexpr std::uint8_t kHomed1 = 0x10, kHomed2 = 0x20, kHomed3 = 0x40;
inline constexpr std::uint8_t kHomed = kHomed1 | kHomed2 | kHomed3;
}  // namespace status

/// The largest torque command that the maker's own software was seen to send, in counts.
inline constexpr std::int16_t kMaxTorqueCounts = 4095;

/// Pre: bits <= 127 (higher ones are cut off).
std::array<std::uint8_t, kFrameBytes> encode(const Frame& frame) noexcept;

/// Exactly one frame, or nothing: '<' and '>' at their places, nibbles within 'A'..'P', bits within 0..127.
std::optional<Frame> decode(std::span<const std::uint8_t, kFrameBytes> bytes) noexcept;

/// What the bridge reports of the line that bytes came over.
enum class Line : std::uint8_t { clean, flawed };

/// Finds frames in a stream that arrives in pieces. What is no frame is dropped byte by byte and counted, so that a
/// fragment is never taken for a frame and never hides the one after it.
class FrameParser {
 public:
  /// The next byte; the frame that it completes, if it does.
  std::optional<Frame> push(std::uint8_t byte, Line line = Line::clean) noexcept;
  /// The line reports an error after the bytes so far: a frame that is begun is flawed.
  void flaw() noexcept { flawed_ = size_ > 0; }
  /// Whether the frame that push() returned last has a byte of a flawed line, however well it is formed.
  bool flawed() const noexcept { return last_flawed_; }
  /// Forgets what is begun: after a purge, a silence, a change of speed.
  void reset() noexcept {
    size_ = 0;
    flawed_ = false;
  }
  std::uint64_t dropped_bytes() const noexcept { return dropped_; }

 private:
  void drop_to_next_start() noexcept;

  std::array<std::uint8_t, kFrameBytes> buffer_{};
  std::size_t size_ = 0;
  std::uint64_t dropped_ = 0;
  bool flawed_ = false, last_flawed_ = false;
};

}  // namespace cusp::device::falcon
