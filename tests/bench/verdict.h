/// Failures of a row of `stability` and their bounds, which are the goals.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/bench/rows.h"

namespace cusp::bench {

enum class FailureKind : std::uint8_t { through, overlap, stuck, kicks, rings, feeds, stays_on };

/// Kinds with their names in rows, most harmful first.
inline constexpr std::array<std::pair<FailureKind, std::string_view>, 7> kFailureKinds = {
    {{FailureKind::through, "through"},    // the pivot enters the tissue or passes behind it
     {FailureKind::overlap, "overlap"},    // the bur overlaps tissue by more than a voxel
     {FailureKind::stuck, "stuck"},        // the proxy stays behind the exact one for 50 ms
     {FailureKind::kicks, "kicks"},        // a force step over kMostStepMn
     {FailureKind::rings, "rings"},        // a limit cycle over kMostCycleUm, or vibration
     {FailureKind::feeds, "feeds"},        // energy into the hand, kMostFedMj beyond the exact proxy
     {FailureKind::stays_on, "stays-on"}}};  // the force does not become zero

inline constexpr double kMostStepMn = 50.0;        // mN a tick
inline constexpr double kMostGuardStepMn = 301.0;  // mN a tick; the guard's slew and its rounding
inline constexpr double kMostFedMj = 0.05;         // mJ beyond the exact proxy
inline constexpr double kMostCycleUm = 100.0;      // um; two encoder steps, and over twice the exact proxy's
inline constexpr double kMostVibrationMn =
    10.0;                                      // fingertips feel vibrations from about 10 um, which is 10 mN at 1 N/mm
inline constexpr double kMostZeroMs = 1.0;     // ms after a faulty input
inline constexpr double kMostFragmentMs = 100.0;  // ms after a fragment is detached
inline constexpr double kMostFrozenMs = 11.0;  // ms; the guard detects a frozen device after 10 ms

/// In the order of kFailureKinds.
std::vector<FailureKind> failures_of(const Row& row);
/// "through kicks": names between spaces; empty for none.
std::string names_of(const std::vector<FailureKind>& failures);

}  // namespace cusp::bench
