// Phases, exchanges and timeouts. session_start.cpp has the way from plugged in to answering.
#include "device/falcon/session.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace cusp::device::falcon {

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
                                        "no_lock", "wrong_echo", "no_echo", "no_answer", "link_failed",
                                        "late_answers"};
  return kKeys[static_cast<std::size_t>(trouble)];
}

void Session::ask(const LinkAsk& wanted) noexcept {
  // Asks wait for their answers, so that the outbox holds few. A dropped ask runs into its time-out: the attempt fails,
  // and the torque is zero.
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
  const bool watches = exchanging() && !in_flight_.empty();
  return watches ? std::min(due_, watched_at_ + kWatch) : due_;
}

void Session::retry() noexcept {
  if (state_.phase != Phase::failed) return;
  state_.attempt = 0;  // `trouble` stays until an attempt succeeds
  state_.phase = Phase::unplugged;
  due_ = LinkTime::min();
}

void Session::unplugged(LinkTime now) noexcept {
  not_opened(Trouble::absent, now);
  state_.attempt = 0;  // the next device counts as new
  ask({.kind = LinkAsk::Kind::close});
}

void Session::send_frame(std::array<std::int16_t, 3> torque, std::uint8_t leds, LinkTime now) noexcept {
  // The homing bit stays set: without it the device does not report the homed bits.
  ask(LinkAsk::of_bytes(encode({torque, static_cast<std::uint8_t>(control::kHoming | leds)})));
  sent_torque_ = torque;
  ++state_.sent;
  if (in_flight_.empty()) busy_since_ = now;
  in_flight_.sent(now);
  quiet_ = LinkTime(0);
}

void Session::forget_packets() noexcept {
  state_.lost += in_flight_.forget();
  unheard_ = LinkTime(0);
  late_ = 0;
}

bool Session::exchange(LinkTime now) noexcept {
  if (!exchanging() || in_flight_.count() >= std::min(kWindow + late_, kMostUnanswered)) return false;
  if (took_ >= settings_.times.slow && (in_flight_.count() > late_ || quiet_ < settings_.times.fresh)) return false;
  // A pause shows whether answers are missing.
  if (in_flight_.count() > late_ && now - busy_since_ >= settings_.times.check) return false;
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
  // A late packet was probably lost: the round trip is measured on the packets after it, freshness on the oldest.
  if (in_flight_.count() > late_) took_ = now - in_flight_.sent_at(late_);
  const std::optional<LinkTime> asked = in_flight_.answered();
  late_ = std::min(late_, in_flight_.count());
  if (in_flight_.count() == late_) busy_since_ = now;
  silent_since_ = now;
  const bool flawed = parser_.flawed();
  const bool in_time = asked && fresh(*asked, now);
  const bool usable = in_time && !flawed;
  if (usable) unheard_ = LinkTime(0);
  state_.flawed += flawed;
  state_.unasked += !asked;
  state_.stale += asked && !in_time;
  const bool probes = state_.phase == Phase::probing || state_.phase == Phase::needs_image;
  if (probes && !flawed) return answered_probe(in_time ? Answer::usable : Answer::unusable, now);
  if (state_.phase == Phase::silent) return answered_silence(usable ? Answer::usable : Answer::unusable);
  if (!exchanging()) return;
  if (!asked) return fall_silent(now);  // a duplicate: later answers may have looked too young
  if (usable) use(frame, *asked, now);
}

void Session::answered_probe(Answer answer, LinkTime now) noexcept {
  state_.trouble = Trouble::none;
  state_.attempt = 0;
  const bool first = state_.phase == Phase::probing && answer == Answer::usable && in_flight_.empty() && tries_ == 1;
  enter(Phase::homing);
  due_ = kNever;
  if (!first) fall_silent(now);
}

void Session::answered_silence(Answer answer) noexcept {
  if (!drained_) return;
  drained_ = answer == Answer::usable;
  steady_ = drained_ ? steady_ + 1 : 0;
  if (steady_ < settings_.times.steady) return;
  // The device answers again; homing checks the homed bits anew.
  enter(Phase::homing);
  due_ = kNever;
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
    send_frame(kNoTorque, control::kRed, now);  // without waiting for the next tick
  }
}

void Session::watch(LinkTime now) noexcept {
  const LinkTime watched = std::min(now - watched_at_, kWatch);
  watched_at_ = now;
  quiet_ += watched;
  if (exchanging() && !in_flight_.empty()) unheard_ += watched;
}

void Session::fall_silent(LinkTime now) noexcept {
  enter(Phase::silent);
  ++state_.silences;
  wanted_ = kNoTorque;
  parser_.reset();
  silent_since_ = now;
  drained_ = false;
  zeros_ = kZeros - 1;
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
  // One packet at a time; the next leaves after `fresh` without a second answer.
  const bool answered = drained_ && in_flight_.empty();
  if (quiet_ < (answered ? settings_.times.fresh : settings_.times.drain)) return;
  if (!answered) steady_ = 0;
  forget_packets();
  drained_ = true;
  send_frame(kNoTorque, control::kRed, now);
}

void Session::take_transfer(std::span<const std::uint8_t> transfer, LinkTime now) noexcept {
  const auto reported = [this] { return std::exchange(line_seen_, state_.line.spoilt()) != state_.line.spoilt(); };
  strip_status(transfer, state_.line, [&](std::span<const std::uint8_t> payload) {
    received(payload, reported() ? Line::flawed : Line::clean, now);
  });
  if (reported()) parser_.flaw();  // an error in a packet without payload
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
      case Phase::needs_image:
      case Phase::homing:
      case Phase::ready:
      case Phase::silent:
        if (const auto frame = parser_.push(byte, line)) answered(*frame, now);
        break;
      default:
        break;  // leftover bytes while the line is set up
    }
  }
  state_.dropped_bytes = parser_.dropped_bytes();
}

void Session::time_passed(LinkTime now) noexcept {
  if (exchanging()) {
    if (unheard_ >= settings_.times.silence) return fall_silent(now);
    if (!in_flight_.empty() && quiet_ >= settings_.times.late) {
      late_ = in_flight_.count();
      busy_since_ = now;
    }
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
        // Only the line may have stood still: its firmware then answers again.
        forget_packets();
        send_frame(kNoTorque, control::kRed, now);
        due_ = now + settings_.times.reopen;
      }
      break;
    case Phase::greeting:
      send_hello(now);
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

}  // namespace cusp::device::falcon
