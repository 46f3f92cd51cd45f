#include "device/falcon/emulated_falcon_port.h"

#include <vector>

namespace cusp::device {

namespace {

using falcon::LinkTime;

constexpr double kLeadMPerTick = 0.0015;  // 1.5 m/s at 1 kHz

/// The smallest image that passes the check: one block of zeros. The emulated processor counts its words and runs none.
falcon::FirmwareImage dummy_image() {
  constexpr std::size_t kWords = 2048;
  std::vector<std::uint8_t> bytes{0xAA, 0x08};
  bytes.resize(2 + 2 * 8);
  const auto word = [&bytes](unsigned value) {
    bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
  };
  word(0x003F);
  word(0x8002);
  word(kWords);
  word(0x003F);
  word(0x8000);
  for (std::size_t i = 0; i <= kWords; ++i) word(0);
  return *falcon::FirmwareImage::from_bytes(std::move(bytes));
}

FalconSettings driver_of(const EmulatedFalconSettings& settings) {
  FalconSettings out;
  out.workspace.origin_mm = settings.start_mm;
  out.workspace.scale = settings.scale;
  out.name = "Emulated Falcon";
  out.device_class = "emulated-falcon";
  out.closed_loop = settings.closed_loop;
  return out;
}

falcon::EmulatorSettings device_of(const EmulatedFalconSettings& settings) {
  falcon::EmulatorSettings out = settings.device;
  out.firmware_running = !settings.cold;
  return out;
}

falcon::Workspace workspace_of(const FalconSettings& driver) {
  if (const auto wanted = falcon::Workspace::from(driver.workspace)) return *wanted;
  return *falcon::Workspace::from({});
}

}  // namespace

EmulatedFalconPort::EmulatedFalconPort(EmulatedHand hand, const EmulatedFalconSettings& settings)
    : hand_(std::move(hand)),
      settings_(settings),
      workspace_(workspace_of(driver_of(settings))),
      falcon_(device_of(settings)),
      link_(new falcon::EmulatedLink(falcon_, falcon::EmulatedLinkSettings{.time = settings.time})),
      port_(std::unique_ptr<falcon::FalconLink>(link_), driver_of(settings)) {
  if (settings.cold) port_.give_image(dummy_image());
}

Result<void, PortFailure> EmulatedFalconPort::open() {
  if (auto opened = port_.open(); !opened) return opened;
  // Homing: out to 0.170 m and in to 0.080 m, once a second, until a sample is fresh.
  constexpr int kMostTicks = 5000;
  constexpr double kIn = 0.080, kOut = 0.170, kStep = 0.00018;
  double z = falcon_.grip_m().z, step = kStep;
  Sample sample;
  for (int tick = 0; tick < kMostTicks && sample.status != Sample::Status::fresh; ++tick) {
    z += step;
    if (z > kOut || z < kIn) step = -step;
    falcon_.set_grip({0.0, 0.0, z});
    sample = port_.wait(std::chrono::steady_clock::time_point(link_->now() + std::chrono::milliseconds(1)));
    port_.write({});
  }
  if (sample.status != Sample::Status::fresh) {
    port_.close();
    return fail(PortError::io, link_->name(), "not_homed");
  }
  // Then to the start of the hand, no faster than a hand: the driver rejects jumps.
  hand_mm_ = hand_(felt_, 0.0).position_mm;
  for (int tick = 0; tick < kMostTicks && !lead(kLeadMPerTick); ++tick) {
    sample = port_.wait(std::chrono::steady_clock::time_point(link_->now() + std::chrono::milliseconds(1)));
    port_.write({});
  }
  felt_ = Feedback{};
  felt_.proxy_mm = settings_.start_mm;
  before_ = link_->now();
  return {};
}

bool EmulatedFalconPort::lead(double most_m) noexcept {
  const Vec3 to = workspace_.grip_m(hand_mm_), way = to - falcon_.grip_m();
  const double length = glm::length(way);
  falcon_.set_grip(length > most_m ? falcon_.grip_m() + way * (most_m / length) : to);
  return length <= most_m;
}

Sample EmulatedFalconPort::wait(std::chrono::steady_clock::time_point deadline) noexcept {
  const LinkTime now = link_->now();
  const EmulatedHandPose pose = hand_(felt_, std::chrono::duration<double>(now - before_).count());
  before_ = now;
  hand_mm_ = pose.position_mm;
  lead(kLeadMPerTick);
  falcon_.set_buttons(pose.cut ? FalconButtons{}.cut : 0);
  Sample sample = port_.wait(deadline);
  sample.bur = pose.bur;
  return sample;
}

void EmulatedFalconPort::write(const Feedback& feedback) noexcept {
  felt_ = feedback;
  port_.write(feedback);
}

}  // namespace cusp::device
