#include "tests/bench/stability.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "tests/bench/names.h"
#include "tests/bench/stability_kmax.h"
#include "tests/bench/verdict.h"

namespace cusp::bench {

namespace {

constexpr double kUsualVoxelMm = 10.0 / 128;
/// Share of the budget of a row of kMotionCases, of which there are hundreds, and of the thin wall.
constexpr double kMotionShare = 0.4, kWallShare = 12.0;

struct Device {
  double mass_kg, damping_ns_per_m;
};
constexpr Device kDevices[] = {{0.1, 0.5}, {0.1, 2.0}, {0.1, 5.0}, {0.25, 0.5}, {0.25, 2.0}, {0.25, 5.0}};

/// True if the options name a device, friction or delay.
bool asks_for_a_device(const Options& options) {
  return options.full || !options.devices.empty() || !options.frictions_n.empty() || !options.delays_ms.empty();
}

/// The selected grips on the usual device or the selected ones.
std::vector<Setting> settings_of(const std::vector<std::string_view>& grips, const Options& options) {
  const Setting usual = usual_setting();
  const auto of = [&options](double one, std::vector<double> all) { return options.full ? all : std::vector{one}; };
  const std::vector<double> frictions = of(usual.friction_n, {0.0, 0.1}), delays = of(usual.delay_ms, {0.0, 1.0, 3.0});
  std::vector<Setting> out;
  for (const std::string_view grip : grips) {
    if (!asked(options.grips, grip)) continue;
    if (grip == Setting{}.grip) {
      if (!asks_for_a_device(options)) out.emplace_back();
      continue;
    }
    for (const Device& device : kDevices) {
      const std::string name = device_name(device.mass_kg, device.damping_ns_per_m);
      const bool is_usual = name == device_name(usual.mass_kg, usual.damping_ns_per_m);
      if (options.devices.empty() ? !is_usual && !options.full : !asked(options.devices, name)) continue;
      for (const double friction : chosen(options.frictions_n, frictions))
        for (const double delay : chosen(options.delays_ms, delays))
          out.push_back({device.mass_kg, device.damping_ns_per_m, friction, delay, grip});
    }
  }
  return out;
}

/// Grips of a motion case.
std::vector<std::string_view> grips_of(std::string_view key) {
  if (key == "thin-wall" || key == "start-inside") return {"scripted"};
  if (key == "grip-weight") return {"none", "soft"};
  return {"scripted", "soft", "firm"};
}

/// Goal for the relative difference of k_max from the exact proxy's.
constexpr double kKMaxShare = 0.15;

/// Prints k_max over the exact proxy's by place, method and guard, with the spread over sets of seeds.
void print_ratios(const std::vector<Row>& rows) {
  struct Ratios {
    std::vector<double> own, first;
    int exact_none = 0;   // cells in which the exact proxy is stable at no stiffness
    int more = 0;         // cells that needed more than a set of seeds
    double spread = 0.0;  // of the exact proxy's k_max over its sets, as a share of the median
    double fed_mj = 0.0, energy_mj = 0.0;
  };
  std::map<std::tuple<std::string, std::string, std::string>, Ratios> all;
  for (const Row& r : rows) {
    if (std::isnan(r.k_max_n_per_mm)) continue;
    Ratios& of = all[{r.case_name, r.method, r.guard}];
    if (!(r.k_exact_n_per_mm > 0.0)) {
      ++of.exact_none;
      continue;
    }
    const double ratio = r.k_max_n_per_mm / r.k_exact_n_per_mm;
    of.own.push_back(ratio);
    of.first.push_back(r.k_sets > 1 ? r.k_first_n_per_mm / r.k_exact_first_n_per_mm : ratio);
    if (r.k_sets > 1) {
      ++of.more;
      of.spread = std::fmax(of.spread, (r.k_exact_most_n_per_mm - r.k_exact_least_n_per_mm) / r.k_exact_n_per_mm);
    }
    of.fed_mj = std::fmax(of.fed_mj, r.energy_mj - r.energy_exact_mj);
    of.energy_mj = std::fmax(of.energy_mj, r.energy_mj);
  }
  if (all.empty()) return;
  const auto off = [](const std::vector<double>& ratios) {
    return std::ranges::count_if(ratios, [](double r) { return std::fabs(r - 1.0) > kKMaxShare; });
  };
  fmt::print("\nk_max over the exact proxy's. more: cells with medians of five sets of seeds. first: beyond 15 % by the first "
             "set alone. spread: largest spread of the exact proxy's k_max over sets\n");
  fmt::print("{:<9}{:<17}{:<6}{:>6}{:>6}{:>6}{:>8}{:>8}{:>8}{:>7}{:>7}{:>9}{:>12}{:>9}\n", "case", "method", "guard", "cells",
             "none", "more", "min", "median", "max", ">15 %", "first", "spread", "mJ beyond", "mJ");
  for (auto& [key, of] : all) {
    fmt::print("{:<9}{:<17}{:<6}{:>6}{:>6}{:>6}", std::get<0>(key), std::get<1>(key), std::get<2>(key), of.own.size(),
               of.exact_none, of.more);
    if (!of.own.empty()) {
      std::ranges::sort(of.own);
      fmt::print("{:>8.3f}{:>8.3f}{:>8.3f}{:>7}{:>7}{:>7.0f} %", of.own.front(), of.own[of.own.size() / 2], of.own.back(),
                 off(of.own), off(of.first), 100.0 * of.spread);
    }
    fmt::print("{:>12.5f}{:>9.4f}\n", of.fed_mj, of.energy_mj);
  }
}

void print_stability(const std::vector<Row>& rows) {
  fmt::print(
      "{:<18}{:<17}{:<6}{:<11}{:<9}{:>5}{:>6}{:>7}{:>7}{:>8}{:>8}{:>9}{:>9}{:>8}{:>7}{:>8}{:>8}{:>8}{:>8}{:>9}\n",
      "case", "method", "guard", "device", "grip", "f N", "ms", "voxel", "runs", "k_max", "k_exact", "mJ", "exact mJ",
      "um", "Hz", "step mN", "p99", "guarded", "deep um", "passed");
  const auto number = [](double v) { return std::isnan(v) ? std::string("-") : fmt::format("{:.3g}", v); };
  for (const Row& r : rows) {
    fmt::print(
        "{:<18}{:<17}{:<6}{:<11}{:<9}{:>5}{:>6}{:>7}{:>7}{:>8}{:>8}{:>9}{:>9}{:>8}{:>7}{:>8}{:>8}{:>8}{:>8}{:>9}",
        r.case_name, r.method, r.guard, r.device, r.grip, number(r.friction_n), number(r.delay_ms), number(r.voxel_mm),
        r.runs, number(r.k_max_n_per_mm), number(r.k_exact_n_per_mm), number(r.energy_mj), number(r.energy_exact_mj),
        number(r.cycle_um), number(r.cycle_hz), number(r.force_step_mn), number(r.force_step_p99_mn),
        number(r.guard_step_mn), number(r.penetration_um), r.passed_through);
    if (r.stuck > 0) fmt::print("  stuck {} times, {} ms", r.stuck, number(r.stuck_ms));
    if (!std::isnan(r.vibration_mn)) fmt::print("  vibration {} mN", number(r.vibration_mn));
    if (!std::isnan(r.zero_ms))
      fmt::print("  zero after {} ms, back after {} to {}", number(r.zero_ms), number(r.back_ms), number(r.back_share));
    if (!std::isnan(r.energy_left_mj))
      fmt::print("  {:.3f} mJ, exact {:.3f}, less late energy", r.energy_left_mj, r.energy_exact_left_mj);
    fmt::print("\n");
  }
  print_ratios(rows);
}

/// Rows of the damping chart: the surface proxy on a face, guard off, no delay.
void sweep_damping(CaseRun what, const Options& options, std::vector<Row>& rows) {
  if (!asked(options.cases, "face") || !asked(options.methods, key_of(Method::surface)) ||
      !asked(options.guards, "off") || !options.voxels_mm.empty() || !options.bur_radii_mm.empty())
    return;
  what.key = "face";
  what.method = Method::surface;
  what.guard = GuardUse::off;
  what.voxel_mm = kUsualVoxelMm;
  what.bur_radius_mm = 0.25;
  for (const double damping : {0.5, 2.0, 5.0})
    for (const double friction : {0.0, 0.1})
      for (const std::string_view grip : {"none", "soft", "firm"}) {
        what.setting = {0.1, damping, friction, 0.0, grip};
        rows.push_back(press_row(what));
      }
}

/// Voxel sizes of a case.
std::vector<double> voxels_of(std::string_view key, const Options& options) {
  if (key == "voxel-size") return chosen(options.voxels_mm, {0.2, 0.1, kUsualVoxelMm, 0.04});
  if (key == "thin-wall") return chosen(options.voxels_mm, {kUsualVoxelMm, 0.04});
  return chosen(options.voxels_mm, {kUsualVoxelMm});
}

}  // namespace

Setting usual_setting() { return {0.1, 2.0, 0.0, 1.0, "soft"}; }

std::vector<std::string> device_names() {
  std::vector<std::string> out;
  for (const Device& d : kDevices) out.push_back(device_name(d.mass_kg, d.damping_ns_per_m));
  return out;
}

namespace {

std::vector<Row> measured_rows(const Options& options) {
  std::vector<Row> rows;
  CaseRun what;
  what.seed = options.seed;
  what.budget_s = options.budget_s;
  what.settle = options.full;
  // Methods of one reading share a specimen, so they run in sequence.
  const auto each = [&](std::string_view key, const std::vector<Setting>& settings, const std::vector<double>& voxels,
                        auto&& run) {
    if (!asked(options.cases, key)) return;
    what.key = key;
    for (const double voxel : voxels)
      for (const Method method : kMethods) {
        if (!asked(options.methods, key_of(method))) continue;
        for (const GuardUse guard : {GuardUse::on, GuardUse::off}) {
          if (!asked(options.guards, guard == GuardUse::on ? "on" : "off")) continue;
          for (const Setting& setting : settings) {
            what.voxel_mm = voxel;
            what.method = method;
            what.guard = guard;
            what.setting = setting;
            rows.push_back(run(what));
          }
        }
      }
  };
  const std::vector<std::string_view> soft{"soft"}, every{"none", "soft", "firm"}, scripted{"scripted"};
  for (std::string_view name : kPressCases)
    // The pit has hundreds of contact points at 0.5 mm.
    for (const double radius : chosen(options.bur_radii_mm, {name == "pit" ? 0.5 : 0.25})) {
      what.bur_radius_mm = radius;
      each(name, settings_of(options.grips.empty() && !options.full ? soft : every, options), voxels_of(name, options),
           press_row);
    }
  if (options.full) {
    for (Row& row : rows) row.sweep = kFullSweep;
    return rows;
  }
  if (options.grips.empty() && !asks_for_a_device(options)) sweep_damping(what, options, rows);
  for (const double radius : chosen(options.bur_radii_mm, {0.25})) {
    what.bur_radius_mm = radius;
    what.budget_s = kMotionShare * options.budget_s;
    const auto way = [&options](CaseRun one) {
      // Ten thousand approaches at the usual budget.
      if (one.key == "thin-wall" && one.method == Method::surface) one.budget_s = kWallShare * options.budget_s;
      return run_case(one);
    };
    for (std::string_view name : kMotionCases)
      each(name, settings_of(grips_of(name), options), voxels_of(name, options), way);
    for (std::string_view name : kFaultCases)
      each(name, settings_of(scripted, options), voxels_of(name, options), run_case);
  }
  what.bur_radius_mm = 0.5;
  for (std::string_view name : kTaskCases) each(name, settings_of(scripted, options), {kUsualVoxelMm}, run_case);
  return rows;
}

}  // namespace

std::vector<Row> stability_rows(const Options& options) {
  std::vector<Row> rows = measured_rows(options);
  for (Row& row : rows) row.failures = names_of(failures_of(row));
  return rows;
}

int run_stability(const Options& options) {
  Report report = empty_report();
  report.rows = stability_rows(options);
  return write_report(report, options.json, print_stability);
}

}  // namespace cusp::bench
