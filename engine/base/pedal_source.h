/// Interface between the haptic thread and a foot pedal.
#pragma once

#include <chrono>
#include <cstdint>

namespace cusp {

struct PedalReading {
  std::uint16_t pressed = 0;  // 0 released to 65535 fully down
  bool coolant = false;       // the second switch is down
  friend bool operator==(const PedalReading&, const PedalReading&) = default;
};

class PedalSource {
 public:
  virtual ~PedalSource() = default;
  /// Newest value; released if there is no pedal, it was lost, or its reader has stalled before `now`.
  /// Thread: haptic. Wait-free, no I/O.
  virtual PedalReading latest(std::chrono::steady_clock::time_point now) const noexcept = 0;
};

}  // namespace cusp
