/// Stability of a virtual wall on a sampled device, by theory and by published bounds: the laboratory is checked
/// against both. Linear: no encoder, no friction, the wall acts in both directions.
#pragma once

#include "engine/lab/device_model.h"
#include "engine/lab/grip.h"

namespace cusp::engine::lab {

/// F = -K x - B (x - x before) / T, computed from a sample and held one tick, delay_ticks later.
struct SampledWall {
  double mass_kg = 0.1;
  double damping_ns_per_m = 2.0;
  double stiffness_n_per_mm = 1.0;        // K
  double virtual_damping_ns_per_m = 0.0;  // B
  int delay_ticks = 0;                    // [0, 6]
  double tick_s = 0.001;                  // T
  Grip grip = kNoGrip;
};

/// The largest magnitude of an eigenvalue of the closed loop from sample to sample. Below 1 all motion is damped.
/// Zero-order hold in closed form; the roots of the characteristic polynomial by Aberth's iteration.
double spectral_radius(const SampledWall& wall) noexcept;

/// The stiffness (N/mm) at which the spectral radius reaches 1, all else as given; the lowest one, within 1e-6 of
/// itself. 0 when the loop is unstable without any.
double critical_stiffness_n_per_mm(SampledWall wall) noexcept;

/// Colgate and Schenkel, "Passivity of a class of sampled-data systems: application to haptic interfaces", J. Robotic
/// Systems 14(1), 1997: passive when b > K T / 2 + |B|. The stiffness at which that ends, N/mm; never below 0.
/// Sufficient for a stable touch by any passive hand, not necessary for one hand: the limit of stability may be far
/// above.
double colgate_bound_n_per_mm(const SampledWall& wall) noexcept;

/// Abbott and Okamura, "Effects of position quantization and sampling rate on virtual-wall passivity", IEEE Trans.
/// Robotics 21(5), 2005: a wall without virtual damping, read by an encoder, is passive when
/// K <= min(2 b / T, 2 f_c / encoder step). N/mm. Sufficient for stability, as above; 0 without friction on a device
/// with encoders.
double abbott_okamura_bound_n_per_mm(const DeviceSettings& device, double tick_s) noexcept;

}  // namespace cusp::engine::lab
