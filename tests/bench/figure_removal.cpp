#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "tests/bench/figures.h"
#include "tests/bench/looks.h"
#include "tests/bench/options.h"
#include "tests/bench/plot.h"
#include "tests/bench/removal.h"

namespace cusp::bench {

namespace {

constexpr Method kShown[] = {Method::surface, Method::occupancy};
constexpr double kLeastPercent = 1e-3;  // what is below stands at the frame's foot
constexpr double kSurfaceGoal = 1.0, kOccupancyGoal = 5.0;  // percent

bool is(const Row& row, std::string_view measure, Method method) {
  return row.measure == measure && row.method == key_of(method);
}
double size_of(double percent) { return std::clamp(std::fabs(percent), kLeastPercent, 100.0); }

int axes_of(const Row& row) {
  for (const Direction& d : directions())
    if (d.name == row.direction) return d.axes;
  return 1;
}

/// Largest size of a value over the rows that are meant; nothing where there is none.
template <class Meant>
double worst(const Report& report, double Row::* field, Meant&& meant) {
  double most = kAbsent;
  for (const Row& row : report.rows)
    if (meant(row) && !std::isnan(row.*field)) most = std::fmax(std::isnan(most) ? 0.0 : most, std::fabs(row.*field));
  return most;
}

/// Of the ridge, the most that is gone: less than wear allows is negative and no fault.
double most_ridge(const Report& removal) {
  double most = kAbsent;
  for (const Row& row : removal.rows)
    if (is(row, "ridge", Method::surface) && !row.unresolved && !std::isnan(row.ridge_um)) most = std::fmax(most, row.ridge_um);
  return most;
}

}  // namespace

Picture depth_over_time(const Report& removal) {
  const std::string title = "Depth over time through three materials";
  Svg svg(860.0, 560.0, title,
          "Depth of the burr's tip over time, drilling through dentine, bone and enamel, with the surface proxy and with "
          "the occupancy proxy; the wanted slopes beside. After the paper's figure 15.");
  double end = 0.0;
  for (const Method method : kShown) {
    std::vector<Point> line;
    for (const Row& row : removal.rows)
      if (is(row, "depth", method)) end = std::max(end, row.time_s);
    for (std::size_t layer = 0; layer < kRemovalMaterials.size(); ++layer)
      if (std::isnan(slope_in(removal.rows, key_of(method), layer)))
        return fail(ChartError::missing_rows, fmt::format("removal: depth of {} in {}", key_of(method), kRemovalTissues[layer]));
  }
  heading(svg, title,
          fmt::format("Full push, 1 kHz, a point every 25 ms; ball burr of {} mm radius, 128\u00b3 voxels in 10 mm, three "
                      "layers of 3.33 mm. Depth downwards.",
                      kDepthBurrMm));
  // Down is down: depths are drawn below zero, and lettered without the sign.
  Axis depth = even("depth of the burr's tip, mm", -10.0, 0.0, 2.0);
  for (auto& [value, text] : depth.ticks) text = value == 0.0 ? "0" : fmt::format("{:g}", -value);
  Plot plot(svg, {76.0, 96.0}, {836.0, 480.0}, even("seconds", 0.0, 2.0 * std::ceil(0.5 * end) + 2.0, 2.0), depth);
  for (std::size_t layer = 1; layer < 3; ++layer) {
    const double z = -static_cast<double>(layer) * kLayerMm;
    svg.line(plot.at(0.0, z), {plot.bottom_right().x, plot.at(0.0, z).y}, {ink::kQuiet, 1.0, "3 3"});
  }
  for (const Method method : kShown) {
    std::vector<Point> line;
    for (const Row& row : removal.rows)
      if (is(row, "depth", method)) line.push_back({row.time_s, -row.depth_mm});
    plot.path(line, {look_of(method).colour, method == Method::surface ? 2.4 : 1.6, method == Method::surface ? "" : "6 3"});
    // A mark each second tells the lines apart without their colour.
    for (std::size_t i = method == Method::surface ? 20 : 40; i < line.size(); i += 40)
      plot.mark(look_of(method).mark, line[i].x, line[i].y, 7.0, look_of(method).colour);
  }
  // The wanted slope of each layer beside the surface proxy's line, half a second on.
  for (std::size_t layer = 0; layer < 3; ++layer) {
    const double v = kRemovalMaterials[layer].speed_mm_s, top = static_cast<double>(layer) * kLayerMm;
    double begin = 0.0;
    for (const Row& row : removal.rows)
      if (is(row, "depth", Method::surface) && row.depth_mm <= top + 0.6) begin = row.time_s;
    const Point a = plot.at(begin + 0.6, -(top + 0.6)), b = plot.at(begin + 0.6 + (kLayerMm - 0.8) / v, -(top + kLayerMm - 0.2));
    svg.line(a, b, {ink::kText, 1.4, "2 3"});
    const std::string text = fmt::format("{}: wanted {:g} mm/s, surface {:.4g}, occupancy {:.4g}", kRemovalTissues[layer],
                                         v, slope_in(removal.rows, key_of(Method::surface), layer),
                                         slope_in(removal.rows, key_of(Method::occupancy), layer));
    const double x = std::min(0.5 * (a.x + b.x) + 12.0, plot.bottom_right().x - 1.06 * text_width(text, 12.0));
    svg.text({x, a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x) - 8.0}, text, {.size = 12.0, .bold = true});
  }
  footing(svg, fmt::format("{}, commit {:.10}. Whole, circles: surface proxy. Dashed, squares: occupancy proxy, the paper's "
                           "method. Dotted: the wanted slopes.",
                           removal.machine, removal.commit));
  return svg.str();
}

Picture speed_error(const Report& removal) {
  const std::string title = "Error of the drilling speed against voxel size, tick and direction";
  Svg svg(860.0, 520.0, title,
          "Three panels of errors in percent, logarithmic: by voxel size, by tick length, by how many axes the direction goes "
          "along; a mark for each run of the surface proxy and of the occupancy proxy.");
  struct Group {
    std::string name;
    double value;
  };
  struct Panel {
    std::string title;
    std::vector<Group> groups;
    double (*value)(const Row&);
    double left;
  };
  std::vector<Panel> panels = {
      {"voxel, mm", {}, [](const Row& r) { return r.voxel_mm; }, 76.0},
      {"tick, ms", {}, [](const Row& r) { return r.tick_ms; }, 340.0},
      {"direction: along so many axes", {{"1", 1}, {"2", 2}, {"3", 3}}, [](const Row& r) { return static_cast<double>(axes_of(r)); }, 604.0}};
  for (const Method method : kShown) {
    int count = 0;
    for (const Row& row : removal.rows) {
      if (!is(row, "speed", method) || std::isnan(row.error_percent)) continue;
      ++count;
      for (std::size_t p = 0; p < 2; ++p) {
        const double v = panels[p].value(row);
        if (std::ranges::none_of(panels[p].groups, [v](const Group& g) { return same(g.value, v); }))
          panels[p].groups.push_back({short_number(v), v});
      }
    }
    if (count == 0) return fail(ChartError::missing_rows, fmt::format("removal: speed of {}", key_of(method)));
  }
  heading(svg, title,
          "Every pair of voxel, tick, direction, tissue, push and burr, a mark a run; read off the surface that is left. "
          "Logarithmic.");
  for (Panel& panel : panels) {
    std::ranges::sort(panel.groups, {}, &Group::value);
    Axis across;
    across.low = 0.0;
    across.high = static_cast<double>(panel.groups.size());
    across.title = panel.title;
    for (std::size_t g = 0; g < panel.groups.size(); ++g) across.ticks.emplace_back(static_cast<double>(g) + 0.5, panel.groups[g].name);
    Axis percent = decades(panel.left < 100.0 ? "error, %" : "", {kLeastPercent, 100.0});
    if (panel.left > 100.0)
      for (auto& [value, text] : percent.ticks) text.clear();
    Plot plot(svg, {panel.left, 96.0}, {panel.left + 232.0, 440.0}, across, percent);
    for (const auto& [goal, method] : {std::pair{kSurfaceGoal, Method::surface}, {kOccupancyGoal, Method::occupancy}})
      svg.line(plot.at(0.0, goal), plot.at(across.high, goal), {look_of(method).colour, 1.2, "5 4"});
    for (const Method method : {Method::occupancy, Method::surface}) {
      std::vector<int> placed(panel.groups.size(), 0);
      for (const Row& row : removal.rows) {
        if (!is(row, "speed", method) || std::isnan(row.error_percent)) continue;
        for (std::size_t g = 0; g < panel.groups.size(); ++g) {
          if (!same(panel.groups[g].value, panel.value(row))) continue;
          // Side by side in ten places, the surface proxy on the left.
          const double aside = 0.04 * (placed[g]++ % 10);
          const double x = static_cast<double>(g) + (method == Method::surface ? 0.08 : 0.54) + aside;
          plot.mark(look_of(method).mark, x, size_of(row.error_percent), 5.0, look_of(method).colour, row.unresolved);
        }
      }
    }
  }
  footing(svg, fmt::format("{}, commit {:.10}. Circles: surface proxy, wanted within 1 %. Squares: occupancy proxy, 5 % along an "
                           "axis. Hollow: radius under 3 voxels.",
                           removal.machine, removal.commit));
  return svg.str();
}

Picture removal_table(const Report& removal) { return removal_table_with(removal, {}); }

Picture removal_table_with(const Report& removal, const Report& full) {
  const auto every = [&](std::string_view measure, Method method, double Row::* field) {
    return worst(removal, field, [&](const Row& r) { return is(r, measure, method) && !r.unresolved; });
  };
  const auto as_in_the_paper = [](const Row& r) {
    return is(r, "speed", Method::occupancy) && axes_of(r) == 1 && same(r.tick_ms, 1.0) && same(r.alpha, 1.0);
  };
  const auto percent = [](double v) { return fmt::format("{:.2g} %", v); };
  const auto um = [](double v) { return fmt::format("{:.2g} \u00b5m", v); };
  struct Line {
    std::string what, goal;
    double value;
    std::string text, occupancy;
  };
  const double speed = every("speed", Method::surface, &Row::error_percent),
               elsewhere = every("speed", Method::occupancy, &Row::error_percent),
               axes = worst(removal, &Row::error_percent, as_in_the_paper);
  const auto cost = [&](Method m) { return every("tick", m, &Row::tick_us_p99); };
  const double mixed = every("mixed", Method::surface, &Row::error_percent),
               order = every("order", Method::surface, &Row::error_percent),
               mean = every("shape", Method::surface, &Row::deviation_um_mean),
               most = every("shape", Method::surface, &Row::deviation_um_max),
               excess = every("slide", Method::surface, &Row::excess_um_max),
               ridge = most_ridge(removal),
               stroke = every("volume", Method::surface, &Row::error_percent);
  std::vector<Line> lines = {
      {"drilling speed, every pair of voxel, tick, direction, tissue, push and burr", "1 %", speed, percent(speed),
       percent(elsewhere) + (std::isnan(axes) ? "" : "; along the axes at 1 ms and full push " + percent(axes))},
      {"half in one tissue, half in another: harmonic mean", "2 %", mixed, percent(mixed), "\u2013"},
      {"the same path in halves, or in other ticks: volume", "0.1 %", order, percent(order), "\u2013"},
      {"shape left by known strokes at 1, 50 and 200 mm/s, mean", "0.5 \u00b5m", mean, um(mean), "\u2013"},
      {"and at most", "10 \u00b5m", most, um(most), "\u2013"},
      {"sliding while cutting: beyond what wear allows a tick, at most", "0.5 \u00b5m", excess, um(excess), "\u2013"},
      {"a ridge between two cuts, after 40 passes over it", "5 \u00b5m", ridge, um(ridge), "\u2013"},
      {"a cutting tick with the largest burr, p99", "250 \u00b5s", cost(Method::surface),
       fmt::format("{:.0f} \u00b5s", cost(Method::surface)), fmt::format("{:.0f} \u00b5s", cost(Method::occupancy))}};
  std::set<std::string> burrs;
  for (const Row& row : removal.rows)
    if (row.measure == "shape") burrs.insert(row.burr);
  // Tables from before strokes were weighed have no such rows.
  if (!std::isnan(stroke))
    lines.insert(lines.begin() + 3, {"volume of one stroke, with every shape of burr", "0.5 %", stroke, percent(stroke), "\u2013"});
  // What --full found, where it was run: it stands below the line that it widens.
  const auto of_full = [&](std::string_view measure, double Row::* field) {
    return worst(full, field, [&](const Row& r) { return is(r, measure, Method::surface) && !r.unresolved; });
  };
  const auto beside = [&](std::string_view below, std::string what, std::string goal, double value, std::string text) {
    const auto at = std::ranges::find(lines, below, &Line::what);
    if (!std::isnan(value) && at != lines.end()) lines.insert(at + 1, {std::move(what), std::move(goal), value, std::move(text), "\u2013"});
  };
  const auto count = [&](std::string_view measure) {
    return std::ranges::count_if(full.rows, [&](const Row& r) { return is(r, measure, Method::surface); });
  };
  const std::string speeds = lines.front().what, most_line = "and at most", volume_line = "volume of one stroke, with every shape of burr";
  std::set<std::string> shaped;
  for (const Row& row : full.rows)
    if (row.measure == "shape") shaped.insert(row.burr);
  const double full_speed = of_full("speed", &Row::error_percent), full_stroke = of_full("volume", &Row::error_percent),
               full_mean = of_full("shape", &Row::deviation_um_mean), full_most = of_full("shape", &Row::deviation_um_max);
  beside(speeds, fmt::format("all {} of the 1.0 mm round burr at 0.1 mm", count("speed")), "1 %", full_speed, percent(full_speed));
  beside(volume_line, fmt::format("with all {} burrs", shaped.size()), "0.5 %", full_stroke, percent(full_stroke));
  beside(most_line, fmt::format("all {} burrs, at most", shaped.size()), "10 \u00b5m", full_most, um(full_most));
  beside(most_line, fmt::format("all {} burrs, mean", shaped.size()), "0.5 \u00b5m", full_mean, um(full_mean));
  std::string out = "| the worst of | wanted | surface proxy (Cusp) | occupancy proxy (the paper) |\n|---|---|---|---|\n";
  for (const Line& line : lines) {
    if (std::isnan(line.value)) return fail(ChartError::missing_rows, "removal: " + line.what);
    out += fmt::format("| {} | {} | {} | {} |\n", line.what, line.goal, line.text, line.occupancy);
  }
  const std::string of_the_full = full.rows.empty() || full.commit == removal.commit ? "" : fmt::format(" (--full: {:.10})", full.commit);
  return out + fmt::format("\n{}, commit {:.10}{}: round burrs of 0.5 to 2.3 mm and a fissure of 1.0 mm, voxels of 0.04 to 0.2 mm; burrs under three voxels "
                           "of radius are left out.{}\n",
                           removal.machine, removal.commit, of_the_full,
                           std::isnan(stroke) ? "" : fmt::format(" Shapes and volumes of strokes: {} burrs.", burrs.size()));
}

}  // namespace cusp::bench
