#include "device/falcon/ftdi.h"

namespace cusp::device::falcon {

double baud_of(std::uint16_t divisor) noexcept {
  // Codes of the FT232B family: 00 none, 01 a half, 10 a quarter, 11 an eighth.
  constexpr double kFraction[4] = {0.0, 0.5, 0.25, 0.125};
  const double whole = divisor & 0x3FFF;
  const double by = whole + kFraction[divisor >> 14];
  return by >= 1.0 ? 3e6 / by : 0.0;
}

}  // namespace cusp::device::falcon
