/// The Falcon's run-time frames, the same format both ways: '<', three 16-bit words as nibbles, a byte of bits, a byte of
/// unknown meaning, '>'. Pure: bytes in, frames out. No allocation, no clock. Source: facts 1.8.
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

/// Bits that the device sends. It reports the homed bits only in homing mode.
namespace status {
inline constexpr std::uint8_t kPlus = 0x01, kForward = 0x02, kCentre = 0x04, kMinus = 0x08;
inline constexpr std::uint8_t kButtons = kPlus | kForward | kCentre | kMinus;
inline constexpr std::uint8_t kHomed1 = 0x10, kHomed2 = 0x20, kHomed3 = 0x40;
inline constexpr std::uint8_t kHomed = kHomed1 | kHomed2 | kHomed3;
}  // namespace status

/// Largest torque command observed from the maker's software, in counts.
inline constexpr std::int16_t kMaxTorqueCounts = 4095;

/// Cuts `bits` to 7 bits.
std::array<std::uint8_t, kFrameBytes> encode(const Frame& frame) noexcept;

/// Exactly one frame, or nullopt: '<' and '>' at their places, nibbles within 'A'..'P', bits within 0..127.
std::optional<Frame> decode(std::span<const std::uint8_t, kFrameBytes> bytes) noexcept;

/// Line status of the bridge for received bytes.
enum class Line : std::uint8_t { clean, flawed };

/// Finds frames in a stream. It drops and counts bytes that belong to no frame, one by one: a fragment never counts as a
/// frame, and never hides the next one.
class FrameParser {
 public:
  /// The next byte; the frame that it completes, if it does.
  std::optional<Frame> push(std::uint8_t byte, Line line = Line::clean) noexcept;
  /// Marks an unfinished frame as flawed: the line reported an error after its bytes.
  void flaw() noexcept { flawed_ = size_ > 0; }
  /// Whether the last frame from push() holds a byte of a flawed line.
  bool flawed() const noexcept { return last_flawed_; }
  /// Drops an unfinished frame: after a purge, a silence, or a change of speed.
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
