/// The cases of `stability`, in the order of the stability map.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "tests/bench/options.h"
#include "tests/bench/rows.h"
#include "tests/bench/stability_run.h"

namespace cusp::bench {

/// Stiffness swept to the limit (stability_kmax.h).
inline constexpr std::array<std::string_view, 6> kPressCases = {
    "face", "edge", "corner", "groove", "pit", "channel"};
/// Motions at one stiffness.
inline constexpr std::array<std::string_view, 11> kMotionCases = {
    "thin-wall", "tissues", "vanishing", "islands", "fragment", "narrow-slot", "start-inside", "volume-edge",
    "voxel-size", "late-ticks", "grip-weight"};
/// Faults of the device and exchanges by the session while the bur is in contact.
inline constexpr std::array<std::string_view, 8> kFaultCases = {
    "frozen", "jump", "nan", "infinite", "out-of-range", "device-gone", "specimen-exchange", "bur-exchange"};
/// The paper's tasks.
inline constexpr std::array<std::string_view, 3> kTaskCases = {
    "displacement", "exploration", "perforation"};

inline constexpr std::int64_t kMostRuns = 10000;

/// Settings of one row.
struct CaseRun {
  std::string_view key;
  Method method = Method::surface;
  GuardUse guard = GuardUse::on;
  Setting setting;
  double voxel_mm = 10.0 / 128;
  double bur_radius_mm = 0.25;
  double budget_s = 1.0;  // CPU time after which no further run begins; one always runs
  std::int64_t most_runs = kMostRuns;
  std::uint64_t seed = 1;
  bool settle = false;  // an open k_max takes more seeds (stability_sets.h)
};

/// One row. Pre: the key is of kMotionCases, kFaultCases or kTaskCases.
Row run_case(const CaseRun& what);

Row row_of(const CaseRun& what);
Row run_thin_wall(const CaseRun& what);
Row run_motion(const CaseRun& what);
Row run_vanishing(const CaseRun& what);
Row run_fragment(const CaseRun& what);
Row run_start_inside(const CaseRun& what);
Row run_weight(const CaseRun& what);
Row run_fault(const CaseRun& what);
Row run_task(const CaseRun& what);

}  // namespace cusp::bench
