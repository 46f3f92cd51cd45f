// How stiff a wall may be beside the exact proxy, in every cell of place, device, hand, friction and delay.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "tests/bench/figures.h"
#include "tests/bench/plot.h"
#include "tests/bench/stability.h"

namespace cusp::bench {

namespace {

constexpr double kShare = 0.15;  // within which the two are to be
constexpr double kLow = 0.04, kHigh = 13.0;
constexpr double kBottom = 0.8, kTop = 1.2;

struct Cells {
  std::vector<const Row*> with_exact;
  int settled = 0;  // by more than one set of seeds
  int beyond = 0, beyond_first = 0;
  double least = 1e9, most = 0.0;
};

Cells cells_of(const Report& full, std::string_view place) {
  Cells out;
  for (const Row& row : full.rows) {
    if (row.case_name != place || row.method != key_of(Method::surface) || row.guard != "off") continue;
    if (!(row.k_exact_n_per_mm > 0.0)) continue;  // stable at no stiffness: nothing to compare with
    const double share = row.k_max_n_per_mm / row.k_exact_n_per_mm;
    const double first = row.k_sets > 1 && row.k_exact_first_n_per_mm > 0.0 ? row.k_first_n_per_mm / row.k_exact_first_n_per_mm : share;
    out.with_exact.push_back(&row);
    out.settled += row.k_sets > 1;
    out.beyond += std::fabs(share - 1.0) > kShare;
    out.beyond_first += std::fabs(first - 1.0) > kShare;
    out.least = std::min(out.least, share);
    out.most = std::max(out.most, share);
  }
  return out;
}

}  // namespace

Picture stiffness_by_cell(const Report& full) {
  const std::string title = "The stiffest stable wall over the exact proxy\u2019s, in every cell";
  Svg svg(860.0, 640.0, title,
          "Six panels, one a place: k_max of the surface proxy over that of the exact proxy with the same device, hand, friction and "
          "delay, against the exact proxy's k_max. A mark a cell; the goal is within 15 percent.");
  std::size_t cells = 0;
  int settled = 0, beyond = 0, beyond_first = 0;
  for (std::size_t i = 0; i < kPressCases.size(); ++i) {
    const CaseName& place = kPressCases[i];
    const Cells found = cells_of(full, place.key);
    if (found.with_exact.empty()) return fail(ChartError::missing_rows, fmt::format("stability --full: surface, guard off, {}", place.key));
    const bool left = i % 3 == 0, low = i >= 3;
    Axis x, y;
    x.low = kLow;
    x.high = kHigh;
    x.log = true;
    x.title = low ? "exact proxy, N/mm" : "";
    for (const double k : {0.1, 1.0, 10.0}) x.ticks.emplace_back(k, low ? fmt::format("{:g}", k) : "");
    y.low = kBottom;
    y.high = kTop;
    y.title = left ? "surface proxy over exact" : "";
    for (const double share : {0.85, 1.0, 1.15}) y.ticks.emplace_back(share, left ? fmt::format("{:g}", share) : "");
    const Point corner{76.0 + 258.0 * static_cast<double>(i % 3), low ? 344.0 : 104.0};
    Plot plot(svg, corner, {corner.x + 244.0, corner.y + 200.0}, x, y);
    svg.text({corner.x, corner.y - 8.0},
             fmt::format("{}: {} cells, {:.2f} to {:.2f}", place.label, found.with_exact.size(), found.least, found.most),
             {.size = 12.5, .bold = true});
    for (const double goal : {1.0 - kShare, 1.0 + kShare})
      svg.line(plot.at(kLow, goal), plot.at(kHigh, goal), {ink::kVermilion, 1.2, "5 4"});
    for (const Row* row : found.with_exact) {
      const double share = row->k_max_n_per_mm / row->k_exact_n_per_mm;
      plot.mark(Mark::circle, row->k_exact_n_per_mm, std::clamp(share, kBottom, kTop), 6.0, ink::kBlue, row->k_sets > 1);
    }
    cells += found.with_exact.size();
    settled += found.settled;
    beyond += found.beyond;
    beyond_first += found.beyond_first;
  }
  heading(svg, title,
          fmt::format("No guard. {} cells: devices of 0.1 and 0.25 kg and 0.5 to 5 N s/m, three hands, friction, delay. Beyond 15 %: {}.",
                      cells, beyond));
  footing(svg, fmt::format("{}, commit {:.10}. Hollow: {} cells by the medians of more sets of five seeds; by their first set {} would be beyond.",
                           full.machine, full.commit, settled, beyond_first));
  return svg.str();
}

}  // namespace cusp::bench
