#include "tests/bench/verdict.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/stability_cases.h"

namespace cusp::bench {

std::vector<FailureKind> failures_of(const Row& row) {
  std::vector<FailureKind> out;
  const auto is = [&out](FailureKind b, bool broken) {
    if (broken) out.push_back(b);
  };
  is(FailureKind::through, row.passed_through > 0);
  // Falling through includes overlapping.
  is(FailureKind::overlap, out.empty() && row.penetration_um > 1000.0 * row.voxel_mm);
  is(FailureKind::stuck, row.stuck > 0);
  is(FailureKind::kicks, row.force_step_mn > kMostStepMn || row.guard_step_mn > kMostGuardStepMn);
  // A row with k_max holds the cycle of the first failing stiffness, which is no failure of the row.
  const bool press = std::ranges::any_of(kPressCases, [&row](std::string_view c) { return c == row.case_name; });
  is(FailureKind::rings, (!press && row.cycle_um > kMostCycleUm && row.cycle_um > 2.0 * row.cycle_exact_um) ||
                        row.vibration_mn > kMostVibrationMn);
  // energy_left_mj excludes each episode's late ticks; without it the late energy of the whole run is subtracted.
  const double late = std::isnan(row.late_mj) ? 0.0 : row.late_mj;
  const double left = std::isnan(row.energy_left_mj) ? row.energy_mj - late : row.energy_left_mj;
  is(FailureKind::feeds, left > row.energy_exact_mj + kMostFedMj);
  const bool fault = std::ranges::any_of(kFaultCases, [&row](std::string_view c) { return c == row.case_name; });
  const bool exchange = row.case_name == "specimen-exchange" || row.case_name == "bur-exchange";
  is(FailureKind::stays_on,
     fault && !exchange && !(row.zero_ms <= (row.case_name == "frozen" ? kMostFrozenMs : kMostZeroMs)));
  is(FailureKind::stays_on, row.case_name == "fragment" && row.grip == "scripted" && !(row.zero_ms <= kMostFragmentMs));
  return out;
}

std::string names_of(const std::vector<FailureKind>& failures) {
  std::string out;
  for (const auto& [kind, name] : kFailureKinds)
    if (std::ranges::find(failures, kind) != failures.end()) out.append(out.empty() ? "" : " ").append(name);
  return out;
}

}  // namespace cusp::bench
