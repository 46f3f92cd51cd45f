/// Digest of a session at a constant few hundred nanoseconds a tick. It adds what contact, removal and the guard give, and the cut field of one
/// brick a tick in turn. Equal inputs give equal digests after equal ticks. A brick that differs changes the digest
/// after at most as many ticks as bricks are cut. StepState::hash() reads all cut bricks at once, about 0.4 us each,
/// too much for one tick of a large cavity.
#pragma once

#include <cstdint>

#include "engine/step/step.h"

namespace cusp::engine {

class RunningDigest {
 public:
  /// Haptic thread, after each step. No heap, no lock; reads one brick of 1 KiB.
  void add(const StepState& state, const StepOutput& output) noexcept;
  std::uint64_t value() const noexcept { return value_; }

 private:
  std::uint64_t value_ = 0;
  std::size_t next_brick_ = 0;  // place in Volume::cut_bricks()
};

/// Loop and mirror compare their digests every so many ticks: once a second at 1 kHz.
inline constexpr std::uint64_t kMarkTicks = 1000;

/// The loop's digest after a tick, for the mirror to compare.
struct DigestMark {
  std::uint64_t tick = 0;
  std::uint64_t digest = 0;
};

}  // namespace cusp::engine
