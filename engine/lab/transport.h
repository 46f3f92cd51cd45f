/// The transport between device and host: a reading goes up each millisecond, a force comes down for each reading that
/// arrives. Half of the delay is on the way up, half on the way down. Packets keep their order. Time in slices of
/// kSliceUs. The same seed gives the same delays and losses.
#pragma once

#include <array>
#include <cstdint>

#include "engine/base/vec.h"
#include "engine/lab/device_model.h"

namespace cusp::engine::lab {

struct TransportSettings {
  double delay_ms = 0.0;    // there and back, [0, 20]
  double jitter_ms = 0.0;   // at most as much again, evenly, there and back together, [0, 20]
  double lost_share = 0.0;  // of exchanges, [0, 1): half of them on the way up, half on the way down
  std::uint64_t seed = 1;
};

/// splitmix64: the same everywhere.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) noexcept : state_(seed) {}
  /// In [0, 1).
  double roll() noexcept {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

/// A first-in first-out of packets with the slice at which each arrives.
template <class Load>
class Wire {
 public:
  static constexpr int kMost = 64;  // 40 ms of packets at most are under way
  void send(std::int64_t arrives, const Load& load) noexcept {
    if (count_ > 0 && arrives < last_) arrives = last_;
    last_ = arrives;
    if (count_ == kMost) {  // the host is stalled: the oldest packet is dropped
      first_ = (first_ + 1) % kMost;
      --count_;
    }
    packets_[static_cast<std::size_t>((first_ + count_++) % kMost)] = {arrives, load};
  }
  bool empty() const noexcept { return count_ == 0; }
  std::int64_t arrives() const noexcept { return packets_[static_cast<std::size_t>(first_)].arrives; }
  Load take() noexcept {
    const Load load = packets_[static_cast<std::size_t>(first_)].load;
    first_ = (first_ + 1) % kMost;
    --count_;
    return load;
  }

 private:
  struct Packet {
    std::int64_t arrives = 0;
    Load load{};
  };
  std::array<Packet, kMost> packets_{};
  std::int64_t last_ = 0;
  int first_ = 0, count_ = 0;
};

}  // namespace cusp::engine::lab
