// The phases, the exchanges and what time means for them. How a Falcon comes to answer is in session_start.cpp.
#include "device/falcon/session.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace cusp::falcon {

namespace {

constexpr LinkTime kNever = LinkTime::max();
constexpr std::array<std::int16_t, 3> kNoTorque{};
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
  unanswered_count_ = 0;
  full_ = 0;
  waiting_since_.reset();
  parser_.reset();
  sent_torque_ = kNoTorque;
  probing_after_upload_ = false;
  state_.uploaded = state_.upload_size = 0;
}

LinkTime Session::due() const noexcept {
  if (!exchanging() || !waiting_since_) return due_;
  return std::min(due_, *waiting_since_ + settings_.times.silence);
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
  if (unanswered_count_ == kWindow) {
    std::copy(unanswered_.begin() + 1, unanswered_.end(), unanswered_.begin());
    --unanswered_count_;
    ++state_.lost;
  }
  if (unanswered_count_ == 0) busy_since_ = now;
  unanswered_[unanswered_count_++] = now;
  if (!waiting_since_) waiting_since_ = now;
}

bool Session::exchange(LinkTime now) noexcept {
  if (!exchanging()) return false;
  while (unanswered_count_ > 0 && now - unanswered_[0] >= settings_.times.lost) {
    std::copy(unanswered_.begin() + 1, unanswered_.end(), unanswered_.begin());
    --unanswered_count_;
    ++state_.lost;
  }
  // A lost answer leaves its place taken, each later answer being counted for the packet before its own. A window that
  // is full again and again without being empty for so long gives that place back.
  constexpr int kFullTooOften = 4;
  if (unanswered_count_ == kWindow) {
    if (++full_ < kFullTooOften || now - busy_since_ < settings_.times.lost) return false;
    full_ = 0;
  }
  if (state_.phase == Phase::homing) {
    send_frame(kNoTorque, control::kRed, now);
    return true;
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
  ++state_.replies;
  waiting_since_.reset();
  if (unanswered_count_ > 0) {
    std::copy(unanswered_.begin() + 1, unanswered_.end(), unanswered_.begin());
    --unanswered_count_;
  }
  if (unanswered_count_ == 0) full_ = 0;
  const auto homed = static_cast<std::uint8_t>(frame.bits & status::kHomed);
  switch (state_.phase) {
    case Phase::probing:
      state_.trouble = Trouble::none;
      state_.attempt = 0;
      enter(Phase::homing);
      due_ = kNever;
      break;
    case Phase::silent:
      // Answers again; whether the arms are still homed is asked anew.
      if (++steady_ >= settings_.times.steady) {
        enter(Phase::homing);
        due_ = kNever;
      }
      return;
    case Phase::homing:
      steady_ = homed == status::kHomed ? steady_ + 1 : 0;
      if (steady_ >= settings_.times.steady) {
        enter(Phase::ready);
        wanted_ = kNoTorque;
        ramp_from_ = now;
      }
      break;
    case Phase::ready:
      if (homed != status::kHomed) {
        enter(Phase::homing);
        wanted_ = kNoTorque;
        send_frame(kNoTorque, control::kRed, now);  // at once, not with the next tick
      }
      break;
    default:
      return;
  }
  state_.encoders = frame.words;
  state_.buttons = frame.bits & status::kButtons;
  state_.homed = homed;
}

void Session::fall_silent(LinkTime now) noexcept {
  enter(Phase::silent);
  ++state_.silences;
  state_.lost += unanswered_count_;
  unanswered_count_ = 0;
  full_ = 0;
  waiting_since_.reset();
  wanted_ = kNoTorque;
  parser_.reset();
  silent_since_ = now;
  send_frame(kNoTorque, control::kRed, now);
  due_ = now + settings_.times.resync;
}

void Session::received(std::span<const std::uint8_t> payload, LinkTime now) noexcept {
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
        if (const auto frame = parser_.push(byte)) answered(*frame, now);
        break;
      default:
        break;  // left over from before: the line is being set up
    }
  }
  state_.dropped_bytes = parser_.dropped_bytes();
}

void Session::time_passed(LinkTime now) noexcept {
  if (exchanging() && waiting_since_ && now - *waiting_since_ >= settings_.times.silence) return fall_silent(now);
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
        send_frame(kNoTorque, control::kRed, now);
        due_ = now + settings_.times.resync;
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
      strip_status(event.bytes, state_.line,
                   [this, now](std::span<const std::uint8_t> payload) { received(payload, now); });
      break;
    case LinkEvent::Kind::gone:
      if (state_.phase != Phase::unplugged && state_.phase != Phase::failed) unplugged(now);
      break;
  }
  time_passed(now);
}

}  // namespace cusp::falcon
