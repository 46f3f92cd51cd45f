#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/bench/figures.h"
#include "tests/bench/looks.h"
#include "tests/bench/peers.h"
#include "tests/bench/plot.h"

namespace cusp::bench {

namespace {

struct TaskName {
  std::string_view key, label;
};
constexpr std::array<TaskName, 3> kTasks = {
    {{"displacement", "A  displacement"}, {"exploration", "B  exploration"}, {"perforation", "C  perforation"}}};
constexpr Method kShown[] = {Method::surface, Method::occupancy};

void divide(Svg& svg, const Plot& plot, double x_mid, std::string_view label, double x_end, bool last) {
  svg.text({x_mid, plot.top_left().y - 8.0}, label, {.size = 13.0, .anchor = Anchor::middle, .bold = true});
  if (!last) svg.line({x_end, plot.top_left().y - 22.0}, {x_end, plot.bottom_right().y}, {ink::kQuiet, 1.0, "3 3"});
}

}  // namespace

Picture rates_by_task(const PaceReport& pace) {
  constexpr double kEach = kSampleS * kSamplesATask;
  std::vector<double> rates = {kPaperExploration, kPaperPerforation};
  for (const TaskName& task : kTasks)
    for (const Method method : kShown) {
      const auto of = [&](const PaceSample& s) { return s.method == key_of(method) && s.task == task.key; };
      if (std::ranges::none_of(pace.samples, of))
        return fail(ChartError::missing_rows, fmt::format("pace: no samples of {} in {}", key_of(method), task.key));
    }
  for (const PaceSample& s : pace.samples) rates.push_back(s.updates_per_s);

  const std::string title = "Updates a second in the paper's three tasks";
  Svg svg(
      860.0, 520.0, title,
      "Rates of the surface proxy and the occupancy proxy in displacement, exploration and perforation, sampled every "
      "25 ms, with the paper's rates as lines. After the paper's figure 13.");
  heading(svg, title,
          fmt::format("Sampled every 25 ms of stepping, one core; ball burr of {} mm radius, 128\u00b3 voxels in 10 "
                      "mm. Logarithmic.",
                      kPaperBurrMm));
  Plot plot(svg, {76.0, 96.0}, {836.0, 440.0}, even("seconds", 0.0, 3.0 * kEach, 0.2),
            decades("updates a second", rates));
  for (std::size_t i = 0; i < kTasks.size(); ++i) {
    const double from = kEach * static_cast<double>(i);
    divide(svg, plot, plot.at(from + 0.5 * kEach, rates[0]).x, kTasks[i].label, plot.at(from + kEach, rates[0]).x,
           i == 2);
    if (i > 0) {
      const double rate = i == 1 ? kPaperExploration : kPaperPerforation;
      const Point a = plot.at(from, rate), b = plot.at(from + kEach, rate);
      svg.line(a, b, {ink::kText, 1.6, "7 4"});
      plot.room().take_line(a, b);
    }
    for (const Method method : kShown) {
      std::vector<Point> line;
      for (const PaceSample& s : pace.samples)
        if (s.method == key_of(method) && s.task == kTasks[i].key) line.push_back({from + s.time_s, s.updates_per_s});
      plot.path(line, {look_of(method).colour, 2.0, ""});
      for (const Point& p : line) plot.mark(look_of(method).mark, p.x, p.y, 7.0, look_of(method).colour);
    }
  }
  // The higher line of a task says its name and median above it, the lower one below.
  for (std::size_t i = 0; i < kTasks.size(); ++i) {
    const double middle_x = plot.at(kEach * (static_cast<double>(i) + 0.5), rates[0]).x;
    if (i > 0) {
      const double rate = i == 1 ? kPaperExploration : kPaperPerforation;
      plot.label({middle_x, plot.at(0.0, rate).y}, 5.0, "the paper, 2012: " + short_number(rate), {.size = 12.0});
    }
    struct Line {
      std::string text;
      double median, least, most;
    };
    std::vector<Line> lines;
    for (const Method method : kShown) {
      std::vector<double> values;
      for (const PaceSample& s : pace.samples)
        if (s.method == key_of(method) && s.task == kTasks[i].key) values.push_back(s.updates_per_s);
      std::ranges::sort(values);
      const double middle = values[values.size() / 2];
      lines.push_back({(method == Method::surface ? "surface proxy " : "occupancy proxy ") + short_number(middle),
                       middle, values.front(), values.back()});
    }
    const bool first_higher = lines[0].median >= lines[1].median;
    for (std::size_t k = 0; k < 2; ++k) {
      // Above the higher line and below the lower one, unless something stands there.
      const bool higher = (k == 0) == first_higher;
      const double above = plot.at(0.0, lines[k].most).y - 12.0, below = plot.at(0.0, lines[k].least).y + 24.0;
      const double half = 0.53 * text_width(lines[k].text, 13.0);
      const auto box = [&](double y) { return Room::Box{{middle_x - half, y - 11.0}, {middle_x + half, y + 4.0}}; };
      const double first = higher ? above : below, second = higher ? below : above;
      const double y = plot.room().overlap(box(first)) <= plot.room().overlap(box(second)) ? first : second;
      svg.text({middle_x, y}, lines[k].text, {.size = 13.0, .anchor = Anchor::middle, .bold = true});
      plot.room().take(box(y));
    }
  }
  const auto slowest = std::ranges::min(pace.samples, {}, &PaceSample::updates_per_s).updates_per_s;
  footing(svg, fmt::format(
                   "{}, commit {:.10}. Circles: surface proxy. Squares: occupancy proxy, the paper's method. Dashed: "
                   "the paper's own, 2012. Slowest 25 ms of all: {}.",
                   pace.machine, pace.commit, short_number(slowest)));
  return svg.str();
}

Picture displacement_and_force(const MotionReport& motion) {
  for (const TaskName& task : kTasks)
    for (const Method method : kShown)
      if (std::ranges::none_of(motion.samples,
                               [&](const MotionSample& s) { return s.method == key_of(method) && s.task == task.key; }))
        return fail(ChartError::missing_rows, fmt::format("motion: no samples of {} in {}", key_of(method), task.key));

  double end = 0.0, way = 0.5, most = 0.1;
  std::array<double, 3> task_end{};
  for (const MotionSample& s : motion.samples) {
    end = std::max(end, s.time_s);
    for (int i = 0; i < 3; ++i) {
      way = std::max(way, std::fabs(s.displacement_mm[i]));
      most = std::max(most, std::fabs(s.force_n[i]));
    }
    for (std::size_t i = 0; i < 3; ++i)
      if (s.task == kTasks[i].key) task_end[i] = std::max(task_end[i], s.time_s);
  }
  way = std::ceil(way - 1e-6);
  most = std::ceil(most * 5.0 - 1e-6) / 5.0;

  struct AxisLook {
    std::string_view name, colour, dash;
  };
  constexpr AxisLook kAxes[] = {{"x", ink::kVermilion, "6 3"}, {"y", ink::kGreen, "2 3"}, {"z", ink::kBlue, ""}};
  const std::string title = "Displacement and force on each axis through the three tasks";
  Svg svg(
      860.0, 760.0, title,
      "Three panels over time: the hand's displacement on x, y and z, the force of the surface proxy, and the force of "
      "the occupancy proxy on the same way. After the paper's figure 14.");
  heading(svg, title,
          "The same hand, 1 kHz, a point every 25 ms; a block of 1 N/mm, drilled at 1 mm/s at most. z points out of "
          "its top.");
  struct Panel {
    std::string title;
    bool force;
    Method method;
    double top;
  };
  const Panel panels[] = {{"displacement, mm", false, Method::surface, 98.0},
                          {"surface proxy, N", true, Method::surface, 304.0},
                          {"occupancy proxy, N", true, Method::occupancy, 510.0}};
  for (const Panel& panel : panels) {
    const bool last = panel.top > 500.0;
    const double range = panel.force ? most : way;
    Axis time = even(last ? "seconds" : "", 0.0, std::ceil(end * 2.0 - 1e-6) / 2.0, 0.5);
    if (!last)
      for (auto& [value, text] : time.ticks) text.clear();
    Plot plot(svg, {76.0, panel.top}, {812.0, panel.top + 180.0}, time,
              even(panel.title, panel.force ? -0.5 * range : -range, range, panel.force ? range / 4.0 : range / 2.0));
    double from = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point p = plot.at(task_end[i], 0.0);
      const double middle = plot.at(0.5 * (from + task_end[i]), 0.0).x;
      if (panel.top < 100.0)
        divide(svg, plot, middle, kTasks[i].label, p.x, i == 2);
      else if (i < 2)
        svg.line({p.x, plot.top_left().y}, {p.x, plot.bottom_right().y}, {ink::kQuiet, 1.0, "3 3"});
      from = task_end[i];
    }
    std::array<Point, 3> ends;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<Point> line;
      for (const MotionSample& s : motion.samples)
        if (s.method == key_of(panel.method))
          line.push_back({s.time_s, panel.force ? s.force_n[axis] : s.displacement_mm[axis]});
      plot.path(line, {kAxes[axis].colour, axis == 2 ? 2.2 : 1.6, kAxes[axis].dash});
      ends[static_cast<std::size_t>(axis)] = plot.at(line.back().x, line.back().y);
    }
    // Named at their right ends, moved apart where they meet.
    std::array<std::size_t, 3> order = {0, 1, 2};
    std::ranges::sort(order, [&ends](std::size_t a, std::size_t b) { return ends[a].y < ends[b].y; });
    double least = -1e9;
    for (const std::size_t i : order) {
      const double y = std::max(ends[i].y, least);
      svg.text({ends[i].x + 8.0, y + 4.0}, kAxes[i].name, {.size = 14.0, .colour = kAxes[i].colour, .bold = true});
      least = y + 15.0;
    }
  }
  footing(svg,
          fmt::format(
              "{}, commit {:.10}. Ball burr of {} mm radius, 128\u00b3 voxels in 10 mm. x dashed, y dotted, z whole.",
              motion.machine, motion.commit, kPaperBurrMm));
  return svg.str();
}

}  // namespace cusp::bench
