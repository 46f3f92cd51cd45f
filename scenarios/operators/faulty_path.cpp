#include "scenarios/operators/faulty_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "scenarios/operators/poses.h"
#include "scenarios/shapes/target.h"
#include "scenarios/shapes/tissue_shape.h"
#include "scenarios/teeth/own_tissues.h"

namespace cusp::scenarios {

namespace {

constexpr double kShakeStepMm = 0.15;
/// Lengths of the tremor's waves along the path: 8 to 12 Hz at 5 mm/s [M], with no common multiple.
constexpr std::array<double, 3> kWavesMm = {0.62, 0.47, 0.41};
constexpr double kWholeTurn = 6.283185307179586;
constexpr double kPitsApartMm = 1.3;
constexpr double kLookMm = 0.1;        // between places of a stroke that are looked at
constexpr double kFloorMm = 0.03;      // a tip is on the floor if the target ends so far below it
constexpr double kSparedMm = 0.1;      // between the bur and the own tooth beside a nick
constexpr double kSteepestNick = 4.0;    // times its depth, straight down: on a slope of 75 degrees
constexpr double kFurthestNickMm = 4.0;  // from the target's rectangle

Vec3 tremor_at(double along, double most_mm) {
  Vec3 out(0.0);
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t wave = 0; wave < kWavesMm.size(); ++wave)
      out[axis] += std::sin(kWholeTurn * along / kWavesMm[(wave + static_cast<std::size_t>(axis)) % 3] + 2.1 * axis + 1.3 * static_cast<double>(wave));
  return most_mm / 3.0 * out;
}

double above_of(const Plan& plan) { return plan.strokes.back().to_mm.z; }

/// Down beside nothing to `from`, cutting to `to`, and up again.
void add_plunge(Plan& plan, Vec3 from, double to_z, double above) {
  plan.strokes.push_back({Vec3(from.x, from.y, above), false});
  plan.strokes.push_back({from, false});
  plan.strokes.push_back({Vec3(from.x, from.y, to_z), true});
  plan.strokes.push_back({Vec3(from.x, from.y, above), false});
}

/// Highest tissue over each column of voxels, and whose it is.
struct Columns {
  explicit Columns(const Specimen& of) : grid(of.grid()) {
    top.assign(static_cast<std::size_t>(grid.size.x * grid.size.y), -1);
    tissue.assign(top.size(), Tissue::empty);
    IVec3 v;
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x)
        for (v.z = grid.size.z - 1; v.z >= 0; --v.z) {
          if (of.s(v) < kHalf) continue;
          top[at(v.x, v.y)] = v.z;
          tissue[at(v.x, v.y)] = of.tissue(v);
          break;
        }
  }
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * grid.size.x + x); }
  double height(std::size_t column) const { return grid.origin_mm.z + (top[column] + 0.5) * grid.voxel_mm; }

  const Grid& grid;
  std::vector<int> top;
  std::vector<Tissue> tissue;
};

/// Height of the pivot where the bur, from above, meets tissue; nullopt if that, or anything near, is no neighbour.
std::optional<double> touch_down(const Columns& columns, const Poses& poses, int x, int y) {
  const double step = columns.grid.voxel_mm, reach = poses.spread_mm() + kSparedMm;
  const int far = static_cast<int>(std::ceil(reach / step));
  double out = -std::numeric_limits<double>::infinity();
  for (int dy = -far; dy <= far; ++dy)
    for (int dx = -far; dx <= far; ++dx) {
      const double off = step * std::sqrt(static_cast<double>(dx * dx + dy * dy));
      const int i = x + dx, j = y + dy;
      if (off > reach || i < 0 || j < 0 || i >= columns.grid.size.x || j >= columns.grid.size.y) continue;
      const std::size_t column = columns.at(i, j);
      if (columns.top[column] < 0) continue;
      if (!is_neighbour(columns.tissue[column])) return std::nullopt;
      if (off <= poses.spread_mm()) out = std::max(out, columns.height(column) - poses.underside_mm(Vec2(dx, dy), off));
    }
  return std::isfinite(out) ? std::optional(out) : std::nullopt;
}

/// How deep the bur's underside stands in a shape, at right angles to its surface; `pivot`: the bur's.
double depth_in(const TissueShape& shape, const Poses& poses, Vec3 pivot, double step) {
  const int far = static_cast<int>(std::floor(poses.spread_mm() / step));
  double most = 0.0;
  for (int j = -far; j <= far; ++j)
    for (int i = -far; i <= far; ++i) {
      const double off = step * std::sqrt(static_cast<double>(i * i + j * j));
      if (off <= poses.spread_mm()) most = std::max(most, -shape.distance_mm(pivot + Vec3(step * i, step * j, poses.underside_mm(Vec2(i, j), off))));
    }
  return most;
}

/// Below a touch: the height of the pivot where the bur stands so deep in the neighbour. On a slope that is further down than deep_mm.
double height_of_nick(const Specimen& specimen, const Poses& poses, Vec3 touch, double deep_mm) {
  TissueSet tissues{};
  tissues[index_of(kNeighbourEnamel)] = tissues[index_of(kNeighbourDentine)] = true;
  const TissueShape neighbour(lent(specimen), tissues);
  double low = touch.z - kSteepestNick * deep_mm, high = touch.z;
  for (int pass = 0; pass < 20; ++pass) {
    const double middle = 0.5 * (low + high);
    (depth_in(neighbour, poses, Vec3(touch.x, touch.y, middle), 0.5 * specimen.grid().voxel_mm) < deep_mm ? high : low) = middle;
  }
  return high;
}

}  // namespace

Bur wider(const Bur& bur, double by_mm) {
  const double scale = (bur.radius_mm + by_mm) / bur.radius_mm;
  Bur out = bur;
  out.radius_mm *= scale;
  out.head = Profile();
  const auto scaled = [scale](OnHalf p) { return OnHalf{scale * p.t, scale * p.rho}; };
  for (int i = 0; i < bur.head.size(); ++i) {
    const OutlinePiece& piece = bur.head.piece(i);
    static_cast<void>(out.head.add({scaled(piece.from), scaled(piece.to), scaled(piece.centre), scale * piece.radius}));
  }
  return out;
}

void raise(Plan& plan, double by_mm) {
  plan.start_mm += by_mm * plan.axis;
  for (Stroke& stroke : plan.strokes) stroke.to_mm += by_mm * plan.axis;
}

void shake(Plan& plan, double most_mm) {
  std::vector<Stroke> out;
  Vec3 at = plan.start_mm;
  double along = 0.0;
  for (const Stroke& stroke : plan.strokes) {
    const double length = glm::length(stroke.to_mm - at);
    const int steps = stroke.cut ? std::max(1, static_cast<int>(std::ceil(length / kShakeStepMm))) : 1;
    for (int i = 1; i <= steps; ++i) {
      along += length / steps;
      const Vec3 p = at + (static_cast<double>(i) / steps) * (stroke.to_mm - at);
      out.push_back({stroke.cut ? p + tremor_at(along, most_mm) : p, stroke.cut});
    }
    at = stroke.to_mm;
  }
  plan.strokes = std::move(out);
}

bool add_pits(Plan& plan, const CutTools& tools, double deep_mm) {
  const Vec3 low = Poses(tools.target, tools.specimen, tools.bur, Vec3(0.0), 0.0, 0.0, Top::moved, plan.axis).lowest();
  const double above = above_of(plan);
  std::vector<Vec3> pits;
  Vec3 at = plan.start_mm;
  for (const Stroke& stroke : plan.strokes) {
    const double length = glm::length(stroke.to_mm - at);
    const int steps = std::max(1, static_cast<int>(std::ceil(length / kLookMm)));
    for (int i = 1; stroke.cut && i <= steps; ++i) {
      const Vec3 p = at + (static_cast<double>(i) / steps) * (stroke.to_mm - at);
      const Near near = tools.target.near(p + (low - Vec3(0.0, 0.0, kFloorMm)));
      if (near.distance_mm <= 0.0 || near.face != FaceName::pulpal_floor) continue;
      const bool taken = std::ranges::any_of(pits, [p](Vec3 pit) { return glm::length(Vec2(pit.x - p.x, pit.y - p.y)) < kPitsApartMm; });
      if (!taken) pits.push_back(p);
    }
    at = stroke.to_mm;
  }
  for (const Vec3& pit : pits) add_plunge(plan, pit, pit.z - deep_mm, above);
  return !pits.empty();
}

bool add_way_into_pulp(Plan& plan, const Scenario& scenario, const Specimen& specimen, double deep_mm) {
  const std::size_t before = plan.strokes.size();
  add_way_to_pulp(scenario, specimen, plan);
  if (plan.strokes.size() == before) return false;
  const double radius = scenario.instruments[plan.bur].radius_mm;
  Vec3& deepest = plan.strokes[plan.strokes.size() - 2].to_mm;  // its tip lies two radii below the voxel's centre
  deepest += (2.0 * radius + 0.5 * specimen.grid().voxel_mm - deep_mm) / plan.axis.z * plan.axis;
  return true;
}

bool add_nick(Plan& plan, const CutTools& tools, double deep_mm) {
  const Columns columns(tools.specimen);
  const Poses poses(tools.target, tools.specimen, tools.bur, Vec3(0.0), 0.0, 0.0, Top::moved, plan.axis);
  const Grid& grid = tools.specimen.grid();
  double least = kFurthestNickMm;
  std::optional<Vec3> best;
  for (int y = 0; y < grid.size.y; ++y)
    for (int x = 0; x < grid.size.x; ++x) {
      if (!is_neighbour(columns.tissue[columns.at(x, y)])) continue;
      const Vec3 p = grid.centre_mm({x, y, 0});
      const Vec2 out = glm::max(glm::max(tools.target.low() - Vec2(p.x, p.y), Vec2(p.x, p.y) - tools.target.high()), Vec2(0.0));
      const double off = glm::length(out);
      if (off >= least) continue;
      const auto height = touch_down(columns, poses, x, y);
      if (!height) continue;
      least = off;
      best = Vec3(p.x, p.y, *height);
    }
  if (best) add_plunge(plan, *best, height_of_nick(tools.specimen, poses, *best, deep_mm), above_of(plan));
  return best.has_value();
}

}  // namespace cusp::scenarios
