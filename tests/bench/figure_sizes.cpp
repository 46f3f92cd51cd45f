#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "tests/bench/figures.h"
#include "tests/bench/looks.h"
#include "tests/bench/options.h"
#include "tests/bench/plot.h"
#include "tests/bench/rate.h"

namespace cusp::bench {

namespace {

using Series = std::vector<std::pair<double, double>>;

std::vector<Point> points_of(const Series& series) {
  std::vector<Point> out;
  for (const auto& [x, y] : series) out.push_back({x, y});
  return out;
}

/// Mean error of the surface proxy by voxel size, coarse to fine, over all motions measured there with one burr.
Series errors(const Report& report, std::string_view shape, double radius, double Row::* field) {
  std::map<double, std::pair<double, int>, std::greater<>> sums;
  for (const Row& row : report.rows) {
    if (row.method != "surface" || row.shape != shape || row.unresolved || !row.task.empty() ||
        !same(row.burr_radius_mm, radius) || std::isnan(row.*field))
      continue;
    auto& [sum, count] = sums[row.voxel_mm];
    sum += row.*field;
    ++count;
  }
  Series out;
  for (const auto& [voxel, s] : sums)
    if (s.first > 0.0) out.emplace_back(voxel, s.first / s.second);
  return out;
}

constexpr double kTold = 1.25;  // an error that much over the floor can be told from it

/// What the form adds to the floor, where it can be told from it: the two add up as squares do.
Series above(const Series& errors, const Series& floor) {
  Series out;
  for (const auto& [h, e] : errors)
    for (const auto& [voxel, f] : floor)
      if (same(h, voxel) && e > kTold * f) out.emplace_back(h, std::sqrt(e * e - f * f));
  return out;
}

/// The fitted order of what the form adds, as words: a bound where only the coarsest voxel stands above the floor.
std::string order_of(const Series& errors, const Series& floor) {
  const Series form = above(errors, floor);
  if (form.size() > 1) return fmt::format("order {:.1f}", fitted_order(form));
  if (form.empty() || form.front().first != errors.front().first || errors.size() < 2) return "as the face";
  const double finer = errors[1].first;
  for (const auto& [voxel, f] : floor)
    if (same(voxel, finer))
      return fmt::format("order {:.1f} or more",
                         fitted_order({form.front(), {finer, f * std::sqrt(kTold * kTold - 1.0)}}));
  return "";
}

/// Ticks by burr radius: the mean of 1 / updates a second over the shapes explored, in us.
Series cost_by_radius(const Report& rate, std::string_view method) {
  std::map<double, std::pair<double, int>> sums;
  for (const Row& row : rate.rows) {
    if (row.method != method || row.task != "exploration" || row.shape == "channel" || row.volume_voxels >= 0 ||
        !same(row.voxel_mm, kRateVoxelMm) || !same(row.speed_mm_s, kRateSpeedMmS) || std::isnan(row.updates_per_s))
      continue;
    auto& [sum, count] = sums[row.burr_radius_mm];
    sum += 1e6 / row.updates_per_s;
    ++count;
  }
  Series out;
  for (const auto& [radius, s] : sums) out.emplace_back(radius, s.first / s.second);
  return out;
}

Series by_volume(const Report& scale, std::string_view method, std::string_view variant, auto&& value) {
  Series out;
  for (const Row& row : scale.rows)
    if (row.method == method && row.variant == variant && row.volume_voxels > 0)
      out.emplace_back(std::cbrt(static_cast<double>(row.volume_voxels)), value(row));
  std::ranges::sort(out);
  return out;
}

Axis lettered(std::string title, double low, double high, std::vector<double> at) {
  Axis out;
  out.low = low;
  out.high = high;
  out.log = true;
  out.title = std::move(title);
  for (const double v : at) out.ticks.emplace_back(v, v < 1000.0 ? fmt::format("{:.3g}", v) : fmt::format("{:.0f}", v));
  return out;
}

void draw(Plot& plot, const Series& series, Look look) {
  plot.path(points_of(series), {look.colour, 2.0, ""});
  for (const auto& [x, y] : series) plot.mark(look.mark, x, y, 9.0, look.colour);
}

}  // namespace

double fitted_order(const std::vector<std::pair<double, double>>& h_and_error) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const auto& [h, error] : h_and_error) {
    const double a = std::log(h), b = std::log(error);
    n += 1.0;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

Picture error_against_voxel(const Report& accuracy) {
  constexpr double kRadius = 0.5;
  struct Curve {
    std::string_view shape;
    Look look;
  };
  constexpr Look kFloor{"face", ink::kQuiet, Mark::diamond};
  const Curve curves[] = {{"sphere", {"sphere, R 4 mm", ink::kBlue, Mark::circle}},
                          {"cylinder", {"cylinder, R 2 mm", ink::kVermilion, Mark::square}}};
  struct Panel {
    double Row::* field;
    std::string title;
    double left;
  };
  const Panel panels[] = {{&Row::angle_deg_mean, "mean angle error, degrees", 76.0},
                          {&Row::depth_um_mean, "mean depth error, \u00b5m", 502.0}};
  const std::string title = "Error of the surface proxy against the voxel size";
  Svg svg(
      860.0, 500.0, title,
      "Mean angle error and mean depth error of the surface proxy on a sphere, a cylinder and a face for voxels of 0.2 "
      "to 0.04 mm, with the fitted order of convergence above the face's error.");
  heading(svg, title,
          "Ball burr of 0.5 mm radius, presses and slides. A face has no form to miss: its error is what 16 bits of s "
          "leave.");
  for (const Panel& panel : panels) {
    const Series floor = errors(accuracy, "face", kRadius, panel.field);
    std::vector<double> all;
    for (const auto& [h, e] : floor) all.push_back(e);
    for (const Curve& curve : curves) {
      const Series series = errors(accuracy, curve.shape, kRadius, panel.field);
      if (series.size() < 2)
        return fail(
            ChartError::missing_rows,
            fmt::format("accuracy: surface on {} with a burr of 0.5 mm at two voxel sizes at least", curve.shape));
      for (const auto& [h, e] : series) all.push_back(e);
    }
    Axis y = decades(panel.title, all);
    Plot plot(svg, {panel.left, 72.0}, {panel.left + 334.0, 420.0},
              lettered("voxel, mm", 0.034, 0.55, {0.04, 0.078, 0.1, 0.2}), y);
    draw(plot, floor, kFloor);
    for (const Curve& curve : curves) draw(plot, errors(accuracy, curve.shape, kRadius, panel.field), curve.look);
    // Second order, in the frame's upper left, where no error stands.
    const double e1 = y.low * std::pow(y.high / y.low, 0.93);
    const std::vector<Point> wedge = {{0.04, 0.25 * e1}, {0.08, 0.25 * e1}, {0.08, e1}, {0.04, 0.25 * e1}};
    plot.path(wedge, {"#AEB6BE", 1.4, ""});
    plot.label(plot.at(0.08, 0.5 * e1), 5.0, "order 2", {.size = 12.0, .colour = ink::kQuiet});
    // Named at their coarse ends, moved apart where they meet.
    struct Name {
      double y;
      std::string text, order;
    };
    std::vector<Name> names;
    const double right = plot.at(0.2, y.low).x + 12.0;
    for (const Curve& curve : curves) {
      const Series series = errors(accuracy, curve.shape, kRadius, panel.field);
      names.push_back({plot.at(series.front().first, series.front().second).y, std::string(curve.look.label),
                       order_of(series, floor)});
    }
    if (!floor.empty()) names.push_back({plot.at(floor.front().first, floor.front().second).y, "face", ""});
    std::ranges::sort(names, {}, &Name::y);
    double least = -1e9;
    for (const Name& name : names) {
      const double at = std::max(name.y, least);
      svg.text({right, at + 4.0}, name.text, {.size = 12.5, .bold = true});
      if (!name.order.empty()) svg.text({right, at + 19.0}, name.order, {.size = 12.5, .colour = ink::kQuiet});
      least = at + (name.order.empty() ? 17.0 : 34.0);
    }
  }
  footing(svg,
          fmt::format(
              "{}, commit {:.10}. Circles: sphere. Squares: cylinder. Diamonds: face. Order: slope of what exceeds the "
              "face's error.",
              accuracy.machine, accuracy.commit));
  return svg.str();
}

Picture cost_against_size(const Report& rate, const Report& scale) {
  constexpr Method kShown[] = {Method::surface, Method::occupancy};
  const auto cost = [](const Row& row) { return row.cost_to_smallest; };
  const auto memory = [](const Row& row) { return row.memory_mb; };
  struct Lines {
    Method method;
    Series radius, volume, megabytes;
  };
  std::vector<Lines> lines;
  std::vector<double> radii, costs, volumes, megabytes;
  for (const Method method : kShown) {
    const std::string_view key = key_of(method);
    Lines l{method, cost_by_radius(rate, key), by_volume(scale, key, "whole-top", cost),
            by_volume(scale, key, "whole-top", memory)};
    if (l.radius.size() < 2)
      return fail(ChartError::missing_rows, fmt::format("rate: exploration of {} with two burrs at least", key));
    if (l.volume.size() < 2) return fail(ChartError::missing_rows, fmt::format("scale: {} at two sizes at least", key));
    for (const auto& [r, us] : l.radius) costs.push_back(us);
    for (const auto& [n, us] : l.volume) volumes.push_back(us);
    for (const auto& [n, mb] : l.megabytes) megabytes.push_back(mb);
    lines.push_back(std::move(l));
  }
  const std::string title = "What a tick and a scene cost";
  Svg svg(860.0, 430.0, title,
          "Three panels for the surface proxy and the occupancy proxy: microseconds a tick against the burr's radius, "
          "microseconds a tick against the volume's edge in voxels, and memory against the volume's edge.");
  heading(svg, title,
          "Exploring at 50 mm/s, voxels of 10/128 mm. Middle and right: a solid block, burr of 0.5 mm radius.");

  Plot by_radius(svg, {70.0, 76.0}, {278.0, 350.0}, lettered("burr radius, mm", 0.2, 3.8, {0.25, 0.5, 1.15, 3.0}),
                 decades("\u00b5s a tick", costs));
  Axis edge = lettered("voxels along an edge", 105.0, 3300.0, {128, 256, 512, 1024});
  const double top = std::max(1.5, 1.1 * *std::ranges::max_element(volumes));
  Axis relative = even("a tick's cost, 128\u00b3 = 1", 0.0, std::ceil(2.0 * top) / 2.0, 0.5);
  Plot by_edge(svg, {352.0, 76.0}, {560.0, 350.0}, edge, relative);
  Plot by_memory(svg, {632.0, 76.0}, {840.0, 350.0}, edge, decades("MB", megabytes));
  for (const double bound : {0.8, 1.2})
    svg.line(by_edge.at(105.0, bound), by_edge.at(3300.0, bound), {ink::kQuiet, 1.0, "3 3"});
  svg.text({by_edge.at(128.0, 1.2).x, by_edge.at(128.0, 1.2).y - 6.0}, "\u00b1 20 %",
           {.size = 12.0, .colour = ink::kQuiet});

  for (const Lines& l : lines) {
    const Look look = look_of(l.method);
    draw(by_radius, l.radius, look);
    draw(by_edge, l.volume, look);
    draw(by_memory, l.megabytes, look);
  }
  for (const Lines& l : lines) {
    const std::string_view name = l.method == Method::surface ? "surface" : "occupancy";
    by_radius.label(by_radius.at(l.radius.back().first, l.radius.back().second), 9.0, name,
                    {.size = 13.0, .bold = true});
    // Beside the right ends, two lines of text; kept apart where the ends meet.
    const Lines& other = &l == &lines[0] ? lines[1] : lines[0];
    const auto named = [&](const Plot& plot, const Series& own, const Series& others, const std::string& figure) {
      const Point p = plot.at(own.back().first, own.back().second);
      const Point q = plot.at(others.back().first, others.back().second);
      const bool higher = p.y < q.y || (p.y == q.y && &l == &lines[0]);
      const double apart = std::max(0.0, 17.0 - 0.5 * std::fabs(p.y - q.y));
      const double y = p.y + (higher ? -apart : apart);
      svg.text({p.x + 9.0, y - 2.0}, name, {.size = 13.0, .bold = true});
      svg.text({p.x + 9.0, y + 13.0}, figure, {.size = 12.0, .colour = ink::kQuiet});
    };
    named(by_edge, l.volume, other.volume, fmt::format("{:+.0f} %", 100.0 * (l.volume.back().second - 1.0)));
    named(by_memory, l.megabytes, other.megabytes, fmt::format("{:.0f} MB", l.megabytes.back().second));
  }
  footing(svg,
          fmt::format(
              "{}, commits {:.10} and {:.10}. Circles: surface proxy. Squares: occupancy proxy. Middle: median over "
              "alternating blocks.",
              rate.machine, rate.commit, scale.commit));
  return svg.str();
}

}  // namespace cusp::bench
