#include "engine/removal/heat.h"

#include "engine/removal/spindle.h"

namespace cusp::engine {

namespace {

constexpr double kTangentialShare = 0.2;  // of the push: what the edges meet as they go round [M]
/// 1 N at 0.5 mm and 210k rpm is 0.2 N x 11.0 m/s = 2.2 W; with this and kDryDecayS it comes to 5.5 K in 10 s:
/// 5.5 / (2.2 x 30 x (1 - e^(-10/30))).
constexpr double kKelvinPerJoule = 0.294;
constexpr double kDryDecayS = 30.0;       // how the tooth cools by itself, and under coolant [M]
constexpr double kWetDecayS = 5.0;
constexpr double kCoolantLeaves = 0.05;   // of the heat [M]
constexpr double kFallsBack = 0.8;

}  // namespace

bool advance(HeatState& state, const HeatTick& tick) noexcept {
  const double dt_s = within(tick.dt_s, 0.0, 1.0);
  const double watts =
      kTangentialShare * within(tick.push_n, 0.0, 1e3) * within(tick.surface_mm_s, 0.0, 1e6) * 1e-3;
  const double in_k_s = kKelvinPerJoule * watts * (tick.coolant ? kCoolantLeaves : 1.0);
  const double decay_s = tick.coolant ? kWetDecayS : kDryDecayS;
  state.rise_k += dt_s * (in_k_s - state.rise_k / decay_s);
  state.rise_k = within(state.rise_k, 0.0, kMostRiseK);
  if (state.over) {
    state.over = state.rise_k >= kFallsBack * kPulpCriterionK;
    return false;
  }
  state.over = state.rise_k >= kPulpCriterionK;
  return state.over;
}

}  // namespace cusp::engine
