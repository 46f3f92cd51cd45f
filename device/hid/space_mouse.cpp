#include "device/hid/space_mouse.h"

#include <algorithm>
#include <cmath>

namespace cusp::device::hid {

namespace {

constexpr std::uint8_t kMoveReport = 0x01, kTurnReport = 0x02, kButtonReport = 0x03, kBatteryReport = 0x17;

std::int16_t word(std::span<const std::uint8_t> report, std::size_t at) noexcept {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(report[at] | report[at + 1] << 8));
}

}  // namespace

bool is_space_mouse(std::uint16_t vendor, std::uint16_t product) noexcept {
  if (vendor == 0x046d) {
    constexpr std::uint16_t kLogitech[] = {0xc603, 0xc605, 0xc606, 0xc621, 0xc623, 0xc625,
                                           0xc626, 0xc627, 0xc628, 0xc629, 0xc62b};
    return std::ranges::find(kLogitech, product) != std::end(kLogitech);
  }
  constexpr std::uint16_t kOwn[] = {0xc62e, 0xc62f, 0xc631, 0xc632, 0xc633, 0xc635,
                                    0xc636, 0xc638, 0xc63a, 0xc641, 0xc652};
  return vendor == 0x256f && std::ranges::find(kOwn, product) != std::end(kOwn);
}

bool SpaceMouseState::take(std::span<const std::uint8_t> report, Time now) noexcept {
  if (report.empty()) return false;
  switch (report[0]) {
    case kMoveReport:
      if (report.size() < 7) return false;
      for (std::size_t i = 0; i < 3; ++i) raw_[i] = word(report, 1 + 2 * i);
      if (report.size() >= 13) {  // the models without a second report
        for (std::size_t i = 0; i < 3; ++i) raw_[3 + i] = word(report, 7 + 2 * i);
      }
      moved_ = now;
      return true;
    case kTurnReport:
      if (report.size() < 7) return false;
      for (std::size_t i = 0; i < 3; ++i) raw_[3 + i] = word(report, 1 + 2 * i);
      moved_ = now;
      return true;
    case kButtonReport: {
      if (report.size() < 2) return false;
      std::uint32_t buttons = 0;
      for (std::size_t i = 1; i < std::min<std::size_t>(report.size(), 5); ++i)
        buttons |= static_cast<std::uint32_t>(report[i]) << (8 * (i - 1));
      buttons_ = buttons;
      return true;
    }
    case kBatteryReport:
      if (report.size() < 2 || report[1] > 100) return false;
      battery_ = report[1];
      return true;
    default: return false;
  }
}

void SpaceMouseState::release() noexcept {
  raw_ = {};
  buttons_ = 0;
  battery_.reset();
  moved_ = {};
}

SpaceMouseMotion SpaceMouseState::motion(const SpaceMouseSettings& settings, Time now) const noexcept {
  SpaceMouseMotion out;
  if (!settings.on) return out;
  out.buttons = buttons_;
  if (now - moved_ > kSilence) return out;
  const auto share = [&](std::size_t i) {
    const double full = std::max(settings.full_scale, 1.0);
    const double s = std::clamp((static_cast<double>(raw_[i]) - settings.rest[i]) / full, -1.0, 1.0);
    const double beyond = std::abs(s) - settings.dead_zone;
    return beyond <= 0 ? 0.0 : std::copysign(std::min(beyond / (1.0 - settings.dead_zone), 1.0), s);
  };
  // The device's x is right, y to the user, z down: here y is up and z to the user.
  if (settings.moves) out.move = {share(0), -share(2), share(1)};
  if (settings.turns) out.turn = {share(3), -share(5), share(4)};
  for (double& v : out.move) v += 0.0;  // no negative zero
  for (double& v : out.turn) v += 0.0;
  return out;
}

}  // namespace cusp::device::hid
