#include "scenarios/operators/plan.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "scenarios/format/tool_axis.h"
#include "scenarios/operators/fast_cut.h"
#include "scenarios/operators/region_plan.h"
#include "scenarios/shapes/target.h"

namespace cusp::scenarios {

namespace {

using Line = std::vector<Vec2>;

/// Depth of a layer in bur radii, and below the distance of neighbouring loops: the ball leaves ridges of step² / 8r.
constexpr double kLayerRadii = 0.75;
/// On the filled reading a layer is deep enough for the bur's widest part to face a wall: against a slope the paper's
/// proxy climbs out instead of cutting. The ridges are then below a voxel.
constexpr double kSteppedLayerRadii = 1.2;
constexpr double kLoopRadii = 0.5;
/// Loops nearer than this to the middle are the middle line itself.
constexpr double kThinMm = 0.02;
/// Free height above the specimen for moves from one path to the next.
constexpr double kClearMm = 1.0;
/// A narrower bur has to leave less by this share of the target.
constexpr double kLittle = 0.01;
/// A bur that leaves more than this share does not fit.
constexpr double kMuch = 0.8;
constexpr double kArcStep = std::numbers::pi / 6.0;
/// How far inside its circle a loop about a point may lie. The outermost draws the whole wall of a disc: with sides of
/// kArcStep a disc of 4 mm loses 2.4 % of its area. tests/scenarios/library/reference_test.cpp fails if it is 0.04.
constexpr double kRoundErrorMm = 0.004;

Vec2 turned(Vec2 v, double angle) noexcept {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// Points of an arc about a centre from one offset to another, by the shorter way (clockwise at half a turn).
void arc(Vec2 centre, Vec2 from, Vec2 to, Line& out) {
  double angle = std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
  if (angle > std::numbers::pi - 1e-6) angle = -angle;
  const int steps = static_cast<int>(std::ceil(std::fabs(angle) / kArcStep));
  for (int i = 1; i < steps; ++i) out.push_back(centre + turned(from, angle * i / steps));
  out.push_back(centre + to);
}

/// A circle about a point, as a closed polygon inside it.
Line round_loop(Vec2 centre, double off) {
  const double step = std::min(kArcStep, 2.0 * std::acos(std::max(0.0, 1.0 - kRoundErrorMm / off)));
  const int sides = static_cast<int>(std::ceil(2.0 * std::numbers::pi / step));
  Line out;
  for (int i = 0; i <= sides; ++i) out.push_back(centre + turned(Vec2(off, 0.0), 2.0 * std::numbers::pi * (i % sides) / sides));
  return out;
}

/// Round a polyline at a distance: along its left, about its end, back along its right, about its start. All of it is
/// within `off` of the polyline, so a bur that fits the width by `off` stays inside the outline.
Line loop_round(const Line& path, double off) {
  if (off < kThinMm) return path;
  if (path.size() < 2) return round_loop(path.front(), off);
  Line out;
  const auto left = [&](std::size_t i) {
    const Vec2 d = glm::normalize(path[i + 1] - path[i]);
    return off * Vec2(-d.y, d.x);
  };
  const std::size_t segments = path.size() - 1;
  out.push_back(path[0] + left(0));
  for (std::size_t i = 0; i < segments; ++i) {
    out.push_back(path[i + 1] + left(i));
    arc(path[i + 1], left(i), i + 1 < segments ? left(i + 1) : -left(i), out);
  }
  for (std::size_t i = segments; i-- > 0;) {
    out.push_back(path[i] - left(i));
    arc(path[i], -left(i), i > 0 ? -left(i - 1) : left(0), out);
  }
  return out;
}

/// The line begun at its point nearest to `here`: a loop at any of its points, an open line at one of its ends.
Line from_nearest(const Line& line, Vec2 here) {
  if (line.size() < 2) return line;
  Line out = line;
  if (glm::length(line.front() - line.back()) > 1e-6) {
    if (glm::length(line.back() - here) < glm::length(line.front() - here)) std::reverse(out.begin(), out.end());
    return out;
  }
  out.pop_back();
  const auto nearest = std::min_element(out.begin(), out.end(), [here](Vec2 a, Vec2 b) {
    return glm::length(a - here) < glm::length(b - here);
  });
  std::rotate(out.begin(), nearest, out.end());
  out.push_back(out.front());
  return out;
}

/// Leaves out points that are nearer than this to the one before; the last one stays.
void thin_out(Line& line, double least) {
  Line out;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (i == 0 || i + 1 == line.size() || glm::length(line[i] - out.back()) >= least) out.push_back(line[i]);
  line = std::move(out);
}

/// Rectangles from the wall inwards, one inside the other.
Line rectangle(Vec2 centre, Vec2 half) {
  return {centre - half, centre + Vec2(half.x, -half.y), centre + half, centre + Vec2(-half.x, half.y), centre - half};
}

/// The lines of one layer, each about or inside the next, so that the stroke between them stays inside the outline.
/// `slack`: the most that the bur's centre may leave the middle, mm.
std::vector<Line> lines_of(const Outline& target, std::size_t path, double slack, double radius, Vec2 shift) {
  std::vector<Line> out;
  const double step = kLoopRadii * radius;
  if (target.shape == "box") {
    const Vec2 c = Vec2(target.paths[0][0].x, target.paths[0][0].y) + shift;
    const double least = 0.5 * std::min(target.box_size_mm.x, target.box_size_mm.y);
    const Vec2 half = glm::max(0.5 * Vec2(target.box_size_mm.x, target.box_size_mm.y) - least + slack, Vec2(0.0));
    for (double in = 0.0;; in += step) {
      const Vec2 h = glm::max(half - in, Vec2(0.0));
      out.push_back(rectangle(c, h));
      if (h.x <= 0.0 || h.y <= 0.0) break;
    }
    std::reverse(out.begin(), out.end());
    return out;
  }
  Line line;
  for (const Vec3& p : target.paths[path]) {
    const Vec2 q = Vec2(p.x, p.y) + shift;
    if (line.empty() || glm::length(q - line.back()) > 1e-6) line.push_back(q);
  }
  if (line.empty()) return out;
  // The innermost first: it opens the slot for the others.
  const int loops = slack < kThinMm ? 1 : static_cast<int>(std::ceil((slack - 0.5 * step) / step)) + 1;
  for (int i = std::max(loops, 1); i-- > 0;) out.push_back(loop_round(line, std::max(0.0, slack - i * step)));
  return out;
}

std::optional<std::size_t> best_bur(const Scenario& scenario, double half_width) {
  std::optional<std::size_t> best;
  const auto& burs = scenario.instruments;
  for (std::size_t i = 0; i < burs.size(); ++i) {
    const bool fits = burs[i].radius_mm <= std::min(half_width, scenario.target.outline.corner_radius_mm) + 1e-6;
    if (!best) {
      best = i;
      continue;
    }
    const bool best_fits =
        burs[*best].radius_mm <= std::min(half_width, scenario.target.outline.corner_radius_mm) + 1e-6;
    if (fits ? (!best_fits || burs[i].radius_mm > burs[*best].radius_mm)
             : (!best_fits && burs[i].radius_mm < burs[*best].radius_mm))
      best = i;
  }
  return best;
}

/// Highest tissue of the whole specimen, and within `reach` of a line; mm.
double highest(const Specimen& specimen, const std::vector<Line>* near, double reach) {
  const Grid& grid = specimen.grid();
  double top = grid.origin_mm.z;
  IVec3 v;
  for (v.y = 0; v.y < grid.size.y; ++v.y)
    for (v.x = 0; v.x < grid.size.x; ++v.x) {
      if (near != nullptr) {
        const Vec3 at = grid.centre_mm({v.x, v.y, 0});
        bool within = false;
        for (const Line& line : *near)
          for (std::size_t i = 0; i < line.size() && !within; ++i)
            within = segment_distance({at.x, at.y}, line[i], line[std::min(i + 1, line.size() - 1)]) < reach;
        if (!within) continue;
      }
      for (v.z = grid.size.z - 1; v.z >= 0; --v.z) {
        const double z = grid.centre_mm(v).z + 0.5 * grid.voxel_mm;
        if (z <= top) break;
        if (specimen.s(v) >= kHalf) {
          top = z;
          break;
        }
      }
    }
  return top;
}

/// The pulp voxel that is easiest to reach from the floor: least height to go, well inside the outline.
std::optional<Vec3> easiest_pulp(const Specimen& specimen, const TargetShape& shape) {
  const Grid& grid = specimen.grid();
  std::optional<Vec3> best;
  double least = 1e9;
  IVec3 v;
  for (v.z = 0; v.z < grid.size.z; ++v.z)
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x) {
        if (specimen.tissue(v) != Tissue::pulp || specimen.s(v) < kHalf) continue;
        const Vec3 p = grid.centre_mm(v);
        const double u = shape.outline_mm({p.x, p.y});
        const double cost = shape.below_floor_mm(p.z) + (u > 0.0 ? 3.0 * u : 0.3 * u);
        if (cost < least) {
          least = cost;
          best = p;
        }
      }
  return best;
}

double clear_height(const Specimen& specimen, double radius) { return highest(specimen, nullptr, 0.0) + radius + kClearMm; }

double layer_radii_of(const Scenario& scenario) noexcept {
  return reading_of(scenario.method) == Reading::banded ? kLayerRadii : kSteppedLayerRadii;
}

/// One path of an outline, from above its start to above its end.
void add_path(const Scenario& scenario, const Specimen& specimen, std::vector<Line> lines, double floor, double layer_mm,
              Plan& plan) {
  const double r = scenario.instruments[plan.bur].radius_mm, above = clear_height(specimen, r);
  const bool banded = reading_of(scenario.method) == Reading::banded;
  const auto travel = [&plan](Vec2 p, double z) { plan.strokes.push_back({Vec3(p, z), false}); };
  const auto cut = [&plan](Vec2 p, double z) { plan.strokes.push_back({Vec3(p, z), true}); };
  if (!banded)
    for (Line& line : lines) thin_out(line, specimen.grid().voxel_mm);
  const double top = highest(specimen, &lines, r) + r;
  if (plan.strokes.empty()) plan.start_mm = Vec3(lines.front().front(), above);
  travel(lines.front().front(), above);
  travel(lines.front().front(), std::max(top, floor) + 0.1);
  const int layers = std::max(1, static_cast<int>(std::ceil((top - floor) / layer_mm)));
  for (int layer = 1; layer <= layers; ++layer) {
    const double z = layer == layers ? floor : top - (top - floor) * layer / layers;
    // The floor takes two passes: the second removes the uncut remainder where the bur slipped or was held.
    const int times = layer == layers && banded ? 2 : 1;
    for (int time = 0; time < times; ++time)
      for (const Line& line : lines) {
        const Vec3 here = plan.strokes.back().to_mm;
        const Line way = from_nearest(line, {here.x, here.y});
        if (here.z > z) cut({here.x, here.y}, z);
        for (const Vec2& p : way) cut(p, z);
      }
  }
  const Vec3 last = plan.strokes.back().to_mm;
  travel({last.x, last.y}, above);
}

Plan plan_outline(const Scenario& scenario, const Specimen& specimen, const TargetShape& shape, const PlanErrors& errors) {
  Plan plan;
  const Outline& target = scenario.target.outline;
  plan.bur = static_cast<std::uint16_t>(*best_bur(scenario, shape.half_width_mm()));
  const double r = scenario.instruments[plan.bur].radius_mm;
  const double slack = std::max(0.0, shape.half_width_mm() - r + errors.wider_mm);
  const double floor = shape.floor_mm() - errors.deeper_mm + r;  // of the bur's centre
  const Vec2 shift(errors.shift_mm.x, errors.shift_mm.y);
  const std::size_t paths = target.shape == "box" ? 1 : target.paths.size();
  for (std::size_t path = 0; path < paths; ++path) {
    std::vector<Line> lines = lines_of(target, path, slack, r, shift);
    if (!lines.empty()) add_path(scenario, specimen, std::move(lines), floor, errors.bolder * layer_radii_of(scenario) * r, plan);
  }
  return plan;
}

/// Tissue of the target that stands after a plan's cuts, of all that stood.
double share_left(const Plan& plan, const Scenario& scenario, const std::shared_ptr<const Specimen>& specimen, const Poses& poses) {
  Volume volume(specimen);
  static_cast<void>(cut_along(plan, scenario, volume));
  const Grid& grid = specimen->grid();
  const auto voxel = [&](Vec3 p) { return IVec3(glm::floor((p - grid.origin_mm) / grid.voxel_mm)); };
  const IVec3 low = glm::max(voxel(Vec3(poses.low(), poses.floor_mm())), IVec3(0));
  const IVec3 high = glm::min(voxel(Vec3(poses.high(), 0.0)) + 1, grid.size - 1);
  double before = 0.0, after = 0.0;
  IVec3 v;
  for (v.z = low.z; v.z < grid.size.z; ++v.z)
    for (v.y = low.y; v.y <= high.y; ++v.y)
      for (v.x = low.x; v.x <= high.x; ++v.x) {
        if (specimen->s(v) < kHalf || poses.target_mm(grid.centre_mm(v)) > 0.0) continue;
        before += 1.0;
        after += std::clamp(0.5 - distance_from_solid(volume.s(v)), 0.0, 1.0);
      }
  return before > 0.0 ? after / before : 1.0;
}

/// Each bur's plan is cut; the widest bur is taken of those that leave about the least.
Plan plan_burs(const Scenario& scenario, const Specimen& specimen, const TargetShape& shape, const PlanErrors& errors, Top top,
               PlanCancel cancel) {
  std::vector<std::uint16_t> burs(scenario.instruments.size());
  std::iota(burs.begin(), burs.end(), std::uint16_t{0});
  std::ranges::stable_sort(burs, std::greater{}, [&](std::uint16_t bur) { return scenario.instruments[bur].radius_mm; });
  // What is wider is deeper too: that is not asked here.
  const Vec3 moved(errors.shift_mm.x, errors.shift_mm.y, errors.wider_mm - errors.deeper_mm);
  const RegionPlanStyle style{.layer_radii = errors.bolder * layer_radii_of(scenario)};
  const std::shared_ptr<const Specimen> borrowed = lent(specimen);
  Plan best;
  double least = kMuch;
  for (const std::uint16_t bur : burs) {
    const Poses poses(shape, specimen, scenario.instruments[bur], moved, errors.wider_mm, errors.clear_mm, top,
                      resting_axis(scenario.tool_tilt_deg));
    Plan plan = plan_region(poses, clear_height(specimen, poses.radius_mm()), style, cancel);
    if (is_cancelled(cancel)) return {};
    if (plan.strokes.empty()) continue;
    plan.bur = bur;
    const double left = share_left(plan, scenario, borrowed, poses);
    if (left >= least - kLittle) continue;
    least = left;
    best = std::move(plan);
    if (least <= kLittle) break;
  }
  return best;
}

/// A target that ends at the surface, moved down, lies under tissue that no bur may pass. It then keeps its top.
Plan plan_tree(const Scenario& scenario, const Specimen& specimen, const TargetShape& shape, const PlanErrors& errors, PlanCancel cancel) {
  Plan plan = plan_burs(scenario, specimen, shape, errors, Top::moved, cancel);
  const bool may_enter = !plan.strokes.empty() || errors.deeper_mm <= 0.0 || is_cancelled(cancel);
  return may_enter ? plan : plan_burs(scenario, specimen, shape, errors, Top::kept, cancel);
}

}  // namespace

bool cut_in_loops(const Scenario& scenario, const TargetShape& target) noexcept {
  return target.upright() != nullptr && scenario.tool_tilt_deg == 0.0;
}

void add_way_to_pulp(const Scenario& scenario, const Specimen& specimen, Plan& plan) {
  const TargetShape shape(scenario.target, lent(specimen));
  const double radius = scenario.instruments[plan.bur].radius_mm;
  const std::optional<Vec3> pulp = easiest_pulp(specimen, shape);
  if (!pulp) return;
  const double above = clear_height(specimen, radius);
  const auto at = [&](double z) {
    const Vec3 along = (z - pulp->z) / plan.axis.z * plan.axis;
    return Vec3(pulp->x + along.x, pulp->y + along.y, z);
  };
  plan.strokes.push_back({at(above), false});
  plan.strokes.push_back({at(std::max(shape.floor_mm() + 2.0 * radius, pulp->z + 2.0 * radius)), false});
  plan.strokes.push_back({at(pulp->z - radius), true});
  plan.strokes.push_back({at(above), false});
}

Plan plan_target(const Scenario& scenario, const Specimen& specimen, const PlanErrors& errors, PlanCancel cancel) {
  const TargetShape shape(scenario.target, lent(specimen));
  if (shape.empty() || scenario.instruments.empty()) return {};
  Plan plan = cut_in_loops(scenario, shape) ? plan_outline(scenario, specimen, shape, errors)
                                            : plan_tree(scenario, specimen, shape, errors, cancel);
  if (errors.drill_to_pulp && !plan.strokes.empty()) add_way_to_pulp(scenario, specimen, plan);
  return plan;
}

}  // namespace cusp::scenarios
