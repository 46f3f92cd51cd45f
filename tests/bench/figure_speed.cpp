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

const Row* find(const Report& report, std::string_view method, std::string_view shape, double radius, double voxel) {
  for (const Row& row : report.rows)
    if (row.method == method && row.shape == shape && row.motion == "slide" && row.task.empty() && !row.unresolved &&
        same(row.speed_mm_s, kSpeed) && same(row.burr_radius_mm, radius) && same(row.voxel_mm, voxel) &&
        !std::isnan(row.angle_deg_mean) && !std::isnan(row.updates_per_s))
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

std::vector<Place> places_of(const Report& report, double radius) {
  std::vector<Place> out;
  for (const Method method : kMethods)
    for (const double voxel : voxels_in(report)) {
      const Row* face = find(report, key_of(method), "face", radius, voxel);
      const Row* sphere = find(report, key_of(method), "sphere", radius, voxel);
      if (!face || !sphere) continue;
      out.push_back({method, voxel, 2.0 / (1.0 / face->updates_per_s + 1.0 / sphere->updates_per_s),
                     0.5 * (face->angle_deg_mean + sphere->angle_deg_mean)});
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

Picture speed_against_accuracy(const Report& accuracy, double burr_radius_mm) {
  const std::vector<Place> places = places_of(accuracy, burr_radius_mm);
  if (places.empty())
    return fail(ChartError::missing_rows,
                fmt::format("accuracy: no slides at 50 mm/s on face and sphere with a burr of {} mm", burr_radius_mm));

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
  plot.label({foot.x, plot.bottom_right().y - 16.0}, 5.0, "the paper, 2012: 62 k, accuracy not given",
             {.size = 12.0, .colour = ink::kQuiet});
  const bool several = std::ranges::any_of(places, [&](const Place& p) { return !same(p.voxel_mm, usual); });
  if (several)
    for (const Place& p : places)
      plot.label(plot.at(p.updates_per_s, shown(p.angle_deg)), 0.5 * size_of(p) + 3.0,
                 fmt::format("{:.2g}", p.voxel_mm), {.size = 11.0, .colour = ink::kQuiet});
  footing(svg, fmt::format("Filled: {}, commit {:.10}, {}. Hollow: other programs, measured elsewhere ({}). Dashed: "
                           "the front.",
                           accuracy.machine, accuracy.commit,
                           several ? "voxel size in mm beside the marks" : "voxels of 10/128 mm", kPeersMachine));
  return svg.str();
}

}  // namespace cusp::bench
