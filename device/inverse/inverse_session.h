/// State machine of the connection to the Inverse3's service. Pure: events and time in, a message or a request to the link
/// out; no clock, no I/O.
///
///   closed ─open─► connecting ─opened─► greeting ─first place─► ready ─┬─ no place ─► silent ─ a place ─► ready
///     ▲                │ refused                                       │
///     └──── pause ◄────┴───────────────── closed, service gone ◄───────┘
///
/// No place: silence, garbage, or an answer that lists the device without its place. A handle that has reported its orientation belongs
/// to the device: without its reports there is no place either, because the bur would go on with the axis that it had.
/// The service sends one message unasked, then one in answer to each message [M]. Force is zero in every phase but ready,
/// and rises over `ramp` there. A message of zero force leaves as soon as silence begins.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "device/inverse/frames.h"
#include "device/inverse/inverse_link.h"

namespace cusp::device::inverse {

enum class Phase : std::uint8_t { closed, connecting, greeting, ready, silent, pausing };

enum class Trouble : std::uint8_t {
  none,
  no_service,    // no service listens
  no_device,     // the service has no Inverse3
  no_answer,     // connected, but no message had a position
  garbage,       // its messages cannot be parsed
  gone,          // the service or the device went away
  no_handle,     // the handle that turned the bur does not report any more
};
/// "no_service": for failures and logs.
std::string_view key_of(Trouble trouble) noexcept;

struct SessionSettings {
  std::chrono::microseconds pace{1000};    // between two messages at the least
  std::chrono::milliseconds answer{20};    // silence after a message: zero force from here on
  std::chrono::milliseconds handle{100};   // answers without the handle's orientation: it is lost from here on [M]
  std::chrono::milliseconds repeat{100};   // asks again after this
  std::chrono::milliseconds give_up{2000}; // silence: the link is closed and opened again
  std::chrono::milliseconds pause{500};    // before it is opened again
  std::chrono::milliseconds ramp{500};     // of the force: after ready begins, a stale force or ramp_from of command()
  std::chrono::milliseconds stale_force{20};  // a force that was not renewed for this long is zero
  int garbage = 50;                        // unparsable messages in a row: the link is closed and opened again
};

struct SessionState {
  Phase phase = Phase::closed;
  Trouble trouble = Trouble::none;
  std::string device;              // its id
  std::string version;             // of the service; may be empty
  bool left_handed = false;
  bool has_orientation = false;    // a handle has reported; stays so over a loss
  Reading reading;                 // newest
  std::uint64_t readings = 0, unread = 0, sent = 0, silences = 0, connections = 0;
  double force_n = 0;              // length of what was sent last
};

class Session {
 public:
  /// Without a name it takes the first device that is listed, and after a loss that one alone.
  explicit Session(const SessionSettings& settings = {}, std::string device = {});

  /// Takes one event; `time` if nothing happened.
  void advance(const LinkEvent& event, LinkTime now);
  /// Sets the force in the device's frame; ignored unless ready. The force rises from zero after `ramp_from`, the last
  /// time without a force, and after commands that paused for longer than stale_force.
  void command(Vec3 force_n, LinkTime now, LinkTime ramp_from = {}) noexcept;

  enum class LinkRequest : std::uint8_t { none, open, close };
  /// Returns each request once.
  LinkRequest take_request(LinkTime now) noexcept;
  /// The message that is due, if one is.
  std::optional<std::string> take_message(LinkTime now);
  /// The latest time for the next advance().
  LinkTime due() const noexcept;
  /// A message of zero force, to send before closing.
  std::optional<std::string> closing_message() const;

  const SessionState& state() const noexcept { return state_; }

 private:
  void enter(Phase phase, LinkTime now) noexcept;
  void take_text(std::string_view text, LinkTime now);
  void lose(Trouble trouble, LinkTime now) noexcept;
  Vec3 ramped(LinkTime now) const noexcept;

  SessionSettings settings_;
  std::string wanted_;  // id; empty until the first device was ready
  SessionState state_;
  LinkRequest request_ = LinkRequest::open;
  bool others_ = false;  // the service has devices, but not the wanted one
  Vec3 force_n_{0.0};
  LinkTime force_at_{}, ramp_from_{}, since_{}, received_{}, asked_{}, turned_{};
  bool awaits_answer_ = false, ask_ = false;
  int garbage_ = 0;
};

}  // namespace cusp::device::inverse
