/// The emulated Falcon as a FalconLink. Its clock advances only while the driver waits (tests, sessions without a window),
/// or is the real one. One thread; another may set grip and buttons.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "device/falcon/emulator.h"
#include "device/falcon/link.h"
#include "engine/base/triple_buffer.h"

namespace cusp::device::falcon {

enum class Presence : std::uint8_t { here, absent, denied, busy };

enum class EmulatedTime : std::uint8_t {
  stands,  // advances by waiting alone
  runs,    // steady_clock
};

struct EmulatedLinkSettings {
  EmulatedTime time = EmulatedTime::stands;
  LinkTime start = std::chrono::hours(-1);  // of a standing clock: opening happens before time 0
  LinkTime transfer = std::chrono::microseconds(130);  // of a packet to the driver, about a microframe
  LinkTime jitter{0};                                  // random addition, at most this
  std::uint64_t seed = 1;
  std::string name = "emulated";
  bool by_port = false;  // has no serial number
};

/// Grip and buttons, written by another thread.
struct EmulatedGrip {
  Vec3 grip_m{0.0};
  std::uint8_t buttons = 0;
  bool set = false;
};

class EmulatedLink final : public FalconLink {
 public:
  /// Pre: `falcon` outlives the link; another link can open it afterwards.
  EmulatedLink(Emulator& falcon, const EmulatedLinkSettings& settings = {}) noexcept;

  LinkTime now() const noexcept override;
  void start(const LinkAsk& ask) noexcept override;
  LinkEvent wait(LinkTime until) noexcept override;
  std::string name() const override { return opened_once_ ? settings_.name : std::string(); }
  bool known_by_port() const noexcept override { return opened_once_ && settings_.by_port; }

  Emulator& falcon() noexcept { return falcon_; }

  // The device's end of the cable; the link's own thread.
  void set_presence(Presence presence) noexcept;
  Presence presence() const noexcept { return presence_; }
  /// Unplugs after so many more asks.
  void unplug_after(int asks) noexcept { unplug_after_ = asks; }
  int asks() const noexcept { return asks_; }
  /// Makes sends of the host fail while the device stays connected.
  void fail_sends(bool fail) noexcept { fail_sends_ = fail; }

  /// Any one other thread.
  void set_grip(const EmulatedGrip& grip) noexcept { grip_.write(grip); }

  /// Called with the time whenever the clock has advanced, for a hand that shares it.
  void on_time(std::function<void(LinkTime)> tick) { tick_ = std::move(tick); }

 private:
  void push(LinkEvent::Kind kind) noexcept;
  void move_to(LinkTime when) noexcept;
  LinkTime next_packet() noexcept;

  static constexpr std::size_t kEvents = 16;
  Emulator& falcon_;
  EmulatedLinkSettings settings_;
  LinkTime now_;
  Presence presence_ = Presence::here;
  bool open_ = false, opened_once_ = false, fail_sends_ = false;
  int unplug_after_ = -1, asks_ = 0;
  std::array<LinkEvent::Kind, kEvents> events_{};
  std::size_t event_at_ = 0, event_count_ = 0;
  std::array<std::uint8_t, kPacketBytes> packet_{};
  LinkTime delay_{0};  // of the packet that comes next
  std::uint64_t random_;
  TripleBuffer<EmulatedGrip> grip_;
  std::function<void(LinkTime)> tick_;
};

}  // namespace cusp::device::falcon
