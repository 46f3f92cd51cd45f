/// Emulates a Falcon at the level of bytes: the bridge (speeds, buffer, latency timer), the loader (handshake, echo), the
/// firmware (frames), arms that find zero when they pass their marks, and motors whose torque ends without new packets.
/// Time is an argument. One thread; no allocation after construction. It behaves as facts/falcon.md describes, and is no
/// evidence that a real Falcon does.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "device/falcon/kinematics.h"
#include "device/falcon/link.h"
#include "device/falcon/protocol.h"

namespace cusp::device::falcon {

struct EmulatorSettings {
  bool powered = true;            // the adapter; the bridge itself lives from USB
  bool firmware_running = false;  // left by an earlier program
  bool status_packets = true;     // two status bytes at each expiry of the latency timer, as the chip does
  bool at_once = false;           // no line and no timer: each answer is there at once
  LinkTime answer_delay = std::chrono::microseconds(60);  // firmware: frame in to frame out [M]
  LinkTime torque_hold = std::chrono::milliseconds(20);   // torque without a packet; never measured on a Falcon [M]
  double mark_tick = 0.0;                                 // where each arm's index lies, in true ticks [M]
  Vec3 grip_m{0.0, 0.0, 0.100};                           // at power-up: leaning back, arms in
  Geometry geometry{};
  Calibration calibration{};
};

class Emulator {
 public:
  explicit Emulator(const EmulatorSettings& settings = {}) noexcept;

  // The USB side.
  /// False: the bridge refuses the request (a stall).
  bool control(FtdiRequest request, LinkTime now) noexcept;
  void write(std::span<const std::uint8_t> bytes, LinkTime now) noexcept;
  /// A packet for the host, status bytes first, if one is due; its size, else 0.
  std::size_t read(std::span<std::uint8_t, kPacketBytes> out, LinkTime now) noexcept;
  /// When read() has something, LinkTime::max() if never as things stand.
  LinkTime next_read() const noexcept;

  // The hand's side.
  /// Ignored where the legs do not reach. Arms that pass their mark while homing mode is on are homed.
  void set_grip(Vec3 grip_m) noexcept;
  Vec3 grip_m() const noexcept { return grip_m_; }
  void set_buttons(std::uint8_t bits) noexcept { buttons_ = bits & status::kButtons; }
  /// What the motors do to the grip now (N).
  Vec3 force_n(LinkTime now) const noexcept;
  std::array<std::int16_t, 3> torque_words(LinkTime now) const noexcept;
  std::uint8_t leds() const noexcept { return control_bits_ & control::kLeds; }
  std::uint8_t homed() const noexcept { return homed_; }
  bool firmware_running() const noexcept { return stage_ == Stage::running; }
  std::uint64_t frames() const noexcept { return frames_; }
  /// Words that the loader received in blocks, and the number of blocks.
  std::uint32_t loaded_words() const noexcept { return loaded_words_; }
  int loaded_blocks() const noexcept { return loaded_blocks_; }

  // Faults.
  void cut_power() noexcept;  // the adapter: firmware and homing are lost
  void restore_power() noexcept;
  void lose_homing() noexcept;
  void lose_answers(int count) noexcept { lose_ = count; }
  void spoil_answers(int count) noexcept { spoil_ = count; }
  void cut_answers(int count, std::size_t bytes) noexcept { cut_ = count, cut_bytes_ = bytes; }
  void fall_mute(bool mute) noexcept { mute_ = mute; }
  void ignore_hellos(int count) noexcept { ignore_hellos_ = count; }
  void spoil_echo_at(std::size_t byte) noexcept { spoil_echo_at_ = byte; }  // of the image, once
  void swallow_echo_at(std::size_t byte) noexcept { swallow_echo_at_ = byte; }
  void hang_after_load(bool hang) noexcept { hang_after_load_ = hang; }
  void stick_speed(bool stick) noexcept { stick_speed_ = stick; }    // the bridge takes divisors and ignores them
  void refuse(std::uint8_t request) noexcept { refuse_ = request; }  // stalls this request until 0xFF is set

 private:
  enum class Stage : std::uint8_t { off, waiting, armed, greeted, loader, loading, running, hung };
  struct LineByte {
    LinkTime at{0};
    std::uint8_t byte = 0;
    bool broken = false;
  };

  void take(std::uint8_t byte, LinkTime at) noexcept;
  void take_hello(std::uint8_t byte, LinkTime at) noexcept;
  void load(std::uint8_t byte, LinkTime at) noexcept;
  void load_word(std::uint16_t word) noexcept;
  void answer(const Frame& frame, LinkTime at) noexcept;
  void put(std::uint8_t byte, LinkTime earliest, double baud) noexcept;
  void set_dtr(bool high) noexcept;
  void forget() noexcept;
  Vec3 true_ticks() const noexcept;
  bool same_speed(double baud) const noexcept { return baud_ > baud * 0.97 && baud_ < baud * 1.03; }

  static constexpr std::size_t kLine = 1024;

  EmulatorSettings settings_;
  Stage stage_ = Stage::off;
  // Bridge.
  double baud_ = 9600;
  LinkTime latency_ = std::chrono::milliseconds(16);  // the chip's own default
  LinkTime last_packet_{0}, host_line_free_ = LinkTime::min(), device_line_free_ = LinkTime::min();
  int event_character_ = -1;
  bool dtr_ = false;
  std::array<LineByte, kLine> line_{};
  std::size_t line_at_ = 0, line_count_ = 0;
  bool overrun_ = false;
  // Loader.
  std::array<std::uint8_t, 3> hello_{};
  double loader_baud_ = 0;
  std::size_t loaded_bytes_ = 0;
  std::uint8_t low_byte_ = 0;
  std::size_t header_words_ = 0, address_words_ = 0;
  std::uint32_t block_left_ = 0, loaded_words_ = 0;
  int loaded_blocks_ = 0;
  bool in_block_ = false;
  // Firmware.
  FrameParser parser_;
  std::array<std::int16_t, 3> words_{};
  LinkTime words_at_{0};
  std::uint8_t control_bits_ = 0, homed_ = 0, buttons_ = 0;
  std::uint64_t frames_ = 0;
  // Mechanism.
  Vec3 grip_m_{0.0}, ticks_{0.0}, zero_ticks_{0.0};
  Jacobian rows_{};
  // Faults.
  int lose_ = 0, spoil_ = 0, cut_ = 0, ignore_hellos_ = 0;
  std::size_t cut_bytes_ = 0;
  std::size_t spoil_echo_at_ = SIZE_MAX, swallow_echo_at_ = SIZE_MAX;
  bool mute_ = false, hang_after_load_ = false, stick_speed_ = false;
  std::uint8_t refuse_ = 0xFF;
};

}  // namespace cusp::device::falcon
