/// A 64-bit hash that is the same on every machine: integers only, eight bytes at a time, little-endian by value.
/// For equality of volumes and states; content that must withstand forgery is hashed in storage and scenarios.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>

namespace cusp::engine {

class Hash64 {
 public:
  void add(std::uint64_t word) noexcept {
    state_ ^= word;
    state_ *= 0x9E3779B97F4A7C15ull;
    state_ ^= state_ >> 29;
    state_ *= 0xBF58476D1CE4E5B9ull;
    state_ ^= state_ >> 32;
  }
  void add_double(double value) noexcept {
    if (value == 0.0) value = 0.0;  // -0 and +0 are one place
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, 8);
    add(bits);
  }
  void add_u16(std::span<const std::uint16_t> values) noexcept {
    const std::uint16_t* at = values.data();
    for (std::size_t left = values.size() / 4; left > 0; --left, at += 4) {
      add(std::uint64_t{at[0]} | std::uint64_t{at[1]} << 16 | std::uint64_t{at[2]} << 32 | std::uint64_t{at[3]} << 48);
    }
    for (std::size_t left = values.size() % 4; left > 0; --left) add(*at++);
  }
  std::uint64_t value() const noexcept { return state_; }

 private:
  std::uint64_t state_ = 0x243F6A8885A308D3ull;
};

}  // namespace cusp::engine
