// Session from plugged in to answering: line set-up request by request, hello to the loader, firmware upload and its echo.
// session.cpp has the exchanges.
#include <algorithm>
#include <span>

#include "device/falcon/session.h"

namespace cusp::device::falcon {

namespace {

constexpr std::uint8_t kHello[] = {0x0A, 0x43, 0x0D};
constexpr std::array<std::uint8_t, 4> kHelloAnswer = {0x0A, 0x44, 0x2C, 0x0D};
constexpr std::uint8_t kLock = 0x41;  // 'A': the loader measures its bits

// The requests of each phase, in order. DTR and RTS are left alone but for the loader: the edge of DTR arms it.
constexpr FtdiRequest kSettle[] = {ftdi::kPurge1,  ftdi::kPurge2, ftdi::kLatency1ms,
                                   ftdi::kBaudRun, ftdi::kPurge1, ftdi::kPurge2};
constexpr FtdiRequest kArm[] = {ftdi::kPurge1,        ftdi::kPurge2, ftdi::kLatency16ms, ftdi::kBaudHello, ftdi::k8N1,
                                ftdi::kNoFlowControl, ftdi::kRtsLow, ftdi::kDtrLow,      ftdi::kDtrHigh};
constexpr FtdiRequest kLockSpeed[] = {ftdi::kDtrLow, ftdi::kBaudUpload};
constexpr FtdiRequest kSwitch[] = {ftdi::kLatency1ms, ftdi::kBaudRun, ftdi::kPurge1, ftdi::kPurge2};
constexpr FtdiRequest kSettleEvent[] = {ftdi::kPurge1, ftdi::kPurge2, ftdi::kLatency1ms,     ftdi::kBaudRun,
                                        ftdi::kPurge1, ftdi::kPurge2, ftdi::kEventOnFrameEnd};
constexpr FtdiRequest kSwitchEvent[] = {ftdi::kLatency1ms, ftdi::kBaudRun, ftdi::kPurge1, ftdi::kPurge2,
                                        ftdi::kEventOnFrameEnd};

std::span<const FtdiRequest> script_of(Phase phase, const SessionSettings& settings) noexcept {
  switch (phase) {
    case Phase::settling:
      return settings.event_character ? std::span<const FtdiRequest>(kSettleEvent) : kSettle;
    case Phase::arming:
      return kArm;
    case Phase::locking:
      return kLockSpeed;
    case Phase::switching:
      return settings.event_character ? std::span<const FtdiRequest>(kSwitchEvent) : kSwitch;
    default:
      return {};
  }
}

}  // namespace

void Session::ask_open() noexcept {
  enter(Phase::opening);
  ask({.kind = LinkAsk::Kind::open});
  due_ = LinkTime::max();  // the link always answers
}

void Session::not_opened(Trouble trouble, LinkTime now) noexcept {
  leave_link();
  enter(Phase::unplugged);
  state_.trouble = trouble;
  due_ = now + settings_.times.reopen;
}

void Session::opened(LinkTime now) noexcept {
  leave_link();
  if (state_.trouble == Trouble::absent || state_.trouble == Trouble::denied || state_.trouble == Trouble::busy) {
    state_.trouble = Trouble::none;
  }
  begin_script(Phase::settling, now);
}

void Session::attempt_failed(Trouble trouble, LinkTime now) noexcept {
  leave_link();
  ask({.kind = LinkAsk::Kind::close});
  state_.trouble = trouble;
  ++state_.attempt;
  if (state_.attempt >= settings_.times.attempts) {
    enter(Phase::failed);
    due_ = now + settings_.times.rest;
  } else {
    enter(Phase::unplugged);
    due_ = now + settings_.times.reopen;
  }
}

void Session::begin_script(Phase phase, LinkTime now) noexcept {
  enter(phase);
  script_at_ = 0;
  lock_sent_ = false;
  forget_packets();
  next_request(now);
}

void Session::next_request(LinkTime now) noexcept {
  const auto script = script_of(state_.phase, settings_);
  if (script_at_ < script.size()) {
    ask({.kind = LinkAsk::Kind::control, .request = script[script_at_++]});
    due_ = now + settings_.times.request;
  } else {
    script_done(now);
  }
}

void Session::request_done(LinkTime now) noexcept {
  if (!script_of(state_.phase, settings_).empty() && !lock_sent_) next_request(now);
}

void Session::script_done(LinkTime now) noexcept {
  parser_.reset();
  tail_ = {};
  switch (state_.phase) {
    case Phase::settling:
    case Phase::switching:
      probing_after_upload_ = state_.phase == Phase::switching;
      enter(Phase::probing);
      tries_ = 0;
      probe(now);
      break;
    case Phase::arming:
      enter(Phase::greeting);
      tries_ = 0;
      send_hello(now);
      break;
    case Phase::locking:
      ask(LinkAsk::of_bytes(std::span(&kLock, 1)));
      due_ = now + settings_.times.echo;
      lock_sent_ = true;
      break;
    default:
      break;
  }
}

void Session::probe(LinkTime now) noexcept {
  if (tries_ == settings_.times.probes) return probe_failed(now);
  ++tries_;
  send_frame({}, control::kRed, now);
  due_ = now + settings_.times.probe;
}

void Session::probe_failed(LinkTime now) noexcept {
  if (probing_after_upload_) {
    attempt_failed(Trouble::no_answer, now);
  } else if (image_) {
    begin_script(Phase::arming, now);
  } else {
    enter(Phase::needs_image);
    due_ = now + settings_.times.reopen;  // then checks for an image, and asks again
  }
}

void Session::send_hello(LinkTime now) noexcept {
  if (tries_ == settings_.times.hellos) return attempt_failed(Trouble::no_hello, now);
  ++tries_;
  ask(LinkAsk::of_bytes(kHello));
  due_ = now + settings_.times.hello;
}

void Session::send_chunk(LinkTime now) noexcept {
  const auto left = image_->bytes().subspan(chunk_end_);
  if (left.empty()) return begin_script(Phase::switching, now);  // after the last echo the speed may change
  const auto chunk = left.first(std::min(left.size(), kPayloadBytes));
  chunk_end_ += chunk.size();
  ask(LinkAsk::of_bytes(chunk));
  due_ = now + settings_.times.echo;
}

void Session::echoed(std::uint8_t byte, LinkTime now) noexcept {
  // More bytes than were sent are as wrong as different ones.
  if (state_.uploaded >= chunk_end_ || byte != image_->bytes()[state_.uploaded]) {
    return attempt_failed(Trouble::wrong_echo, now);
  }
  if (++state_.uploaded == chunk_end_) send_chunk(now);
}

void Session::heard_loader(std::uint8_t byte, LinkTime now) noexcept {
  switch (state_.phase) {
    case Phase::greeting:
      std::copy(tail_.begin() + 1, tail_.end(), tail_.begin());
      tail_.back() = byte;
      if (tail_ == kHelloAnswer) begin_script(Phase::locking, now);
      break;
    case Phase::locking:
      if (byte == kLock && lock_sent_) {
        enter(Phase::uploading);
        state_.uploaded = 0;
        state_.upload_size = static_cast<std::uint32_t>(image_->bytes().size());
        chunk_end_ = 0;
        send_chunk(now);
      }
      break;
    case Phase::uploading:
      echoed(byte, now);
      break;
    default:
      break;
  }
}

}  // namespace cusp::device::falcon
