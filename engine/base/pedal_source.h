/// The seam between the haptic thread and a foot pedal, whoever reads it.
#pragma once

#include <chrono>
#include <cstdint>

namespace cusp {

struct PedalReading {
  std::uint16_t pressed = 0;  // 0 released to 65535 fully down
  bool coolant = false;       // its second switch is down
  friend bool operator==(const PedalReading&, const PedalReading&) = default;
};

class PedalSource {
 public:
  virtual ~PedalSource() = default;
  /// Haptic thread; wait-free, no I/O. The newest value: released when there is no pedal, when it was lost, or when
  /// whoever reads it has not looked for a while before `now`.
  virtual PedalReading latest(std::chrono::steady_clock::time_point now) const noexcept = 0;
};

}  // namespace cusp
