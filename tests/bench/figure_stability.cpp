// The map of stability: where every method becomes unstable, falls through, jams or kicks.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "tests/bench/figures.h"
#include "tests/bench/looks.h"
#include "tests/bench/plot.h"
#include "tests/bench/stability.h"
#include "tests/bench/stability_kmax.h"
#include "tests/bench/verdict.h"

namespace cusp::bench {

namespace {

constexpr Method kOrder[] = {Method::surface, Method::gradient,  Method::penalty,
                             Method::ray,     Method::occupancy, Method::occupancy_pivot};

/// Colours of k_max over the exact proxy's: from below (warm) through as good (pale) to above (blue). Okabe and Ito's
/// vermilion and blue, and what lies between them and white; lightness falls to both sides, so that grey tells it too.
struct Step {
  double upto;
  std::string_view fill, ink, text;
};
constexpr Step kSteps[] = {{0.5, "#D55E00", "#FFFFFF", "under 0.5"},
                           {0.85, "#F3B27A", "#1B1F24", "0.5 to 0.85"},
                           {1.15, "#EEF1F4", "#1B1F24", "as the exact proxy"},
                           {1.75, "#8FC1E3", "#1B1F24", "1.15 to 1.75"},
                           {1e300, "#0072B2", "#FFFFFF", "over 1.75"}};
constexpr std::string_view kFailedFill = "#FBE3D2", kFineFill = "#F7F8FA";

constexpr Step kElsewhere{0.0, kFailedFill, "#8A3B00", ""};

const Step& step_of(double ratio) {
  for (const Step& s : kSteps)
    if (ratio < s.upto) return s;
  return kSteps[4];
}

/// Drawn about a middle, within a square of 2 half.
void glyph(Svg& svg, Breaks failure, Point m, double half, std::string_view colour) {
  const Stroke line{colour, 1.7, ""};
  const double h = half;
  switch (failure) {
    case Breaks::through:  // an arrow down through a wall
      svg.line({m.x - h, m.y}, {m.x + h, m.y}, {colour, 1.3, "2.2 1.6"});
      svg.line({m.x, m.y - h}, {m.x, m.y + h}, line);
      svg.path({{m.x - 0.55 * h, m.y + 0.4 * h}, {m.x, m.y + h}, {m.x + 0.55 * h, m.y + 0.4 * h}}, line);
      return;
    case Breaks::overlap: {  // a ball sunk into a wall
      std::vector<Point> ball;
      for (int i = 0; i <= 16; ++i) {
        const double a = 6.283185307179586 * i / 16.0;
        ball.push_back({m.x + 0.75 * h * std::cos(a), m.y + 0.75 * h * std::sin(a)});
      }
      svg.path(ball, line);
      svg.line({m.x - h, m.y}, {m.x + h, m.y}, {colour, 1.3, ""});
      return;
    }
    case Breaks::stuck:  // a cross
      svg.line({m.x - 0.75 * h, m.y - 0.75 * h}, {m.x + 0.75 * h, m.y + 0.75 * h}, line);
      svg.line({m.x - 0.75 * h, m.y + 0.75 * h}, {m.x + 0.75 * h, m.y - 0.75 * h}, line);
      return;
    case Breaks::kicks:  // lightning
      svg.path({{m.x + 0.35 * h, m.y - h},
                {m.x - 0.45 * h, m.y + 0.15 * h},
                {m.x + 0.4 * h, m.y - 0.1 * h},
                {m.x - 0.35 * h, m.y + h}},
               line);
      return;
    case Breaks::rings: {  // a wave
      std::vector<Point> wave;
      for (int i = 0; i <= 16; ++i)
        wave.push_back({m.x - h + 2.0 * h * i / 16.0, m.y - 0.7 * h * std::sin(2.0 * 6.283185307179586 * i / 16.0)});
      svg.path(wave, {colour, 1.5, ""});
      return;
    }
    case Breaks::feeds:  // an arrow back at the hand
      svg.line({m.x, m.y + h}, {m.x, m.y - h}, line);
      svg.path({{m.x - 0.55 * h, m.y - 0.4 * h}, {m.x, m.y - h}, {m.x + 0.55 * h, m.y - 0.4 * h}}, line);
      svg.line({m.x - 0.8 * h, m.y + h}, {m.x + 0.8 * h, m.y + h}, line);
      return;
    case Breaks::stays_on:  // a bar that does not end
      svg.line({m.x - 0.45 * h, m.y - 0.8 * h}, {m.x - 0.45 * h, m.y + 0.8 * h}, {colour, 2.2, ""});
      svg.line({m.x + 0.45 * h, m.y - 0.8 * h}, {m.x + 0.45 * h, m.y + 0.8 * h}, {colour, 2.2, ""});
      return;
  }
}

struct Column {
  CaseName name;
  bool press;
  double x = 0.0;
};

struct Cell {
  bool any = false;
  double ratio = kAbsent;
  bool beyond = false;
  std::vector<Breaks> failures;
};

/// At the end of the grid that was searched: how much more would be stable is not known.
bool beyond(const Row& row) { return row.k_max_n_per_mm >= k_at(kKMaxPlaces - 1) * (1.0 - 1e-4); }

Cell cell_of(const Report& stability, const Column& column, Method method, std::string_view guard) {
  Cell out;
  const Setting usual = usual_setting();
  for (const Row& row : stability.rows) {
    if (row.method != key_of(method) || row.case_name != column.name.key || row.guard != guard || row.unresolved)
      continue;
    // The sweep of devices has a picture of its own.
    if (column.press && (row.device != device_name(usual.mass_kg, usual.damping_ns_per_m) || row.grip != usual.grip ||
                         row.delay_ms != usual.delay_ms || row.friction_n != usual.friction_n))
      continue;
    out.any = true;
    if (column.press) {
      const double ratio = row.k_max_n_per_mm / row.k_exact_n_per_mm;
      out.ratio = std::isnan(out.ratio) ? ratio : std::min(out.ratio, ratio);
      out.beyond = beyond(row);
    }
    for (const Breaks f : breaks_of(row))
      if (std::ranges::find(out.failures, f) == out.failures.end()) out.failures.push_back(f);
  }
  std::ranges::sort(out.failures);
  return out;
}

void draw_cell(Svg& svg, const Cell& cell, bool press, Point a, Point b) {
  const Point m{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
  const std::size_t n = cell.failures.size();
  if (press) {
    // A method that stands elsewhere than the exact proxy is stable there: that is no merit.
    const bool elsewhere = n > 0 && cell.failures.front() == Breaks::through;
    const Step& step = elsewhere ? kElsewhere : step_of(cell.ratio);
    svg.rect(a, b, step.fill);
    std::string text = cell.ratio < 9.95 ? fmt::format("{:.2g}", cell.ratio) : fmt::format("{:.0f}", cell.ratio);
    if (cell.ratio < 0.0995) text = fmt::format("{:.1g}", cell.ratio);
    if (cell.beyond) text += "+";
    svg.text({m.x, n > 0 ? a.y + 11.0 : m.y + 4.0}, text,
             {.size = n > 0 ? 10.0 : 11.0, .colour = step.ink, .anchor = Anchor::middle, .plain = true});
    for (std::size_t i = 0; i < n; ++i)
      glyph(svg, cell.failures[i],
            {m.x + (n > 2 ? 9.0 : 11.0) * (static_cast<double>(i) - 0.5 * (static_cast<double>(n) - 1.0)), b.y - 7.0},
            n > 2 ? 3.4 : 4.2, step.ink);
    return;
  }
  if (n == 0) {
    svg.rect(a, b, kFineFill);
    svg.mark(Mark::circle, m, 4.5, "#AEB6BE");
    return;
  }
  svg.rect(a, b, kFailedFill);
  // One in the middle, two abreast, more in rows of two, of three from five on.
  const std::size_t abreast = n <= 1 ? 1 : n <= 4 ? 2 : 3;
  const std::size_t rows = (n + abreast - 1) / abreast;
  const double half = n == 1 ? 6.0 : n == 2 ? 5.0 : n <= 4 ? 4.5 : 3.5;
  const double wide = n <= 4 ? 12.5 : 9.0, high = 12.5;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t row = i / abreast, in_row = std::min(abreast, n - row * abreast);
    glyph(svg, cell.failures[i],
          {m.x + wide * (static_cast<double>(i % abreast) - 0.5 * (static_cast<double>(in_row) - 1.0)),
           m.y + high * (static_cast<double>(row) - 0.5 * (static_cast<double>(rows) - 1.0))},
          half, "#8A3B00");
  }
}

}  // namespace

Picture stability_map(const Report& stability) {
  constexpr double kLeft = 182.0, kTop = 212.0, kWide = 28.0, kHigh = 28.0, kGap = 12.0, kMethodGap = 7.0;
  std::vector<Column> columns;
  // A case that a table does not know at all is from after it.
  const auto add = [&](const auto& names, bool press) {
    for (const CaseName& name : names)
      if (std::ranges::any_of(stability.rows, [&](const Row& r) { return r.case_name == name.key; }))
        columns.push_back({name, press});
    return columns.size();
  };
  const std::size_t press_end = add(kPressCases, true), way_end = add(kWayCases, false), fault_end = add(kFaultCases, false);
  if (press_end == 0 || way_end == press_end || fault_end == way_end)
    return fail(ChartError::missing_rows, "stability: cases");
  double x = kLeft;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i == press_end || i == way_end) x += kGap;
    columns[i].x = x;
    x += kWide;
  }
  const double right = x;
  const double table = 12.0 * kHigh + 5.0 * kMethodGap;
  const std::string title = "Where each method breaks";
  Svg svg(
      right + 20.0, kTop + table + 128.0, title,
      "Contact methods, each with the guard on and off, by cases. Colour: the largest stable stiffness over that of "
      "the exact proxy. Signs: what failed.");
  heading(
      svg, title,
      "The largest stable stiffness over the exact proxy's in the same hand, by colour and number; and what failed, by "
      "sign.");

  struct Group {
    std::string_view text;
    std::size_t first, count;
  };
  const Group groups[] = {{"pressed to the limit", 0, press_end},
                          {"on its way, at 1 N/mm", press_end, way_end - press_end},
                          {"something goes wrong", way_end, fault_end - way_end}};
  for (const Group& g : groups) {
    const double a = columns[g.first].x, b = columns[g.first + g.count - 1].x + kWide;
    svg.text({a, 76.0}, g.text, {.size = 12.5, .bold = true});
    svg.line({a, 82.0}, {b - 2.0, 82.0}, {ink::kQuiet, 1.0, ""});
  }
  for (const Column& c : columns)
    svg.text({c.x + 0.5 * kWide + 4.0, kTop - 6.0}, c.name.label, {.size = 11.5, .upwards = true});

  double y = kTop;
  for (const Method method : kOrder) {
    const Look look = look_of(method);
    svg.mark(look.mark, {22.0, y + kHigh}, 11.0, look.colour);
    // "occupancy proxy (the paper)" in two lines.
    const std::string_view label = look.label;
    const std::size_t bracket = std::min(label.find(" ("), label.find(", "));
    const std::string_view first = label.substr(0, bracket);
    svg.text({34.0, y + kHigh - (bracket == std::string_view::npos ? -4.0 : 3.0)}, first, {.size = 12.5, .bold = true});
    if (bracket != std::string_view::npos) {
      std::string_view second = label.substr(bracket + (label[bracket] == ',' ? 2 : 1));
      if (second.starts_with('(')) second = second.substr(1, second.size() - 2);
      svg.text({34.0, y + kHigh + 12.0}, second, {.size = 11.5, .colour = ink::kQuiet});
    }
    for (const std::string_view guard : {"on", "off"}) {
      svg.text({kLeft - 6.0, y + 0.5 * kHigh + 4.0}, guard,
               {.size = 11.0, .colour = ink::kQuiet, .anchor = Anchor::end});
      for (const Column& c : columns) {
        const Cell cell = cell_of(stability, c, method, guard);
        if (!cell.any || (c.press && std::isnan(cell.ratio)))
          return fail(ChartError::missing_rows,
                      fmt::format("stability: {}, guard {}, in case {}", key_of(method), guard, c.name.key));
        draw_cell(svg, cell, c.press, {c.x + 0.75, y + 0.75}, {c.x + kWide - 0.75, y + kHigh - 0.75});
      }
      y += kHigh;
    }
    y += kMethodGap;
  }
  svg.text({kLeft - 6.0, kTop - 6.0}, "guard", {.size = 11.0, .colour = ink::kQuiet, .anchor = Anchor::end});

  // What colours and signs say.
  y += 18.0;
  double at = 22.0;
  svg.text({at, y + 12.0}, "largest stable stiffness", {.size = 12.0, .bold = true});
  at += 156.0;
  for (const Step& step : kSteps) {
    svg.rect({at, y}, {at + 22.0, y + 16.0}, step.fill, {ink::kGrid, 1.0, ""});
    svg.text({at + 28.0, y + 12.5}, step.text, {.size = 12.0});
    at += 40.0 + text_width(step.text, 12.0);
  }
  y += 34.0;
  at = 22.0;
  svg.text({at, y + 4.0}, "what failed", {.size = 12.0, .bold = true});
  at += 92.0;
  const auto entry = [&](auto&& draw, std::string_view text) {
    const double wide = 26.0 + text_width(text, 12.0);
    if (at + wide > right) {
      at = 114.0;
      y += 24.0;
    }
    draw(Point{at + 8.0, y});
    svg.text({at + 20.0, y + 4.0}, text, {.size = 12.0});
    at += wide + 14.0;
  };
  for (const auto& [failure, text] : kBreaks)
    entry([&, f = failure](Point p) { glyph(svg, f, p, 6.0, "#8A3B00"); }, text);
  entry([&](Point p) { svg.mark(Mark::circle, p, 4.5, "#AEB6BE"); }, "nothing");
  const Setting usual = usual_setting();
  footing(svg,
          fmt::format("{}, commit {:.10}. Device of {:g} kg and {:g} N s/m, {:g} ms there and back; no, soft and firm "
                      "grip, and led. +: stable to the end of the search, 10.3 N/mm.",
                      stability.machine, stability.commit, usual.mass_kg, usual.damping_ns_per_m, usual.delay_ms));
  return svg.str();
}

}  // namespace cusp::bench
