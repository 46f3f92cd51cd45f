// The phases, the exchanges and what time means for them. How a Falcon comes to answer is in session_start.cpp.
#include "device/falcon/session.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace cusp::falcon {

namespace {

constexpr LinkTime kNever = LinkTime::max();
constexpr std::array<std::int16_t, 3> kNoTorque{};
constexpr LinkTime kWatch = std::chrono::milliseconds(2);
constexpr LinkTime kZeroPace = std::chrono::milliseconds(1);
constexpr int kZeros = 3;  // of which one may be lost

}  // namespace

std::string_view key_of(Phase phase) noexcept {
  constexpr std::string_view kKeys[] = {"unplugged", "opening",  "settling", "probing",   "needs_image",
                                        "arming",    "greeting", "locking",  "uploading", "switching",
                                        "homing",    "ready",    "silent",   "failed"};
  return kKeys[static_cast<std::size_t>(phase)];
}

std::string_view key_of(Trouble trouble) noexcept {
  constexpr std::string_view kKeys[] = {"none",    "absent",     "denied",  "busy",      "no_hello",
                                        "no_lock", "wrong_echo", "no_echo", "no_answer", "link_failed"};
  return kKeys[static_cast<std::size_t>(trouble)];
}

void Session::ask(const LinkAsk& wanted) noexcept {
  // Asks wait for their answers, so that the outbox holds a handful at most. One that does not fit would be lost, and
  // whoever waits for it runs into its time-out: the attempt fails, torque is zero.
  if (outbox_count_ == kOutbox) return;
  outbox_[(outbox_at_ + outbox_count_) % kOutbox] = wanted;
  ++outbox_count_;
}

std::optional<LinkAsk> Session::next_ask() noexcept {
  if (outbox_count_ == 0) return std::nullopt;
  const LinkAsk out = outbox_[outbox_at_];
  outbox_at_ = (outbox_at_ + 1) % kOutbox;
  --outbox_count_;
  return out;
}

void Session::enter(Phase phase) noexcept {
  state_.phase = phase;
  steady_ = 0;
  if (phase != Phase::homing && phase != Phase::ready) {
    state_.buttons = 0;
    state_.homed = 0;
  }
}

void Session::leave_link() noexcept {
  outbox_count_ = 0;
  forget_packets();
  parser_.reset();
  sent_torque_ = kNoTorque;
  probing_after_upload_ = false;
  state_.uploaded = state_.upload_size = 0;
}

LinkTime Session::due() const noexcept {
  const bool watches = pause_ > LinkTime(0) || (exchanging() && !in_flight_.empty());
  return watches ? std::min(due_, watched_at_ + kWatch) : due_;
}

void Session::retry() noexcept {
  if (state_.phase != Phase::failed) return;
  state_.attempt = 0;  // what went wrong last stays to be read until something goes right
  state_.phase = Phase::unplugged;
  due_ = LinkTime::min();
}

void Session::unplugged(LinkTime now) noexcept {
  not_opened(Trouble::absent, now);
  state_.attempt = 0;  // whatever comes back is a new device
  ask({.kind = LinkAsk::Kind::close});
}

void Session::send_frame(std::array<std::int16_t, 3> torque, std::uint8_t leds, LinkTime now) noexcept {
  // The homing bit stays on all the time: without it the homed bits are not reported.
  ask(LinkAsk::of_bytes(encode({torque, static_cast<std::uint8_t>(control::kHoming | leds)})));
  sent_torque_ = torque;
  ++state_.sent;
  if (in_flight_.empty()) busy_since_ = now;
  in_flight_.sent(now);
  quiet_ = LinkTime(0);
}

void Session::forget_packets() noexcept {
  state_.lost += in_flight_.forget();
  pause_ = unheard_ = LinkTime(0);
  doubt_ = false;
}

bool Session::exchange(LinkTime now) noexcept {
  if (!exchanging() || pause_ > LinkTime(0) || in_flight_.count() >= (one_by_one() ? 1 : kWindow)) return false;
  // Whether an answer was lost or is late shows when nothing is sent meanwhile: end_pause() ends it.
  if (!in_flight_.empty() &&
      (now - in_flight_.oldest() >= settings_.times.lost || now - busy_since_ >= settings_.times.check)) {
    return false;
  }
  if (state_.phase == Phase::homing) {
    send_frame(kNoTorque, control::kRed, now);
    return true;
  }
  if (!fresh(rests_on_, now)) {
    wanted_ = kNoTorque;
    ramp_from_ = now;
  }
  const double share = std::clamp(
      static_cast<double>((now - ramp_from_).count()) / static_cast<double>(settings_.times.ramp.count()), 0.0, 1.0);
  std::array<std::int16_t, 3> torque{};
  for (std::size_t i = 0; i < 3; ++i) {
    const int word = std::clamp<int>(wanted_[i], -kMaxTorqueCounts, kMaxTorqueCounts);
    torque[i] = static_cast<std::int16_t>(std::lround(share * word));
  }
  send_frame(torque, leds_, now);
  return true;
}

void Session::answered(const Frame& frame, LinkTime now) noexcept {
  const std::optional<LinkTime> asked = in_flight_.answered();
  silent_since_ = now;
  const bool flawed = parser_.flawed();
  const bool usable = asked && fresh(*asked, now);
  if (usable && !flawed) unheard_ = LinkTime(0);
  if (asked) take_age(now - *asked);
  state_.flawed += flawed;
  state_.unasked += !asked;
  state_.stale += asked && !usable;
  if (state_.phase == Phase::probing && !flawed) return answered_probe(usable);
  if (state_.phase == Phase::silent) return answered_silence(usable && !flawed, now, asked ? now - *asked : LinkTime(0));
  if (!exchanging()) return;
  if (!asked) return answered_too_often(now);
  if (one_by_one()) pause(took_ >= settings_.times.slow ? given_up_after() : settings_.times.proof);
  if (doubt_) return;
  if (usable && !flawed) use(frame, *asked, now);
}

void Session::take_age(LinkTime age) noexcept {
  // What a stall of the host adds is no matter of the line's. Falls to a half within five answers.
  took_ = std::max(std::min(age, settings_.times.fresh), took_ - took_ / 8);
}

LinkTime Session::given_up_after() const noexcept {
  return std::max(settings_.times.lost, settings_.times.lost_ages * took_);
}

/// One came that had been given up, or one came twice: what was used since may be older than it seemed.
void Session::answered_too_often(LinkTime now) noexcept {
  doubt_ = true;
  take_age(std::max(now - given_up_, settings_.times.fresh / 2));
  not_before_ = now;
  wary_until_ = now + settings_.times.wary;
  steady_ = 0;
  pause(std::max(pause_, given_up_after()));
}

void Session::answered_probe(bool usable) noexcept {
  state_.trouble = Trouble::none;
  state_.attempt = 0;
  const bool first = usable && in_flight_.empty() && tries_ == 1;
  enter(Phase::homing);
  due_ = kNever;
  if (!first) pause(settings_.times.drain);
}

void Session::answered_silence(bool usable, LinkTime now, LinkTime age) noexcept {
  if (!drained_) return;
  if (usable && ++steady_ >= settings_.times.steady) {
    // Answers again; whether the arms are still homed is asked anew.
    enter(Phase::homing);
    pause(LinkTime(0));
    wary_until_ = now + settings_.times.wary;
    due_ = kNever;
  } else if (usable) {
    pause(settings_.times.resync);
  } else {
    steady_ = 0;
    drained_ = false;
    drain_ = std::min(std::max(drain_, 2 * age), settings_.times.drain_most);
    pause(drain_);
  }
}

void Session::use(const Frame& frame, LinkTime asked, LinkTime now) noexcept {
  const auto homed = static_cast<std::uint8_t>(frame.bits & status::kHomed);
  ++state_.replies;
  asked_ = asked;
  state_.encoders = frame.words;
  state_.buttons = frame.bits & status::kButtons;
  state_.homed = homed;
  if (state_.phase == Phase::homing) {
    steady_ = homed == status::kHomed ? steady_ + 1 : 0;
    if (steady_ < settings_.times.steady) return;
    enter(Phase::ready);
    wanted_ = kNoTorque;
    rests_on_ = asked;
    ramp_from_ = now;
  } else if (homed != status::kHomed) {
    enter(Phase::homing);
    wanted_ = kNoTorque;
    send_frame(kNoTorque, control::kRed, now);  // at once, not with the next tick
  }
}

void Session::watch(LinkTime now) noexcept {
  const LinkTime watched = std::min(now - watched_at_, kWatch);
  watched_at_ = now;
  quiet_ += watched;
  if (exchanging() && !in_flight_.empty()) unheard_ += watched;
}

void Session::end_pause(LinkTime now) noexcept {
  const LinkTime lost = given_up_after();
  const bool late = !in_flight_.empty() && now - in_flight_.oldest() >= lost && quiet_ >= lost;
  const bool quiet = pause_ > LinkTime(0) && quiet_ >= pause_;
  if (!late && !quiet) return;
  doubt_ = !in_flight_.empty();
  // On a line that is slow besides, only a long pause tells lost from late.
  if (doubt_ && took_ >= settings_.times.slow) return fall_silent(now);
  if (doubt_) {
    given_up_ = in_flight_.oldest();
    wary_until_ = now + settings_.times.wary;
  }
  state_.lost += in_flight_.forget();
  pause_ = LinkTime(0);
}

void Session::fall_silent(LinkTime now) noexcept {
  enter(Phase::silent);
  ++state_.silences;
  forget_packets();
  wanted_ = kNoTorque;
  parser_.reset();
  silent_since_ = now;
  drain_ = settings_.times.drain;
  drained_ = false;
  zeros_ = kZeros - 1;
  pause(drain_);
  send_frame(kNoTorque, control::kRed, now);
  due_ = now + kZeroPace;
}

void Session::ask_in_silence(LinkTime now) noexcept {
  due_ = now + kZeroPace;
  if (zeros_ > 0) {
    --zeros_;
    send_frame(kNoTorque, control::kRed, now);
    return;
  }
  if (quiet_ < pause_) return;
  if (drained_ && !in_flight_.empty()) {
    // Longer than the pause, or lost.
    drain_ = std::min(2 * drain_, settings_.times.drain_most);
    steady_ = 0;
  }
  forget_packets();
  drained_ = true;
  send_frame(kNoTorque, control::kRed, now);
  pause(drain_);
}

void Session::take_transfer(std::span<const std::uint8_t> transfer, LinkTime now) noexcept {
  const auto reported = [this] { return std::exchange(line_seen_, state_.line.spoilt()) != state_.line.spoilt(); };
  strip_status(transfer, state_.line, [&](std::span<const std::uint8_t> payload) {
    received(payload, reported() ? Line::flawed : Line::clean, now);
  });
  if (reported()) parser_.flaw();  // in a packet that has nothing but its status
}

void Session::received(std::span<const std::uint8_t> payload, Line line, LinkTime now) noexcept {
  quiet_ = LinkTime(0);
  for (const std::uint8_t byte : payload) {
    switch (state_.phase) {
      case Phase::greeting:
      case Phase::locking:
      case Phase::uploading:
        heard_loader(byte, now);
        break;
      case Phase::probing:
      case Phase::homing:
      case Phase::ready:
      case Phase::silent:
        if (const auto frame = parser_.push(byte, line)) answered(*frame, now);
        break;
      default:
        break;  // left over from before: the line is being set up
    }
  }
  state_.dropped_bytes = parser_.dropped_bytes();
}

void Session::time_passed(LinkTime now) noexcept {
  if (exchanging()) {
    if (unheard_ >= settings_.times.silence) return fall_silent(now);
    end_pause(now);
  }
  if (now < due_) return;
  switch (state_.phase) {
    case Phase::unplugged:
      ask_open();
      break;
    case Phase::settling:
    case Phase::arming:
    case Phase::switching:
      attempt_failed(Trouble::link_failed, now);
      break;
    case Phase::probing:
      probe(now);
      break;
    case Phase::needs_image:
      if (image_) {
        begin_script(Phase::arming, now);
      } else {
        due_ = now + settings_.times.reopen;
      }
      break;
    case Phase::greeting:
      say_hello(now);
      break;
    case Phase::locking:
      attempt_failed(lock_sent_ ? Trouble::no_lock : Trouble::link_failed, now);
      break;
    case Phase::uploading:
      attempt_failed(Trouble::no_echo, now);
      break;
    case Phase::silent:
      if (now - silent_since_ >= settings_.times.give_up) {
        begin_script(Phase::settling, now);
      } else {
        ask_in_silence(now);
      }
      break;
    case Phase::failed:
      retry();
      ask_open();
      break;
    case Phase::opening:
    case Phase::homing:
    case Phase::ready:
      due_ = kNever;
      break;
  }
}

void Session::advance(const LinkEvent& event, LinkTime now) noexcept {
  watch(now);
  switch (event.kind) {
    case LinkEvent::Kind::time:
      break;
    case LinkEvent::Kind::opened:
      if (state_.phase == Phase::opening) opened(now);
      break;
    case LinkEvent::Kind::absent:
      if (state_.phase == Phase::opening) not_opened(Trouble::absent, now);
      break;
    case LinkEvent::Kind::denied:
      if (state_.phase == Phase::opening) not_opened(Trouble::denied, now);
      break;
    case LinkEvent::Kind::busy:
      if (state_.phase == Phase::opening) not_opened(Trouble::busy, now);
      break;
    case LinkEvent::Kind::control_done:
      request_done(now);
      break;
    case LinkEvent::Kind::failed:
      if (state_.phase != Phase::unplugged && state_.phase != Phase::failed && state_.phase != Phase::opening) {
        attempt_failed(Trouble::link_failed, now);
      }
      break;
    case LinkEvent::Kind::received:
      take_transfer(event.bytes, now);
      break;
    case LinkEvent::Kind::gone:
      if (state_.phase != Phase::unplugged && state_.phase != Phase::failed) unplugged(now);
      break;
  }
  time_passed(now);
}

}  // namespace cusp::falcon
