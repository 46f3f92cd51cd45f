#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "tests/bench/figures.h"
#include "tests/bench/looks.h"
#include "tests/bench/options.h"
#include "tests/bench/peers.h"
#include "tests/bench/plot.h"

namespace cusp::bench {

namespace {

constexpr double kSpeed = 50.0;
constexpr double kLeastAngle = 1e-4;  // degrees; what is below stands at the frame's foot

struct Place {
  Method method;
  double voxel_mm;
  double updates_per_s;
  double angle_deg;
};

/// The slide at 50 mm/s on a shape: of accuracy (without a task) or of rate.
const Row* find(const Report& report, std::string_view task, std::string_view method, std::string_view shape,
                double radius, double voxel, double Row::* field) {
  for (const Row& row : report.rows)
    if (row.method == method && row.shape == shape && row.motion == "slide" && row.task == task && !row.unresolved &&
        same(row.speed_mm_s, kSpeed) && same(row.burr_radius_mm, radius) && same(row.voxel_mm, voxel) &&
        !std::isnan(row.*field))
      return &row;
  return nullptr;
}

std::vector<double> voxels_in(const Report& report) {
  std::vector<double> out;
  for (const Row& row : report.rows)
    if (std::ranges::none_of(out, [&row](double v) { return same(v, row.voxel_mm); })) out.push_back(row.voxel_mm);
  std::ranges::sort(out, std::greater<>());
  return out;
}

std::vector<Place> places_of(const Report& accuracy, const Report& rate, double radius) {
  std::vector<Place> out;
  for (const Method method : kMethods)
    for (const double voxel : voxels_in(accuracy)) {
      double tick_s = 0.0, angle = 0.0;
      bool whole = true;
      for (const std::string_view shape : {"face", "sphere"}) {
        const Row* exact = find(accuracy, "", key_of(method), shape, radius, voxel, &Row::angle_deg_mean);
        const Row* fast = find(rate, "exploration", key_of(method), shape, radius, voxel, &Row::updates_per_s);
        whole = whole && exact && fast;
        if (!whole) break;
        tick_s += 0.5 / fast->updates_per_s;
        angle += 0.5 * exact->angle_deg_mean;
      }
      if (whole) out.push_back({method, voxel, 1.0 / tick_s, angle});
    }
  return out;
}

/// Those that no other beats in both, fastest first.
std::vector<Place> front_of(std::vector<Place> places) {
  std::ranges::stable_sort(places, [](const Place& a, const Place& b) { return a.updates_per_s > b.updates_per_s; });
  std::vector<Place> out;
  for (const Place& p : places)
    if (out.empty() || p.angle_deg < out.back().angle_deg) out.push_back(p);
  return out;
}

double shown(double angle) { return std::max(angle, kLeastAngle); }

}  // namespace

Picture speed_against_accuracy(const Report& accuracy, const Report& rate, double burr_radius_mm) {
  const std::vector<Place> places = places_of(accuracy, rate, burr_radius_mm);
  if (places.empty())
    return fail(
        ChartError::missing_rows,
        fmt::format("accuracy and rate: no slides at 50 mm/s on face and sphere with a burr of {} mm", burr_radius_mm));

  std::vector<double> rates = {kPaperExploration}, angles;
  for (const Place& p : places) {
    rates.push_back(p.updates_per_s);
    angles.push_back(shown(p.angle_deg));
  }
  for (const Peer& peer : kPeers) {
    if (!same(peer.burr_radius_mm, burr_radius_mm)) continue;
    rates.push_back(peer.updates_per_s);
    angles.push_back(0.5 * (peer.face_deg + peer.sphere_deg));
  }
  const std::string title = fmt::format("Speed against accuracy, ball burr of {} mm radius", burr_radius_mm);
  Svg svg(
      860.0, 620.0, title,
      "Each contact method as a mark: updates a second to the right, mean angle error of its force downwards. Further "
      "right is faster, further down is more exact.");
  heading(svg, title,
          "Sliding at 50 mm/s, 0.3 mm below the offset surface, mean of face and sphere. Right is faster, down is more "
          "exact.");
  Plot plot(svg, {76.0, 72.0}, {836.0, 528.0}, decades("updates a second, one core", rates),
            decades("mean angle between force and exact force, degrees", angles));

  // The paper says how fast it was, not how exact.
  const Point foot = plot.at(kPaperExploration, angles[0]);
  svg.line({foot.x, plot.top_left().y}, {foot.x, plot.bottom_right().y}, {ink::kQuiet, 1.2, "2 4"});
  plot.room().take_line({foot.x, plot.top_left().y}, {foot.x, plot.bottom_right().y});

  std::vector<Point> front;
  for (const Place& p : front_of(places)) {
    if (!front.empty()) front.push_back({p.updates_per_s, front.back().y});
    front.push_back({p.updates_per_s, shown(p.angle_deg)});
  }
  plot.path(front, {ink::kQuiet, 1.6, "6 4"});

  for (const Method method : kMethods) {
    std::vector<Point> line;
    for (const Place& p : places)
      if (p.method == method) line.push_back({p.updates_per_s, shown(p.angle_deg)});
    plot.path(line, {look_of(method).colour, 1.2, ""});
  }
  // A coarser voxel, a larger mark.
  const auto size_of = [](const Place& p) { return std::clamp(8.0 + 40.0 * p.voxel_mm, 9.0, 16.0); };
  for (const Place& p : places)
    plot.mark(look_of(p.method).mark, p.updates_per_s, shown(p.angle_deg), size_of(p), look_of(p.method).colour);
  for (const Peer& peer : kPeers)
    if (same(peer.burr_radius_mm, burr_radius_mm))
      plot.mark(Mark::circle, peer.updates_per_s, 0.5 * (peer.face_deg + peer.sphere_deg), 10.0, ink::kQuiet, true);

  // Names first, at the voxel of 128^3 in 10 mm where it was measured; then the peers; then the voxel sizes.
  const double usual = 10.0 / 128;
  for (const Method method : kMethods) {
    const Place* at = nullptr;
    for (const Place& p : places)
      if (p.method == method && (!at || same(p.voxel_mm, usual))) at = &p;
    if (at)
      plot.label(plot.at(at->updates_per_s, shown(at->angle_deg)), 0.5 * size_of(*at) + 4.0, look_of(method).label,
                 {.size = 13.0, .bold = true});
  }
  for (const Peer& peer : kPeers)
    if (same(peer.burr_radius_mm, burr_radius_mm))
      plot.label(plot.at(peer.updates_per_s, 0.5 * (peer.face_deg + peer.sphere_deg)), 9.0,
                 std::string(peer.name) + (peer.pressed ? " (pressed)" : ""), {.size = 12.0, .colour = ink::kQuiet});
  plot.label({foot.x, plot.top_left().y + 0.72 * (plot.bottom_right().y - plot.top_left().y)}, 5.0,
             "the paper, 2012: 62 k, accuracy not given", {.size = 12.0, .colour = ink::kQuiet});
  const bool several = std::ranges::any_of(places, [&](const Place& p) { return !same(p.voxel_mm, usual); });
  if (several)
    for (const Place& p : places)
      plot.label(plot.at(p.updates_per_s, shown(p.angle_deg)), 0.5 * size_of(p) + 3.0,
                 fmt::format("{:.2g}", p.voxel_mm), {.size = 11.0, .colour = ink::kQuiet});
  svg.text({20.0, svg.height() - 28.0},
           fmt::format("Filled: {}, commits {:.10} (angles) and {:.10} (rates), {}. Dashed: the front of the best.",
                       accuracy.machine, accuracy.commit, rate.commit,
                       several ? "voxel size in mm beside the marks" : "voxels of 10/128 mm"),
           {.size = 11.0, .colour = ink::kQuiet});
  footing(svg, fmt::format("Hollow: other programs, measured elsewhere on a {}, 10/128 mm; pressed: their angle is of "
                           "presses, no slide was measured.",
                           kPeersMachine));
  return svg.str();
}

}  // namespace cusp::bench
