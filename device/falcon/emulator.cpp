#include "device/falcon/emulator.h"

#include <algorithm>
#include <cmath>

namespace cusp::device::falcon {

namespace {

constexpr double kRunBaud = 1.5e6, kHelloBaud = 9600;
constexpr std::uint8_t kModemIdle = 0x01, kLineIdle = 0x60, kOverrun = 0x02, kFraming = 0x08;
constexpr LinkTime kFetched = std::chrono::milliseconds(1);
constexpr std::uint16_t kKey = 0x08AA;
constexpr std::size_t kHeaderWords = 11;  // key, eight reserved, entry point

LinkTime byte_time(double baud) noexcept { return LinkTime(static_cast<std::int64_t>(10e9 / baud)); }  // 8N1: ten bits

}  // namespace

Emulator::Emulator(const EmulatorSettings& settings) noexcept : settings_(settings), last_packet_(LinkTime::min()) {
  set_grip(settings.grip_m);
  if (settings.powered) restore_power();
  if (settings.powered && settings.firmware_running) stage_ = Stage::running;
}

Vec3 Emulator::true_ticks() const noexcept { return ticks_; }

void Emulator::forget() noexcept {
  parser_.reset();
  words_ = {};
  control_bits_ = 0;
  homed_ = 0;
  hello_ = {};
}

void Emulator::cut_power() noexcept {
  stage_ = Stage::off;
  forget();
}

void Emulator::restore_power() noexcept {
  if (stage_ != Stage::off) return;
  stage_ = Stage::waiting;
  forget();
  zero_ticks_ = true_ticks();  // encoders count from wherever the arms stand
}

void Emulator::lose_homing() noexcept {
  homed_ = 0;
  zero_ticks_ = true_ticks();
}

void Emulator::set_grip(Vec3 grip_m) noexcept {
  const auto legs = inverse(settings_.geometry, grip_m);
  if (!legs) return;
  const auto rows = jacobian(settings_.geometry, *legs);
  if (!rows) return;
  const Vec3 before = ticks_;
  grip_m_ = grip_m;
  rows_ = *rows;
  ticks_ = ticks_of_arm_rad(settings_.geometry, settings_.calibration, legs->arm_rad);
  if (stage_ != Stage::running || (control_bits_ & control::kHoming) == 0) return;
  for (int i = 0; i < 3; ++i) {
    const bool passed = (before[i] < settings_.mark_tick) != (ticks_[i] < settings_.mark_tick);
    if (!passed) continue;
    homed_ = static_cast<std::uint8_t>(homed_ | (status::kHomed1 << i));
    zero_ticks_[i] = 0.0;
  }
}

std::array<std::int16_t, 3> Emulator::torque_words(LinkTime now) const noexcept {
  if (stage_ != Stage::running || now - words_at_ > settings_.torque_hold) return {};
  return words_;
}

Vec3 Emulator::force_n(LinkTime now) const noexcept {
  return device::falcon::force_n(rows_, torque_of_counts(settings_.calibration, torque_words(now)));
}

void Emulator::set_dtr(bool high) noexcept {
  const bool edge = high && !dtr_;
  dtr_ = high;
  if (stage_ == Stage::off) return;
  if (edge) {
    stage_ = Stage::armed;  // resets the processor: firmware and homing are gone
    forget();
    zero_ticks_ = true_ticks();
  } else if (!high && stage_ == Stage::greeted) {
    stage_ = Stage::loader;
    loader_baud_ = 0;
    loaded_bytes_ = header_words_ = address_words_ = 0;
    block_left_ = loaded_words_ = 0;
    loaded_blocks_ = 0;
    in_block_ = false;
  }
}

bool Emulator::control(FtdiRequest request, LinkTime now) noexcept {
  if (request.request == refuse_) return false;
  switch (request.request) {
    case 0x00:
      if (request.value > 2) return false;
      if (request.value == 0) set_dtr(false);
      line_count_ = 0;  // whichever purge it is: sent twice, both buffers are empty
      return true;
    case 0x01:
      if ((request.value & 0x0100) != 0) set_dtr((request.value & 1) != 0);
      return (request.value & 0x0300) != 0;
    case 0x02:
      return true;
    case 0x03:
      if (baud_of(request.value) <= 0) return false;
      if (!stick_speed_) baud_ = baud_of(request.value);
      return true;
    case 0x04:
      return true;
    case 0x06:
      event_character_ = (request.value & 0x0100) != 0 ? request.value & 0xFF : -1;
      return true;
    case 0x09:
      if (request.value < 1 || request.value > 255) return false;
      latency_ = std::chrono::milliseconds(request.value);
      last_packet_ = std::max(last_packet_, now - latency_);
      return true;
    default:
      return false;
  }
}

void Emulator::write(std::span<const std::uint8_t> bytes, LinkTime now) noexcept {
  host_line_free_ = std::max(host_line_free_, now);
  for (const std::uint8_t byte : bytes) {
    if (!settings_.at_once) host_line_free_ += byte_time(baud_);
    take(byte, host_line_free_);
  }
}

void Emulator::put(std::uint8_t byte, LinkTime earliest, double baud) noexcept {
  device_line_free_ = std::max(device_line_free_, earliest);
  if (!settings_.at_once) device_line_free_ += byte_time(baud);
  if (line_count_ == kLine) {
    overrun_ = true;
    return;
  }
  const bool broken = !same_speed(baud);  // sent at a speed that the bridge is not listening at
  line_[(line_at_ + line_count_) % kLine] = {device_line_free_, broken ? static_cast<std::uint8_t>(byte ^ 0xA9) : byte,
                                             broken};
  ++line_count_;
}

void Emulator::take(std::uint8_t byte, LinkTime at) noexcept {
  switch (stage_) {
    case Stage::armed:
      take_hello(byte, at);
      break;
    case Stage::loader:
      // The loader measures whatever speed the first 'A' comes at.
      if (byte == 0x41) {
        loader_baud_ = baud_;
        stage_ = Stage::loading;
        put(byte, at, loader_baud_);
      }
      break;
    case Stage::loading:
      load(byte, at);
      break;
    case Stage::running:
      if (!same_speed(kRunBaud)) break;
      if (const auto frame = parser_.push(byte)) answer(*frame, at);
      break;
    case Stage::off:
    case Stage::waiting:
    case Stage::greeted:
    case Stage::hung:
      break;
  }
}

void Emulator::take_hello(std::uint8_t byte, LinkTime at) noexcept {
  if (!same_speed(kHelloBaud)) return;
  std::copy(hello_.begin() + 1, hello_.end(), hello_.begin());
  hello_.back() = byte;
  if (hello_ != std::array<std::uint8_t, 3>{0x0A, 0x43, 0x0D}) return;
  hello_ = {};
  if (ignore_hellos_ > 0) {
    --ignore_hellos_;
    return;
  }
  stage_ = Stage::greeted;
  for (const std::uint8_t part : {0x00, 0x0A, 0x44, 0x2C, 0x0D}) put(part, at, kHelloBaud);  // with the stray 00
}

void Emulator::load(std::uint8_t byte, LinkTime at) noexcept {
  if (!same_speed(loader_baud_)) return;
  const std::size_t index = loaded_bytes_++;
  if (index == swallow_echo_at_) {
    swallow_echo_at_ = SIZE_MAX;
    stage_ = Stage::hung;
    return;
  }
  const bool spoilt = index == spoil_echo_at_;
  if (spoilt) spoil_echo_at_ = SIZE_MAX;
  put(spoilt ? static_cast<std::uint8_t>(byte ^ 0x10) : byte, at, loader_baud_);
  if (index % 2 == 0) {
    low_byte_ = byte;
  } else {
    load_word(static_cast<std::uint16_t>(low_byte_ | byte << 8));
  }
}

void Emulator::load_word(std::uint16_t word) noexcept {
  if (header_words_ < kHeaderWords) {
    if (header_words_ == 0 && word != kKey) stage_ = Stage::hung;
    ++header_words_;
  } else if (!in_block_) {
    if (word == 0) {
      stage_ = hang_after_load_ || loaded_blocks_ == 0 ? Stage::hung : Stage::running;
      forget();
      return;
    }
    in_block_ = true;
    block_left_ = word;
    address_words_ = 2;
  } else if (address_words_ > 0) {
    --address_words_;
  } else {
    ++loaded_words_;
    if (--block_left_ == 0) {
      in_block_ = false;
      ++loaded_blocks_;
    }
  }
}

void Emulator::answer(const Frame& frame, LinkTime at) noexcept {
  ++frames_;
  words_ = frame.words;
  words_at_ = at;
  control_bits_ = frame.bits;
  if (mute_) return;
  if (lose_ > 0) {
    --lose_;
    return;
  }
  Frame out;
  for (int i = 0; i < 3; ++i) {
    const double count = std::clamp(std::round(ticks_[i] - zero_ticks_[i]), -32768.0, 32767.0);
    out.words[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(count);
  }
  out.bits = buttons_;
  if ((control_bits_ & control::kHoming) != 0) out.bits = static_cast<std::uint8_t>(out.bits | homed_);
  auto bytes = encode(out);
  if (spoil_ > 0) {
    --spoil_;
    bytes[5] = 0x7A;
  }
  std::size_t size = bytes.size();
  if (cut_ > 0) {
    --cut_;
    size = std::min(size, cut_bytes_);
  }
  const LinkTime ready = settings_.at_once ? at : at + settings_.answer_delay;
  for (std::size_t i = 0; i < size; ++i) put(bytes[i], ready, kRunBaud);
}

LinkTime Emulator::next_read() const noexcept {
  LinkTime when = LinkTime::max();
  const LinkTime timer = last_packet_ == LinkTime::min() ? LinkTime::min() : last_packet_ + latency_;
  if (settings_.at_once) return line_count_ > 0 ? line_[line_at_].at : when;
  if (settings_.status_packets) when = timer;
  for (std::size_t i = 0; i < line_count_ && i < kPayloadBytes; ++i) {
    const LineByte& byte = line_[(line_at_ + i) % kLine];
    if (i == 0) when = std::min(when, std::max(timer, byte.at));
    if (byte.byte == event_character_ || i + 1 == kPayloadBytes) when = std::min(when, byte.at);
  }
  return when;
}

std::size_t Emulator::read(std::span<std::uint8_t, kPacketBytes> out, LinkTime now) noexcept {
  const LinkTime ready = next_read();
  if (ready > now) return 0;
  // The chip closed the packet when it was ready. If the host did not fetch it within kFetched, it kept filling.
  const LinkTime closed = std::max(ready, now - kFetched);
  out[0] = kModemIdle;
  out[1] = kLineIdle;
  if (overrun_) out[1] |= kOverrun;
  overrun_ = false;
  std::size_t size = kStatusBytes;
  while (size < kPacketBytes && line_count_ > 0 && line_[line_at_].at <= closed) {
    if (line_[line_at_].broken) out[1] |= kFraming;
    out[size++] = line_[line_at_].byte;
    line_at_ = (line_at_ + 1) % kLine;
    --line_count_;
  }
  last_packet_ = closed;
  return size;
}

}  // namespace cusp::device::falcon
