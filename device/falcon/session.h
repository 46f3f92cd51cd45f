/// The driver's state machine. Pure: events and the time come in, asks to the link come out. It reads no clock, does no
/// I/O, and allocates only in give_image(). In doubt it sends zero torque.
///
///   unplugged ─ opening ─ settling ─ probing ─┬─(answer)──────────────► homing ─ ready
///       ▲                                     └─ needs_image               ▲  ◄──┘ │ homed bits missing
///       │ from anywhere: unplugged                  │ image                │       ▼ 10 ms without an answer
///       │                          arming ─ greeting ─ locking ─ uploading ─ switching ─ probing      silent
///       └─ each failed attempt closes, opens and begins again; ten make `failed`, which rests before the next ten
/// Session matches an answer to the oldest unanswered packet (in_flight.h). The answer is never older than that packet if
/// the line keeps the order, answers each packet at most once, and delays nothing beyond SessionTimes::drain. A packet
/// leaves the queue unanswered only in a drained silence, and silence ends by answers to one packet at a time. A duplicate
/// answer makes later answers look one packet younger, until an answer comes that no packet waits for.
/// Source: facts 1.4, 1.5, 1.8 to 1.10.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "device/falcon/firmware_image.h"
#include "device/falcon/ftdi.h"
#include "device/falcon/in_flight.h"
#include "device/falcon/link.h"
#include "device/falcon/protocol.h"

namespace cusp::device::falcon {

enum class Phase : std::uint8_t {
  unplugged,  // missing, or cannot be opened; Session retries
  opening,
  settling,     // line set up for running firmware
  probing,      // neutral packets: does firmware answer?
  needs_image,  // no answer, and no image was given; a packet every SessionTimes::reopen asks for an answer
  arming,       // line set up for the loader
  greeting,     // hello sent
  locking,      // the loader measures the speed
  uploading,
  switching,  // line set up for running firmware
  homing,     // exchanging, torque zero: the user pulls the grip out and pushes it in
  ready,      // exchanging, torque allowed
  silent,     // no answer: torque zero, asks for one
  failed,     // ten attempts failed: waits SessionTimes::rest, or for retry()
};
std::string_view key_of(Phase phase) noexcept;

enum class Trouble : std::uint8_t {
  none,
  absent,
  denied,
  busy,
  no_hello,  // often without power: the adapter alone feeds the processor
  no_lock,
  wrong_echo,
  no_echo,
  no_answer,  // uploaded, but the firmware does not answer
  link_failed,
  late_answers,  // each older than SessionTimes::fresh
};
std::string_view key_of(Trouble trouble) noexcept;

struct SessionTimes {
  using ms = std::chrono::milliseconds;
  LinkTime reopen = ms(500);    // between two tries to open
  LinkTime request = ms(1000);  // a vendor request takes at most this
  LinkTime probe = ms(20);      // for an answer to a neutral packet; the first is sometimes lost
  int probes = 10;
  LinkTime hello = ms(1000);
  int hellos = 3;               // in one attempt; each attempt arms the loader anew
  LinkTime echo = ms(1000);     // for the echo of one chunk
  int attempts = 10;            // first attempts often fail
  LinkTime rest = ms(5000);     // after the last attempt; the user may replug meanwhile
  LinkTime fresh = ms(7);       // an older answer gives no sample and no torque; 10 ms less three duplicates
  LinkTime late = ms(4);        // packets without an answer after this count as late: more may leave
  LinkTime check = ms(100);     // after this with packets under way: none leaves until all are answered or late
  LinkTime slow = ms(3);        // slower answers: one packet at a time, so that a duplicate shows
  LinkTime silence = ms(10);    // without a usable answer: torque zero, and the line is drained
  LinkTime drain = ms(200);     // an answer comes within this time, or never [M]
  LinkTime give_up = ms(2000);  // of silence: sets the line up again, because the adapter may have lost power
  LinkTime ramp = ms(500);      // from zero to the torque asked for
  int steady = 8;               // answers in a row with all arms homed before torque is allowed
};

struct SessionSettings {
  SessionTimes times{};
  bool event_character = false;  // the bridge forwards a reply at its '>'; not tested on a Falcon [M]
};

/// A snapshot, plain values.
struct SessionState {
  Phase phase = Phase::unplugged;
  Trouble trouble = Trouble::none;              // of the last failed attempt
  int attempt = 0;                              // failed so far
  std::uint32_t uploaded = 0, upload_size = 0;  // bytes
  std::array<std::int16_t, 3> encoders{};
  std::uint8_t buttons = 0;  // status::kPlus ...; 0 unless exchanging
  std::uint8_t homed = 0;    // status::kHomed1 ...
  std::uint64_t sent = 0, lost = 0, dropped_bytes = 0, silences = 0;
  std::uint64_t replies = 0;  // fresh answers
  std::uint64_t stale = 0;    // answers older than SessionTimes::fresh
  std::uint64_t unasked = 0;  // answers without a waiting packet
  std::uint64_t flawed = 0;   // answers in a packet whose line status reports an error
  LineErrors line{};
};

class Session {
 public:
  explicit Session(const SessionSettings& settings = {}) noexcept : settings_(settings) {}

  /// Kept for every upload to come. Not on the haptic thread.
  void give_image(FirmwareImage image) noexcept { image_ = std::move(image); }
  /// After `failed`: begins again.
  void retry() noexcept;

  /// Takes one event. Pre: `now` never decreases.
  void advance(const LinkEvent& event, LinkTime now) noexcept;
  /// The next ask for the link, in order.
  std::optional<LinkAsk> next_ask() noexcept;
  /// The latest time for the next advance(), with a `time` event if nothing else comes.
  LinkTime due() const noexcept;

  /// Departure time of the packet that the newest fresh answer belongs to.
  LinkTime asked() const noexcept { return asked_; }
  /// Whether the answer to a packet of that time may still be used.
  bool fresh(LinkTime asked, LinkTime now) const noexcept {
    return now - asked <= settings_.times.fresh;
  }
  /// Torque words for the next exchanges; taken in `ready` alone, and ramped in. They rest on the answer to the packet that
  /// left at `rests_on`: SessionTimes::fresh later they become zero.
  void command(std::array<std::int16_t, 3> counts, LinkTime rests_on) noexcept {
    if (state_.phase != Phase::ready) return;
    wanted_ = counts;
    rests_on_ = rests_on;
  }
  /// Torque words that rest on the newest fresh answer.
  void command(std::array<std::int16_t, 3> counts) noexcept { command(counts, asked_); }
  /// LEDs while ready (control::kLeds); red while homing or silent.
  void set_leds(std::uint8_t leds) noexcept { leds_ = leds & control::kLeds; }
  /// Sets the torque to zero and ramps it in again.
  void restart_ramp(LinkTime now) noexcept { ramp_from_ = now; }
  /// In homing and ready: sends one packet, unless two are unanswered besides the late ones. The pacing thread calls it
  /// once a millisecond, after advance() has taken all events of the link.
  bool exchange(LinkTime now) noexcept;

  const SessionState& state() const noexcept { return state_; }
  Phase phase() const noexcept { return state_.phase; }
  /// Torque words of the last packet that was sent.
  std::array<std::int16_t, 3> last_torque() const noexcept { return sent_torque_; }

 private:
  static constexpr std::size_t kOutbox = 8, kWindow = 2, kMostUnanswered = 12;

  void enter(Phase phase) noexcept;
  void leave_link() noexcept;
  void opened(LinkTime now) noexcept;
  void not_opened(Trouble trouble, LinkTime now) noexcept;
  void unplugged(LinkTime now) noexcept;
  void attempt_failed(Trouble trouble, LinkTime now) noexcept;
  void begin_script(Phase phase, LinkTime now) noexcept;
  void next_request(LinkTime now) noexcept;
  void request_done(LinkTime now) noexcept;
  void script_done(LinkTime now) noexcept;
  void probe(LinkTime now) noexcept;
  void probe_failed(LinkTime now) noexcept;
  void send_hello(LinkTime now) noexcept;
  void send_chunk(LinkTime now) noexcept;
  void take_transfer(std::span<const std::uint8_t> transfer, LinkTime now) noexcept;
  void received(std::span<const std::uint8_t> payload, Line line, LinkTime now) noexcept;
  void heard_loader(std::uint8_t byte, LinkTime now) noexcept;
  void echoed(std::uint8_t byte, LinkTime now) noexcept;
  void answered(const Frame& frame, LinkTime now) noexcept;
  enum class Answer : bool { unusable, usable };
  void answered_probe(Answer answer, LinkTime now) noexcept;
  void answered_silence(Answer answer) noexcept;
  void use(const Frame& frame, LinkTime asked, LinkTime now) noexcept;
  void watch(LinkTime now) noexcept;
  void forget_packets() noexcept;
  void fall_silent(LinkTime now) noexcept;
  void ask_in_silence(LinkTime now) noexcept;
  void time_passed(LinkTime now) noexcept;
  void send_frame(std::array<std::int16_t, 3> torque, std::uint8_t leds, LinkTime now) noexcept;
  void ask(const LinkAsk& ask) noexcept;
  void ask_open() noexcept;
  bool exchanging() const noexcept { return state_.phase == Phase::homing || state_.phase == Phase::ready; }

  SessionSettings settings_;
  SessionState state_;
  std::optional<FirmwareImage> image_;
  FrameParser parser_;
  bool probing_after_upload_ = false;
  std::size_t script_at_ = 0;
  bool lock_sent_ = false;              // to the loader, which answers alike
  int tries_ = 0;                       // probes or hellos so far
  std::array<std::uint8_t, 4> tail_{};  // last bytes received, compared with the answer to the hello
  std::size_t chunk_end_ = 0;           // bytes of the image sent; state_.uploaded of them were echoed
  int steady_ = 0;                      // homed answers in a row
  InFlight in_flight_;
  LinkTime busy_since_{0};  // since then a packet has been under way
  // A stall of the host counts at most kWatch between two calls.
  LinkTime watched_at_{0};
  LinkTime quiet_{0};    // watched since the last packet or answer
  LinkTime unheard_{0};  // watched since the first unanswered packet
  std::size_t late_ = 0;  // of the packets under way; they keep their places
  bool drained_ = false;  // nothing from before the silence is under way
  int zeros_ = 0;         // zero-torque packets left to send at the start of a silence
  std::uint32_t line_seen_ = 0;
  LinkTime silent_since_{0};  // no frame since
  LinkTime asked_{0}, rests_on_{0};
  LinkTime took_{0};  // round trip of the newest answer
  LinkTime ramp_from_{0};
  LinkTime due_ = LinkTime::min();
  std::array<std::int16_t, 3> wanted_{}, sent_torque_{};
  std::uint8_t leds_ = control::kBlue;
  std::array<LinkAsk, kOutbox> outbox_{};
  std::size_t outbox_at_ = 0, outbox_count_ = 0;
};

}  // namespace cusp::device::falcon
