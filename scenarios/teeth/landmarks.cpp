#include "scenarios/teeth/find_landmarks.h"

#include <algorithm>

namespace cusp::scenarios {
namespace {

constexpr double kLineStepMm = 0.1;
constexpr double kRimMm = 0.25;  // within the rounded rim a line has left the biting surface

/// Highest (sign +1) or lowest (-1) place of the biting surface near a start, no further than `reach`.
std::optional<Vec3> extreme(const ToothShape& shape, Vec3 start, double reach, double sign) {
  std::optional<Vec3> best = shape.top_at(start.x, start.y);
  const Vec3 home = start;
  for (double step = reach / 2; step > 0.01; step *= 0.5) {
    if (!best) return best;
    const Vec3 at = *best;
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        const double x = at.x + i * step, y = at.y + j * step;
        if (std::hypot(x - home.x, y - home.y) > reach) continue;
        const auto p = shape.top_at(x, y);
        if (p && sign * p->z > sign * best->z) best = p;
      }
    }
  }
  return best;
}

/// A line of the table laid on the biting surface; ends where it leaves the surface's table for the side walls.
SurfaceLine on_surface(const ToothShape& shape, const std::string& name, const std::vector<Vec2>& path) {
  SurfaceLine line;
  line.name = name;
  const std::vector<Vec2> smooth = smooth_line<Vec2>(path, 16);
  double left = 0.0;
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    if (i > 0) left -= glm::length(smooth[i] - smooth[i - 1]);
    if (left > 0.0 && i + 1 < smooth.size()) continue;
    left = kLineStepMm;
    // from_table needs a height to undo the warp: that of the surface there, found in two rounds.
    Vec3 q = shape.from_table({smooth[i], shape.table().dims.crown_length * 0.7});
    auto p = shape.top_at(q.x, q.y);
    if (!p) break;
    q = shape.from_table({smooth[i], shape.to_table(*p).z});
    p = shape.top_at(q.x, q.y);
    if (!p || shape.beyond_rim(*p) > -kRimMm) break;
    line.points_mm.push_back(*p);
  }
  return line;
}

}  // namespace

ToothLandmarks find_landmarks(const ToothShape& shape) {
  const ToothTable& table = shape.table();
  ToothLandmarks out;
  out.dims = shape.dims();
  out.mesial_contact = shape.mesial_contact();
  out.distal_contact = shape.distal_contact();
  for (const CuspTable& cusp : table.cusps) {
    if (const auto tip = extreme(shape, shape.from_table(cusp.tip), 0.6, 1.0)) out.cusp_tips.push_back({cusp.name, *tip});
  }
  for (const PitTable& pit : table.pits) {
    const Vec3 start = shape.from_table({pit.at, table.floor_z});
    if (const auto bottom = extreme(shape, start, 0.3, -1.0)) out.pits.push_back({pit.name, *bottom});
  }
  for (const GrooveTable& groove : table.grooves) out.fissures.push_back(on_surface(shape, groove.name, groove.path));
  for (const RidgeTable& ridge : table.ridges) {
    if (ridge.name != "mesial marginal" && ridge.name != "distal marginal") continue;
    // The first and last points run into the cusp ridges (teeth.md) and are not the marginal ridge's own.
    std::vector<Vec2> path;
    for (std::size_t i = 1; i + 1 < ridge.path.size(); ++i) path.emplace_back(ridge.path[i].x, ridge.path[i].y);
    out.marginal_ridges.push_back(on_surface(shape, ridge.name, path));
  }
  constexpr int kAround = 72;
  const Vec3 axis = shape.from_table(Vec3(0.0));
  for (int i = 0; i <= kAround; ++i) {
    const double angle = 2.0 * 3.14159265358979323846 * (i % kAround) / kAround;
    const Vec3 out_way{std::cos(angle), std::sin(angle), 0.0};
    Vec3 p = axis;
    for (int round = 0; round < 6; ++round) {  // the height of the CEJ changes slowly with the place: settles in three
      const Vec3 from = Vec3(axis.x, axis.y, p.z) + 9.0 * out_way;
      const auto d = shape.march(from, -out_way, 9.0);
      if (!d) break;
      p = from - *d * out_way;
      p.z -= shape.above_cej(p);
    }
    out.cej.push_back(p);
  }
  for (const SurfacePlace& pit : out.pits) {
    if (pit.name == "central") out.central = pit.at_mm;
  }
  if (out.central == Vec3(0.0)) {
    for (const SurfaceLine& line : out.fissures) {
      if (line.name == "central" && !line.points_mm.empty()) out.central = line.points_mm[line.points_mm.size() / 2];
    }
  }
  if (out.central == Vec3(0.0)) {
    if (const auto top = shape.top_at(0.0, 0.0)) out.central = *top;
  }
  return out;
}

ToothLandmarks mirrored(ToothLandmarks l) {
  const auto turn = [](Vec3& p) { p.x = -p.x; };
  for (auto* places : {&l.cusp_tips, &l.pits}) {
    for (SurfacePlace& p : *places) turn(p.at_mm);
  }
  for (auto* lines : {&l.fissures, &l.marginal_ridges}) {
    for (SurfaceLine& line : *lines) std::for_each(line.points_mm.begin(), line.points_mm.end(), turn);
  }
  std::for_each(l.cej.begin(), l.cej.end(), turn);
  turn(l.mesial_contact);
  turn(l.distal_contact);
  turn(l.central);
  return l;
}

}  // namespace cusp::scenarios
