#include "device/falcon/emulated_link.h"

#include <algorithm>
#include <thread>

namespace cusp::device::falcon {

EmulatedLink::EmulatedLink(Emulator& falcon, const EmulatedLinkSettings& settings) noexcept
    : falcon_(falcon), settings_(settings), now_(settings.start), random_(settings.seed * 2 + 1) {
  delay_ = settings.transfer;
}

LinkTime EmulatedLink::now() const noexcept {
  if (settings_.time == EmulatedTime::stands) return now_;
  return std::chrono::steady_clock::now().time_since_epoch();
}

void EmulatedLink::push(LinkEvent::Kind kind) noexcept {
  if (event_count_ == kEvents) return;  // the driver waits for each answer: at most two are queued
  events_[(event_at_ + event_count_) % kEvents] = kind;
  ++event_count_;
}

void EmulatedLink::set_presence(Presence presence) noexcept {
  if (presence_ == presence) return;
  presence_ = presence;
  if (open_ && presence != Presence::here) {
    open_ = false;
    event_count_ = 0;
    push(LinkEvent::Kind::gone);
  }
}

void EmulatedLink::start(const LinkAsk& ask) noexcept {
  ++asks_;
  if (unplug_after_ >= 0 && unplug_after_-- == 0) set_presence(Presence::absent);
  const LinkTime at = now();
  switch (ask.kind) {
    case LinkAsk::Kind::open:
      switch (presence_) {
        case Presence::here:
          open_ = opened_once_ = true;
          push(LinkEvent::Kind::opened);
          break;
        case Presence::absent:
          push(LinkEvent::Kind::absent);
          break;
        case Presence::denied:
          push(LinkEvent::Kind::denied);
          break;
        case Presence::busy:
          push(LinkEvent::Kind::busy);
          break;
      }
      break;
    case LinkAsk::Kind::close:
      open_ = false;
      event_count_ = 0;
      break;
    case LinkAsk::Kind::control:
      if (open_) push(falcon_.control(ask.request, at) ? LinkEvent::Kind::control_done : LinkEvent::Kind::failed);
      break;
    case LinkAsk::Kind::send:
      if (!open_) break;
      if (fail_sends_) {
        push(LinkEvent::Kind::failed);
      } else {
        falcon_.write(ask.payload(), at);
      }
      break;
  }
}

LinkTime EmulatedLink::next_packet() noexcept {
  if (!open_) return LinkTime::max();
  const LinkTime ready = falcon_.next_read();
  if (ready == LinkTime::max()) return ready;
  return std::max(ready, now_ - delay_) + delay_;
}

void EmulatedLink::move_to(LinkTime when) noexcept {
  if (settings_.time == EmulatedTime::runs) {
    std::this_thread::sleep_until(
        std::chrono::steady_clock::time_point(std::chrono::duration_cast<std::chrono::steady_clock::duration>(when)));
    now_ = std::max(now_, now());
  } else {
    now_ = std::max(now_, when);
  }
  const EmulatedGrip& grip = grip_.read();
  if (grip.set) {
    falcon_.set_grip(grip.grip_m);
    falcon_.set_buttons(grip.buttons);
  }
  if (tick_) tick_(now_);
}

LinkEvent EmulatedLink::wait(LinkTime until) noexcept {
  now_ = std::max(now_, now());
  if (event_count_ > 0) {
    const LinkEvent::Kind kind = events_[event_at_];
    event_at_ = (event_at_ + 1) % kEvents;
    --event_count_;
    return {.kind = kind};
  }
  const LinkTime packet = next_packet();
  if (packet > std::max(until, now_)) {  // a waiting packet is delivered, however late the call
    move_to(until);
    if (event_count_ > 0) return wait(until);  // unplugged meanwhile
    return {};
  }
  move_to(packet);
  if (event_count_ > 0) return wait(until);
  const std::size_t size = falcon_.read(packet_, now_);
  random_ = random_ * 6364136223846793005u + 1442695040888963407u;
  const auto share = static_cast<double>(random_ >> 40) / static_cast<double>(1u << 24);
  delay_ =
      settings_.transfer + LinkTime(static_cast<std::int64_t>(share * static_cast<double>(settings_.jitter.count())));
  if (size == 0) return {};
  return {.kind = LinkEvent::Kind::received, .bytes = std::span(packet_).first(size)};
}

}  // namespace cusp::device::falcon
