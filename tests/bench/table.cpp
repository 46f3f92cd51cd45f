#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>

#include "tests/bench/figures.h"
#include "tests/bench/looks.h"
#include "tests/bench/options.h"
#include "tests/bench/plot.h"
#include "tests/bench/rate.h"
#include "tests/bench/stability.h"
#include "tests/bench/verdict.h"

namespace cusp::bench {

namespace {

constexpr double kRadii[] = {0.25, 0.5};

/// Mean of a value over the rows that are meant; nothing where there are none.
std::optional<double> mean(const Report& report, const std::function<bool(const Row&)>& meant,
                           const std::function<double(const Row&)>& value) {
  double sum = 0.0;
  int count = 0;
  for (const Row& row : report.rows) {
    if (!meant(row) || std::isnan(value(row))) continue;
    sum += value(row);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

std::string small(double value) {
  return value < 1e-4 ? "< 0.0001" : value < 100.0 ? fmt::format("{:.2g}", value) : fmt::format("{:.0f}", value);
}

}  // namespace

Picture method_table(const Report& accuracy, const Report& rate) {
  std::string out =
      "| ball burr r 0.25 · 0.5 mm | exploring, updates/s | over occupancy | mean angle error, degrees | mean depth "
      "error, "
      "µm | drilling, updates/s |\n|---|---|---|---|---|---|\n";
  for (const Method method :
       {Method::surface, Method::gradient, Method::penalty, Method::ray, Method::occupancy, Method::occupancy_pivot}) {
    std::string cells[5];
    for (const double radius : kRadii) {
      const auto usual = [&](const Row& row) {
        return row.method == key_of(method) && same(row.burr_radius_mm, radius) && same(row.voxel_mm, kRateVoxelMm);
      };
      const auto exploring = [&](const Row& row) {
        return usual(row) && row.task == "exploration" && row.shape != "channel" && same(row.speed_mm_s, kRateSpeedMmS);
      };
      const auto drilling = [&](const Row& row) { return usual(row) && row.task == "perforation"; };
      const auto sliding = [&](const Row& row) {
        return usual(row) && row.task.empty() && row.motion == "slide" && same(row.speed_mm_s, kRateSpeedMmS) &&
               (row.shape == "face" || row.shape == "sphere");
      };
      const auto tick = mean(rate, exploring, [](const Row& r) { return 1.0 / r.updates_per_s; });
      const auto ratio = mean(rate, exploring, [](const Row& r) { return r.ratio_to_occupancy; });
      const auto angle = mean(accuracy, sliding, [](const Row& r) { return r.angle_deg_mean; });
      const auto depth = mean(accuracy, sliding, [](const Row& r) { return r.depth_um_mean; });
      const auto drill = mean(rate, drilling, [](const Row& r) { return 1.0 / r.updates_per_s; });
      if (!tick || !ratio || !drill)
        return fail(ChartError::missing_rows, fmt::format("rate: {} with a burr of {} mm", key_of(method), radius));
      if (!angle || !depth)
        return fail(ChartError::missing_rows, fmt::format("accuracy: {} with a burr of {} mm", key_of(method), radius));
      const std::string values[] = {short_number(1.0 / *tick), fmt::format("{:.2g}×", *ratio), small(*angle),
                                    small(*depth), short_number(1.0 / *drill)};
      for (std::size_t i = 0; i < 5; ++i) cells[i] += (cells[i].empty() ? "" : " · ") + values[i];
    }
    out += fmt::format("| {} |", look_of(method).label);
    for (const std::string& cell : cells) out += ' ' + cell + " |";
    out += '\n';
  }
  return out + fmt::format(
                   "\n{}, one core, commits {:.10} (accuracy) and {:.10} (rate): voxels of 10/128 mm, 0.3 mm below the "
                   "offset surface at 50 mm/s; rates are means over face, sphere and cylinder, errors over face and "
                   "sphere; drilling at 1 mm/s with all its upkeep.\n",
                   accuracy.machine, accuracy.commit, rate.commit);
}

Picture stability_table(const Report& stability) {
  std::string out =
      "| guard on | stiffest stable wall over the exact proxy's | fell through a 0.2 mm wall | stuck | force step p99 "
      "· "
      "most, mN | fed beyond the exact proxy, mJ | vibration in the paper's tasks, mN | cases survived "
      "|\n|---|---|---|---|---|---|---|---|\n";
  const Setting usual = usual_setting();
  for (const Method method :
       {Method::surface, Method::gradient, Method::penalty, Method::ray, Method::occupancy, Method::occupancy_pivot}) {
    double least = std::numeric_limits<double>::infinity(), most = 0.0, step = 0.0, p99 = 0.0, fed = 0.0,
           vibration = 0.0;
    std::int64_t through = 0, approaches = 0, stuck = 0;
    std::map<std::string, bool> survived;
    for (const Row& row : stability.rows) {
      if (row.method != key_of(method) || row.guard != "on" || row.unresolved) continue;
      const bool swept = !std::isnan(row.k_max_n_per_mm) &&
                         (row.device != device_name(usual.mass_kg, usual.damping_ns_per_m) || row.grip != usual.grip ||
                          row.friction_n != usual.friction_n || row.delay_ms != usual.delay_ms);
      if (swept) continue;
      if (!std::isnan(row.k_max_n_per_mm)) {
        least = std::min(least, row.k_max_n_per_mm / row.k_exact_n_per_mm);
        most = std::max(most, row.k_max_n_per_mm / row.k_exact_n_per_mm);
      }
      if (row.case_name == "thin-wall") {
        through += row.passed_through;
        approaches += row.runs;
      }
      stuck += std::max<std::int64_t>(0, row.stuck);
      if (!std::isnan(row.force_step_mn)) step = std::max(step, row.force_step_mn);
      if (!std::isnan(row.force_step_p99_mn)) p99 = std::max(p99, row.force_step_p99_mn);
      if (!std::isnan(row.energy_mj)) fed = std::max(fed, row.energy_mj - row.energy_exact_mj);
      if (!std::isnan(row.vibration_mn)) vibration = std::max(vibration, row.vibration_mn);
      const auto [at, fresh] = survived.try_emplace(row.case_name, true);
      at->second = at->second && breaks_of(row).empty();
    }
    if (!(least <= most) || approaches == 0)
      return fail(ChartError::missing_rows, fmt::format("stability: {}, guard on", key_of(method)));
    const auto whole = std::ranges::count_if(survived, [](const auto& s) { return s.second; });
    out += fmt::format("| {} | {:.2g}\u00d7 to {:.2g}\u00d7 | {} of {} | {} | {} \u00b7 {} | {} | {} | {} of {} |\n",
                       look_of(method).label, least, most, through, approaches,
                       stuck == 0 ? "never" : fmt::format("{} times", stuck), small(p99), small(step), small(fed),
                       small(vibration), whole, survived.size());
  }
  return out +
         fmt::format(
             "\n{}, commit {:.10}: {:g} kg, {:g} N s/m, {:g} ms there and back [M]; the worst over every case, hand "
             "and voxel size.\n",
             stability.machine, stability.commit, usual.mass_kg, usual.damping_ns_per_m, usual.delay_ms);
}

}  // namespace cusp::bench
