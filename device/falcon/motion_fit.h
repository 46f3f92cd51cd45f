/// Mass, damping, friction, weight and delay from a record of motion under known forces. Pure; not for the haptic thread.
///
/// Along one axis: m x'' = F(t - delay) - b x' - c sign(x') - w. Smooth windows that vanish at both ends, and integration
/// by parts, leave positions only: no encoder count is differentiated. Least squares over all windows, at the delay with
/// the smallest residual. Modulating functions: M. Shinbrot, "On the analysis of
/// linear and nonlinear systems", Trans. ASME 79 (1957).
#pragma once

#include <optional>
#include <span>

namespace cusp::device::falcon {

struct MotionSample {
  double t_s = 0;      // when the reading was there
  double x_m = 0;
  double force_n = 0;  // commanded right after it, and held until the next
};

struct MotionFit {
  double mass_kg = 0;
  double damping_ns_per_m = 0;  // may come out a little below 0 where there is none
  double friction_n = 0;        // Coulomb's
  double weight_n = 0;          // constant push against the positive direction
  double delay_ms = 0;          // from a command to the reading that shows it: there and back
  double damping_error = 0, friction_error = 0, delay_error_ms = 0;  // one standard deviation, from the residuals
  int windows = 0;
};

/// nullopt for too few windows in motion, a singular fit, or a mass that is not positive.
std::optional<MotionFit> fit_motion(std::span<const MotionSample> record);

}  // namespace cusp::device::falcon
