// k_max of a method and of the exact proxy in one place, and the other measures at half of it.
#include <algorithm>
#include <map>
#include <tuple>

#include "tests/bench/stability.h"
#include "tests/bench/stability_kmax.h"
#include "tests/bench/stability_sets.h"

namespace cusp::bench {

namespace {

constexpr int kSeeds = 5, kFewSeeds = 2;

KMaxCase k_max_case(const CaseRun& what) {
  KMaxCase out;
  out.place = what.key;
  out.guard = what.guard;
  out.bur_radius_mm = what.bur_radius_mm;
  out.voxel_mm = what.voxel_mm;
  out.device = what.setting.device();
  out.transport = what.setting.transport(what.seed);
  out.grip = what.setting.hand();
  out.seeds = what.budget_s < kWholeBudgetS ? kFewSeeds : kSeeds;
  out.first_seed = (what.seed - 1) * kSeeds + 1;
  return out;
}

/// k_max of the exact proxy, cached: no method, guard or voxel changes it.
const KMax& exact_k_max(const CaseRun& what, KMaxSearch search = KMaxSearch::spot_checks) {
  using Key = std::tuple<std::string, double, double, double, double, double, std::string, std::uint64_t, KMaxSearch>;
  static std::map<Key, KMax> known;
  const Setting& s = what.setting;
  const Key key{std::string(what.key), what.bur_radius_mm, s.mass_kg, s.damping_ns_per_m, s.friction_n, s.delay_ms,
                std::string(s.grip),   what.seed,           search};
  auto found = known.find(key);
  if (found == known.end()) {
    KMaxCase exact = k_max_case(what);
    exact.method.reset();
    exact.guard = GuardUse::off;
    exact.search = search;
    found = known.emplace(key, find_k_max(exact)).first;
  }
  return found->second;
}

/// k_max of the first set of seeds, and of more sets if that is unsettled and `what.settle` is set.
KMaxSets k_max_sets(PressBench& bench, const KMaxCase& own, const CaseRun& what) {
  const KMaxPair first{find_k_max(bench, own), exact_k_max(what)};
  const double near = first.own.k_max_n_per_mm;
  return settle(what.guard, first, what.settle ? kMostSets : 1, [&](int i) {
    CaseRun set = what;
    set.seed += static_cast<std::uint64_t>(i);
    KMaxCase with = own;
    with.first_seed = k_max_case(set).first_seed;
    with.search = KMaxSearch::every_place;
    return KMaxPair{find_k_max(bench, with, near), exact_k_max(set, KMaxSearch::every_place)};
  });
}

}  // namespace

Row press_row(const CaseRun& what) {
  Row row = row_of(what);
  row.shape = what.key;
  KMaxCase own = k_max_case(what);
  own.method = what.method;
  PressBench bench(own);
  const KMaxSets found = k_max_sets(bench, own, what);
  row.k_max_n_per_mm = found.own_spread.median;
  row.k_exact_n_per_mm = found.exact_spread.median;
  row.k_sets = found.sets;
  if (found.sets > 1) {
    row.k_first_n_per_mm = found.own_spread.first;
    row.k_least_n_per_mm = found.own_spread.least;
    row.k_most_n_per_mm = found.own_spread.most;
    row.k_exact_first_n_per_mm = found.exact_spread.first;
    row.k_exact_least_n_per_mm = found.exact_spread.least;
    row.k_exact_most_n_per_mm = found.exact_spread.most;
  }
  row.cycle_um = found.own.cycle_um;
  row.cycle_hz = found.own.cycle_hz;
  // At half of the smaller k_max, with every seed.
  const double half = 0.5 * std::min(row.k_max_n_per_mm, row.k_exact_n_per_mm);
  row.runs = own.seeds * found.sets;
  row.passed_through = row.stuck = 0;
  if (!(half > 0.0)) return row;
  bench.use(own);
  KMaxCase exact = own;
  exact.method.reset();
  exact.guard = GuardUse::off;
  PressBench reference(exact);
  row.energy_mj = row.energy_exact_mj = row.force_step_mn = row.guard_step_mn = row.penetration_um = 0.0;
  row.stuck_ms = 0.0;
  for (int set = 0; set < found.sets; ++set)
    for (int nth = 0; nth < own.seeds; ++nth) {
      const std::uint64_t seed = own.first_seed + static_cast<std::uint64_t>(set * kSeeds + nth);
      const PressRun run = bench.run(half, seed, {.compare_exact = true});
      row.energy_mj = std::max(row.energy_mj, run.energy_mj);
      row.energy_exact_mj = std::max(row.energy_exact_mj, reference.run(half, seed).energy_mj);
      row.force_step_mn = std::max(row.force_step_mn, run.force_step_mn);
      row.guard_step_mn = std::max(row.guard_step_mn, run.guard_step_mn);
      row.penetration_um = std::max(row.penetration_um, run.penetration_um);
      row.passed_through += run.off_um > 1000.0 * what.bur_radius_mm ? 1 : 0;
      row.stuck += stuck_for_ms(run.stuck_ms) > 0 ? 1 : 0;
      row.stuck_ms = std::max(row.stuck_ms, static_cast<double>(stuck_for_ms(run.stuck_ms)));
    }
  return row;
}

}  // namespace cusp::bench
