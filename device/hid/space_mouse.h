/// 3Dconnexion's reports as a motion of the hand. Pure; time is an argument.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

namespace cusp::device::hid {

/// Six-axis devices of 3Dconnexion, by their numbers.
bool is_space_mouse(std::uint16_t vendor, std::uint16_t product) noexcept;

/// -1 to 1 each; x right, y up, z to the user; rotations right-handed about the same axes.
struct SpaceMouseMotion {
  std::array<double, 3> move{}, turn{};
  std::uint32_t buttons = 0;  // bit 0: left
  bool still() const noexcept { return move == std::array<double, 3>{} && turn == std::array<double, 3>{}; }
  friend bool operator==(const SpaceMouseMotion&, const SpaceMouseMotion&) = default;
};

struct SpaceMouseSettings {
  bool on = true;
  std::array<std::int16_t, 6> rest{};  // raw values with the hand off: tx ty tz rx ry rz
  double dead_zone = 0.08;             // share of the full deflection, 0 to 0.4
  double full_scale = 350.0;           // raw value of a full deflection
  double speed = 1.0;                  // 0.2 to 3: of what it drives
  bool turns = true, moves = true;     // which half is used
  friend bool operator==(const SpaceMouseSettings&, const SpaceMouseSettings&) = default;
};

class SpaceMouseState {
 public:
  using Time = std::chrono::steady_clock::time_point;
  /// A deflected device reports every 8 to 16 ms: silence this long counts as released.
  static constexpr std::chrono::milliseconds kSilence{200};

  /// A report, number first. False, and no change, for an unknown report. No allocation.
  bool take(std::span<const std::uint8_t> report, Time now) noexcept;
  /// Released, no button down: the device was lost.
  void release() noexcept;

  const std::array<std::int16_t, 6>& raw() const noexcept { return raw_; }
  SpaceMouseMotion motion(const SpaceMouseSettings& settings, Time now) const noexcept;
  std::optional<int> battery_percent() const noexcept { return battery_; }

 private:
  std::array<std::int16_t, 6> raw_{};
  std::uint32_t buttons_ = 0;
  std::optional<int> battery_;
  Time moved_{};
};

}  // namespace cusp::device::hid
