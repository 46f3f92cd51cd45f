/// Warmth of the tooth under the bur: the work of cutting warms it, coolant and time take it away. One figure, for the
/// tissue between cut and pulp; nothing is conducted in space. Pure, exact arithmetic. Thread: haptic; wait-free.
/// Source: dental.md 3.3: dry cutting for longer than about 10 s reaches the 5.5 degrees criterion of the pulp [M]; the
/// constants are chosen so that a turbine under the usual load does just that, and are [M] too.
#pragma once

namespace cusp::engine {

inline constexpr double kPulpCriterionK = 5.5;       // rise that raises the dry-cutting event [M]
inline constexpr double kMostRiseK = 1000.0;         // bound of HeatState::rise_k
inline constexpr double kUnknownRpm = 210e3;         // of a scene without a handpiece: a turbine under load [M]

struct HeatState {
  double rise_k = 0.0;  // above the tooth at rest
  bool over = false;    // at or above the criterion; falls back below four fifths of it
};

struct HeatTick {
  double push_n = 0.0;           // of the bur on the tissue; 0 in the air
  double surface_mm_s = 0.0;     // of the bur, where it is widest
  bool coolant = false;
  double dt_s = 0.001;
};

/// One tick. True in the tick in which the rise comes to the criterion: the dry-cutting event, once for each time that it
/// gets there. Values that are no numbers, or negative, count as none; the rise stays within [0, kMostRiseK].
bool advance(HeatState& state, const HeatTick& tick) noexcept;

}  // namespace cusp::engine
