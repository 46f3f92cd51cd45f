/// What of a row of `stability` counts as a failure. The bounds are those of the goals, and stand in the README.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/bench/rows.h"

namespace cusp::bench {

enum class FailureKind : std::uint8_t { through, overlap, stuck, kicks, rings, feeds, stays_on };

/// In the order of harm, as rows name them.
inline constexpr std::array<std::pair<FailureKind, std::string_view>, 7> kFailureKinds = {
    {{FailureKind::through, "through"},    // the pivot gets into the tissue, or behind it
     {FailureKind::overlap, "overlap"},    // stands in tissue by more than a voxel
     {FailureKind::stuck, "stuck"},        // for 50 ms
     {FailureKind::kicks, "kicks"},        // by more than kMostStepMn
     {FailureKind::rings, "rings"},        // in a cycle, or by vibration
     {FailureKind::feeds, "feeds"},        // the hand, beyond the exact proxy
     {FailureKind::stays_on, "stays-on"}}};  // a force that does not go to zero

inline constexpr double kMostStepMn = 50.0;        // of force_step
inline constexpr double kMostGuardStepMn = 301.0;  // the slew in a tick, and its rounding
inline constexpr double kMostFedMj = 0.05;         // beyond the exact proxy
inline constexpr double kMostCycleUm = 100.0;      // two encoder steps, and more than twice the exact proxy's
inline constexpr double kMostVibrationMn =
    10.0;                                      // what fingertips feel begins at some 10 um, which are 10 mN of 1 N/mm
inline constexpr double kMostZeroMs = 1.0;     // after a faulty input
inline constexpr double kMostFragmentMs = 100.0;  // after a piece has been cut loose
inline constexpr double kMostFrozenMs = 11.0;  // a device is not known to be frozen before its 10 ms are over

/// In the order of kFailureKinds.
std::vector<FailureKind> failures_of(const Row& row);
/// "through kicks": names between spaces; empty for none.
std::string names_of(const std::vector<FailureKind>& failures);

}  // namespace cusp::bench
