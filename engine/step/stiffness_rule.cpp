#include "engine/step/stiffness_rule.h"

#include <algorithm>

namespace cusp::engine {

namespace {

constexpr double kTickS = 0.001;
constexpr double kShare = 0.5;  // of the allowed stiffness
constexpr double kAssumedDampingNsPerM = 0.5, kAssumedDelayMs = 1.0;
/// Damping of the laboratory's softest grip (engine/lab/grip.h) [M]. A device that nobody holds does not press for
/// long.
constexpr double kSoftestGripNsPerM = 2.0;
/// Energy that a proxy's jump of one voxel may put into the coupling: as much as the guard lets the device feed.
constexpr double kVoxelMj = 0.05;

}  // namespace

StiffnessRule stiffness_rule(const DeviceLimits& device, Method method, double voxel_mm) noexcept {
  StiffnessRule out;
  out.most_n_per_mm = device.max_stiffness_n_per_mm;
  if (!device.closed_loop) return out;
  out.bound = StiffnessBound::device;
  out.assumed = !device.damping_ns_per_m || !device.delay_ms;

  const auto lower = [&](double allowed, StiffnessBound bound) {
    if (!(kShare * allowed < out.most_n_per_mm)) return;
    out.most_n_per_mm = std::max(kShare * allowed, 0.0);
    out.bound = bound;
  };
  const double damping_ns_per_m = std::max(device.damping_ns_per_m.value_or(kAssumedDampingNsPerM), 0.0) +
                                  std::max(device.softest_grip_ns_per_m.value_or(kSoftestGripNsPerM), 0.0);
  const double late_s = 0.5 * kTickS + 1e-3 * std::max(device.delay_ms.value_or(kAssumedDelayMs), 0.0);
  lower(1e-3 * damping_ns_per_m / late_s, StiffnessBound::loop);
  if (reading_of(method) == Reading::filled) lower(2.0 * kVoxelMj / (voxel_mm * voxel_mm), StiffnessBound::voxels);
  return out;
}

}  // namespace cusp::engine
