#include "engine/removal/vibration.h"

namespace cusp::engine {

namespace {

/// Below this the wave fades: a slow push to and fro would be work, not a tremble.
constexpr double kSlowHz = 50.0;

}  // namespace

int subharmonic_of(const SpindleSettings& settings) noexcept {
  int n = 1;
  while (n < 1000 && settings.free_rpm / 60.0 / n > kFeltHz) ++n;
  return n;
}

double sine_of(std::uint32_t phase) noexcept {
  double x = static_cast<double>(static_cast<std::int32_t>(phase)) / 4294967296.0;  // turns, [-1/2, 1/2)
  if (x > 0.25) x = 0.5 - x;
  if (x < -0.25) x = -0.5 - x;
  const double y = 6.283185307179586 * x;
  const double z = y * y;
  const double sine =
      y * (1.0 - z / 6.0 * (1.0 - z / 20.0 * (1.0 - z / 42.0 * (1.0 - z / 72.0))));
  return sine > 1.0 ? 1.0 : sine < -1.0 ? -1.0 : sine;
}

double vibration_n(VibrationState& state, const SpindleSettings& settings, double rpm, double push_n, double hardness,
                   double dt_s) noexcept {
  const double hz = within(rpm / 60.0 / subharmonic_of(settings), 0.0, kFeltHz);
  dt_s = within(dt_s, 0.0, 1.0);
  const double turns = hz * dt_s;  // of the felt wave in this tick; 250 at most
  const auto whole = static_cast<std::uint64_t>(turns * 4294967296.0);
  state.phase += static_cast<std::uint32_t>(whole & 0xffffffffu);
  double size = kMostVibrationN * within(push_n / kWholePushN, 0.0, 1.0) * within(hardness, 0.0, 1.0);
  const double most = kMostVibrationShare * within(push_n, 0.0, 1e6);
  if (size > most) size = most;
  size *= within(hz / kSlowHz, 0.0, 1.0);
  size *= within(2.0 - 4.0 * turns, 0.0, 1.0);  // whole up to four samples a wave, gone at two
  return size * sine_of(state.phase);
}

}  // namespace cusp::engine
