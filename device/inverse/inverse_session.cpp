#include "device/inverse/inverse_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cusp::device::inverse {

std::string_view key_of(Trouble trouble) noexcept {
  switch (trouble) {
    case Trouble::none: return "none";
    case Trouble::no_service: return "no_service";
    case Trouble::no_device: return "no_device";
    case Trouble::no_answer: return "no_answer";
    case Trouble::garbage: return "garbage";
    case Trouble::gone: return "gone";
    case Trouble::no_handle: return "no_handle";
  }
  return "none";
}

Session::Session(const SessionSettings& settings, std::string device)
    : settings_(settings), wanted_(std::move(device)) {}

void Session::enter(Phase phase, LinkTime now) noexcept {
  state_.phase = phase;
  since_ = ramp_from_ = now;
  if (phase != Phase::ready) force_n_ = Vec3(0.0);
}

void Session::lose(Trouble trouble, LinkTime now) noexcept {
  state_.trouble = trouble;
  awaits_answer_ = ask_ = false;
  garbage_ = 0;
  request_ = LinkRequest::close;
  enter(Phase::pausing, now);
}

void Session::advance(const LinkEvent& event, LinkTime now) {
  switch (event.kind) {
    case LinkEvent::Kind::opened:
      if (state_.phase != Phase::connecting) break;
      ++state_.connections;
      received_ = asked_ = now;
      garbage_ = 0;
      others_ = false;
      // The service sends the first message unasked.
      awaits_answer_ = true;
      enter(Phase::greeting, now);
      return;
    case LinkEvent::Kind::refused:
      if (state_.phase == Phase::connecting) lose(Trouble::no_service, now);
      return;
    case LinkEvent::Kind::closed:
      if (state_.phase != Phase::closed && state_.phase != Phase::pausing) lose(Trouble::gone, now);
      return;
    case LinkEvent::Kind::message:
      if (state_.phase == Phase::greeting || state_.phase == Phase::ready || state_.phase == Phase::silent)
        take_text(event.text, now);
      return;
    case LinkEvent::Kind::time: break;
  }
  switch (state_.phase) {
    case Phase::closed: break;
    case Phase::connecting:
      if (now - since_ >= settings_.give_up) lose(Trouble::no_service, now);
      break;
    case Phase::pausing:
      if (now - since_ >= settings_.pause && request_ == LinkRequest::none) {
        request_ = LinkRequest::open;
        enter(Phase::closed, now);
      }
      break;
    case Phase::ready:
      if (awaits_answer_ && now - asked_ >= settings_.answer) {
        ++state_.silences;
        enter(Phase::silent, now);
        ask_ = true;  // zero force leaves at once
      }
      break;
    case Phase::greeting:
    case Phase::silent:
      if (now - received_ >= settings_.give_up) {
        lose(state_.phase == Phase::silent ? Trouble::gone : others_ ? Trouble::no_device : Trouble::no_answer, now);
      } else if (!state_.device.empty() && now - asked_ >= settings_.repeat) {
        ask_ = true;  // the message or its answer was lost
      }
      break;
  }
}

void Session::take_text(std::string_view text, LinkTime now) {
  const auto frame = parse_frame(text);
  if (!frame) {
    ++state_.unread;
    if (++garbage_ >= settings_.garbage) return lose(Trouble::garbage, now);
    // Without a readable position no force is safe.
    if (state_.phase == Phase::ready) enter(Phase::silent, now);
    awaits_answer_ = false;
    ask_ = !state_.device.empty();
    return;
  }
  garbage_ = 0;
  if (!frame->version.empty()) state_.version = frame->version;
  const Frame::Device* mine = nullptr;
  for (const Frame::Device& device : frame->devices) {
    if (device.id.empty()) continue;  // no message could name it
    const bool named = state_.device.empty() ? wanted_.empty() || device.id == wanted_ : device.id == state_.device;
    if (named && mine == nullptr) mine = &device;
  }
  if (mine == nullptr) {
    // A message without this device counts as silence.
    if (state_.phase == Phase::greeting) {
      state_.trouble = Trouble::no_device;
      others_ = true;
    }
    return;
  }
  if (state_.phase == Phase::greeting && state_.device.empty()) {
    state_.device = mine->id;
    state_.left_handed = mine->left_handed;
  }
  received_ = now;
  awaits_answer_ = false;
  ask_ = true;
  if (!mine->position_m) {
    // As with garbage: without a position no force is safe.
    if (state_.phase == Phase::ready) enter(Phase::silent, now);
    return;
  }
  if (!frame->orientation && state_.has_orientation && now - turned_ >= settings_.handle) {
    state_.trouble = Trouble::no_handle;
    if (state_.phase == Phase::ready) enter(Phase::silent, now);
    return;
  }
  state_.reading.position_m = *mine->position_m;
  if (frame->orientation) {
    state_.has_orientation = true;
    state_.reading.orientation = frame->orientation;
    turned_ = now;
  }
  state_.reading.a = frame->a;
  state_.reading.b = frame->b;
  state_.reading.c = frame->c;
  ++state_.readings;
  state_.trouble = Trouble::none;
  if (state_.phase == Phase::ready) return;
  wanted_ = state_.device;
  enter(Phase::ready, now);
}

void Session::command(Vec3 force_n, LinkTime now, LinkTime ramp_from) noexcept {
  if (state_.phase != Phase::ready) return;
  ramp_from_ = std::max(ramp_from_, now - force_at_ > settings_.stale_force ? now : ramp_from);
  const bool finite = std::isfinite(force_n.x) && std::isfinite(force_n.y) && std::isfinite(force_n.z);
  force_n_ = finite ? force_n : Vec3(0.0);
  force_at_ = now;
}

Session::LinkRequest Session::take_request(LinkTime now) noexcept {
  const LinkRequest request = std::exchange(request_, LinkRequest::none);
  if (request == LinkRequest::open) enter(Phase::connecting, now);
  if (request == LinkRequest::close) state_.device.clear();
  return request;
}

Vec3 Session::ramped(LinkTime now) const noexcept {
  if (state_.phase != Phase::ready || now - force_at_ > settings_.stale_force) return Vec3(0.0);
  const double share = std::chrono::duration<double>(now - ramp_from_) / std::chrono::duration<double>(settings_.ramp);
  return force_n_ * std::clamp(share, 0.0, 1.0);
}

std::optional<std::string> Session::take_message(LinkTime now) {
  if (!ask_ || state_.device.empty() || now - asked_ < settings_.pace) return std::nullopt;
  ask_ = false;
  awaits_answer_ = true;
  asked_ = now;
  ++state_.sent;
  const Vec3 force = ramped(now);
  state_.force_n = glm::length(force);
  return force_message(state_.device, force);
}

LinkTime Session::due() const noexcept {
  switch (state_.phase) {
    case Phase::closed: return since_;
    case Phase::connecting: return since_ + settings_.give_up;
    case Phase::pausing: return since_ + settings_.pause;
    case Phase::ready: return awaits_answer_ ? asked_ + settings_.answer : asked_ + settings_.pace;
    case Phase::greeting:
    case Phase::silent:
      if (state_.device.empty()) return received_ + settings_.give_up;  // no message can name a device
      if (ask_) return asked_ + settings_.pace;
      return std::min(asked_ + settings_.repeat, received_ + settings_.give_up);
  }
  return since_;
}

std::optional<std::string> Session::closing_message() const {
  if (state_.device.empty()) return std::nullopt;
  return force_message(state_.device, Vec3(0.0));
}

}  // namespace cusp::device::inverse
