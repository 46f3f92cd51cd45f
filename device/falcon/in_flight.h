/// Queue of unanswered packets. The protocol has no sequence numbers, so an answer belongs to the oldest unanswered packet:
/// a lost answer makes later ones look older than they are, never younger. Pure; no allocation.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <optional>

#include "device/falcon/link.h"

namespace cusp::device::falcon {

class InFlight {
 public:
  static constexpr std::size_t kMost = 16;

  /// Pre: fewer than kMost are under way.
  void sent(LinkTime now) noexcept {
    assert(count_ < kMost);
    if (count_ == kMost) return;
    times_[(at_ + count_++) % kMost] = now;
  }
  /// Departure time of the packet that this answer belongs to; nullopt if no packet waits.
  std::optional<LinkTime> answered() noexcept {
    if (count_ == 0) return std::nullopt;
    const LinkTime out = times_[at_];
    at_ = (at_ + 1) % kMost;
    --count_;
    return out;
  }
  std::size_t count() const noexcept { return count_; }
  bool empty() const noexcept { return count_ == 0; }
  /// Departure time of the packet after `older` older ones. Pre: older < count().
  LinkTime sent_at(std::size_t older) const noexcept { return times_[(at_ + older) % kMost]; }
  /// Empties the queue; returns the number of packets.
  std::size_t forget() noexcept {
    const std::size_t out = count_;
    count_ = 0;
    return out;
  }

 private:
  std::array<LinkTime, kMost> times_{};
  std::size_t at_ = 0, count_ = 0;
};

}  // namespace cusp::device::falcon
