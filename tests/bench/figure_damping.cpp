// How stiff a wall may be by the device's damping, beside the bounds that promise passivity.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "engine/lab/sampled_wall.h"
#include "tests/bench/figures.h"
#include "tests/bench/plot.h"
#include "tests/bench/stability.h"

namespace cusp::bench {

Picture stiffness_against_damping(const Report& stability) {
  struct Hand {
    std::string_view grip, label, colour;
    Mark mark;
  };
  constexpr Hand kHands[] = {{"firm", "firm grip", ink::kBlue, Mark::square},
                             {"soft", "soft grip", ink::kGreen, Mark::circle},
                             {"none", "no hand", ink::kVermilion, Mark::triangle_up}};
  constexpr double kLow = 0.3, kHigh = 24.0, kFloor = 0.5, kRoof = 20.0;
  const std::string title = "The stiffest stable wall, by the device's damping";
  Svg svg(860.0, 500.0, title,
          "Measured largest stable stiffness of the surface proxy on a face against device damping, for three grips, "
          "without and with friction, beside the bounds of Colgate and of Abbott and Okamura, which are sufficient for "
          "passivity.");
  heading(
      svg, title,
      "Surface proxy on a face, no guard, no delay, 0.1 kg. Below a bound passivity is promised; Colgate's knows no "
      "encoder.");
  double apart = 0.0;  // of method and exact proxy, as a share
  const double step_mm = usual_setting().device().encoder_step_mm;
  struct Panel {
    double friction, left;
    std::string_view text;
  };
  for (const Panel& panel : {Panel{0.0, 76.0, "without friction"}, Panel{0.1, 492.0, "friction 0.1 N"}}) {
    Axis x, y;
    x.low = kLow;
    x.high = kHigh;
    x.log = y.log = true;
    x.title = "device damping, N s/m";
    for (const double b : {0.5, 2.0, 5.0}) x.ticks.emplace_back(b, fmt::format("{:g}", b));
    y.low = kFloor;
    y.high = kRoof;
    y.title = panel.friction > 0.0 ? "" : "stiffness, N/mm";
    for (const double k : {0.5, 1.0, 2.0, 5.0, 10.0, 20.0}) y.ticks.emplace_back(k, fmt::format("{:g}", k));
    Plot plot(svg, {panel.left, 96.0}, {panel.left + 344.0, 420.0}, x, y);
    svg.text({panel.left, 86.0}, panel.text, {.size = 13.0, .bold = true});
    const auto bound = [&](auto&& value, std::string_view dash) {
      std::vector<Point> line;
      for (int i = 0; i <= 60; ++i) {
        const double b = kLow * std::pow(kHigh / kLow, i / 60.0), k = value(b);
        if (k >= kFloor && k <= kRoof) line.push_back({b, k});
      }
      if (line.empty()) return;
      plot.path(line, {ink::kText, 1.6, dash});
      for (std::size_t i = 1; i < line.size(); ++i)
        plot.room().take_line(plot.at(line[i - 1].x, line[i - 1].y), plot.at(line[i].x, line[i].y));
    };
    const auto colgate = [](double b) { return lab::colgate_bound_n_per_mm(b, 0.0, lab::kTickS); };
    const auto abbott = [&](double b) {
      return lab::abbott_okamura_bound_n_per_mm(b, panel.friction, step_mm, lab::kTickS);
    };
    bound(colgate, "7 4");
    bound(abbott, "2 3");
    struct Name {
      double y;
      std::string_view text;
      Point end;
    };
    std::vector<Name> names;
    for (const Hand& hand : kHands) {
      std::vector<std::pair<Point, double>> found;
      for (const Row& row : stability.rows)
        if (row.method == key_of(Method::surface) && row.case_name == "face" && row.guard == "off" &&
            row.grip == hand.grip && row.friction_n == panel.friction && row.delay_ms == 0.0 && row.mass_kg == 0.1)
          found.push_back({{row.damping_n_s_m, row.k_max_n_per_mm}, row.k_exact_n_per_mm});
      std::ranges::sort(found, {}, [](const auto& f) { return f.first.x; });
      if (found.size() < 2)
        return fail(ChartError::missing_rows,
                    fmt::format("stability: surface on face, guard off, grip {}, friction {} N, without delay, at two "
                                "dampings at least",
                                hand.grip, panel.friction));
      std::vector<Point> line;
      for (const auto& [p, exact] : found) {
        if (p.y >= kFloor) line.push_back(p);
        if (exact > 0.0) apart = std::max(apart, std::fabs(p.y / exact - 1.0));
      }
      plot.path(line, {hand.colour, 2.0, ""});
      for (std::size_t i = 1; i < line.size(); ++i)
        plot.room().take_line(plot.at(line[i - 1].x, line[i - 1].y), plot.at(line[i].x, line[i].y));
      for (const auto& [p, exact] : found) {
        if (p.y < kFloor) {
          // No stiffness holds still: an arrow out of the frame's floor.
          const Point foot = plot.at(p.x, kFloor);
          svg.path({{foot.x - 5.0, foot.y - 10.0}, {foot.x, foot.y - 2.0}, {foot.x + 5.0, foot.y - 10.0}},
                   {hand.colour, 2.2, ""});
          svg.text({foot.x + 9.0, foot.y - 3.0}, "none is", {.size = 12.0, .colour = ink::kQuiet});
          continue;
        }
        plot.mark(hand.mark, p.x, p.y, 10.0, hand.colour);
        plot.room().take_mark(plot.at(p.x, p.y), 10.0);
      }
      const Point end = plot.at(line.back().x, line.back().y);
      names.push_back({end.y, hand.label, end});
    }
    // Named at their right ends, moved apart where they meet, up as far as down.
    std::ranges::sort(names, {}, &Name::y);
    std::vector<double> at;
    for (const Name& name : names) at.push_back(at.empty() ? name.y : std::max(name.y, at.back() + 16.0));
    const double pushed = at.back() - names.back().y;
    for (std::size_t i = 0; i < names.size(); ++i)
      svg.text({names[i].end.x + 12.0, at[i] - 0.8 * pushed + 4.0}, names[i].text, {.size = 12.5, .bold = true});
    // Beside the bounds, on the side where nothing is.
    const Point steep = plot.at(0.85, colgate(0.85));
    svg.text({steep.x - 12.0, steep.y - 4.0}, "Colgate", {.size = 12.5, .anchor = Anchor::end});
    if (panel.friction > 0.0) {
      const Point flat = plot.at(kHigh, abbott(kHigh));
      svg.text({flat.x - 6.0, flat.y + 17.0}, "Abbott and Okamura", {.size = 12.5, .anchor = Anchor::end});
    } else {
      svg.text({panel.left + 334.0, 390.0}, "Abbott and Okamura: nothing is promised",
               {.size = 12.0, .colour = ink::kQuiet, .anchor = Anchor::end});
    }
  }
  footing(svg, fmt::format("{}, commit {:.10}. Encoder step {:.3g} mm, 1 kHz. Squares: firm grip. Circles: soft. "
                           "Triangles: nobody holds it. The exact proxy's are within {:.0f} %.",
                           stability.machine, stability.commit, step_mm, 100.0 * apart));
  return svg.str();
}

}  // namespace cusp::bench
