#include "tests/bench/removal_ways.h"

#include <algorithm>
#include <cmath>

#include "engine/tool/swept.h"
#include "engine/volume/cut_volume.h"
#include "engine/volume/surface_cells.h"
#include "tests/bench/frame.h"
#include "tests/bench/motions.h"

namespace cusp::bench {

namespace {

constexpr double kHalfMm = 2.6;          // of the block, across; half as deep
constexpr double kEdgeVoxels = 3.0;      // nearer to the face than this a cell sees the mouth's edge
constexpr double kWayMm = 2.4;
constexpr double kBeginMm = 0.02;        // of the burr behind the face, where a way begins
constexpr double kBelow = 0.5;           // radii of the pivot behind the face, where it ends
constexpr double kEdgeCosine = 0.9;      // normals a voxel and a half apart that differ by more: an edge lies between
constexpr int kPlungeTicks = 3;          // to there, straight down

Frame way_frame() { return Frame::of(kWayUp, {1.0, 0.51, 0.0}, Vec3(0.0)); }

Vec3 way_axis(Way way) {
  const Frame f = way_frame();
  return way == Way::tilted ? unit(f.direction({0.3, 0.45, 0.84})) : f.z;
}

/// Where a way leads, `s` mm from its beginning: down until the pivot is half a radius behind the face, so that a ball's
/// top, and with it the neck, stays out.
Vec3 place_on(Way way, double s, double radius) {
  const Frame f = way_frame();
  constexpr double kTurnMm = 1.2, kAside = 0.2;
  const double fall = ((1.0 + kBelow) * radius - kBeginMm) / kWayMm;
  const double along = s / std::sqrt(1.0 + fall * fall + (way == Way::curved ? 0.0 : kAside * kAside));
  const double z = radius - kBeginMm - fall * along;
  const double a = along / kTurnMm;
  if (way == Way::curved)
    return f.to_world({kTurnMm * std::sin(a), kTurnMm * (std::cos(a) - 1.0) + 0.6, z});
  return f.to_world({along - 1.2, kAside * (along - 1.0), z});
}

}  // namespace

std::vector<Vec3> points_of(Way way, double speed_mm_s, double tick_ms, double radius_mm, double corner_mm) {
  const double each = speed_mm_s * tick_ms * 1e-3;
  std::vector<Vec3> out;
  const auto count = static_cast<int>(kWayMm / each + 1e-6);
  for (int i = 0; i <= count; ++i) {
    const double s = i * each;
    if (corner_mm > 0.0) {
      const double low = std::floor(s / corner_mm + 1e-9) * corner_mm;
      const Vec3 a = place_on(way, low, radius_mm), b = place_on(way, low + corner_mm, radius_mm);
      out.push_back(a + (b - a) * ((s - low) / corner_mm));
    } else {
      out.push_back(place_on(way, s, radius_mm));
    }
    out.back() = input_at(out.back()).position_mm();
  }
  return out;
}

std::shared_ptr<Scene> soft_scene(const Cutter& cutter, Method method, double voxel_mm, Way way) {
  const Frame f = way_frame();
  const int n = 2 * static_cast<int>(std::ceil(1.25 * kHalfMm / voxel_mm)) + 9;
  const Grid grid{IVec3(n, n, (n * 3) / 4), voxel_mm, Vec3(-0.5 * (n - 1) * voxel_mm, -0.5 * (n - 1) * voxel_mm, -0.55 * (n - 1) * voxel_mm)};
  VoxelVolume dense(grid);
  IVec3 v;
  for (v.z = 0; v.z < grid.size.z; ++v.z)
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x) {
        const Vec3 p = f.to_local(grid.centre_mm(v));
        const Vec3 beyond = glm::abs(p - Vec3(0.0, 0.0, -0.5 * kHalfMm)) - Vec3(kHalfMm, kHalfMm, 0.5 * kHalfMm);
        const Vec3 outside = glm::max(beyond, Vec3(0.0));
        const double d = length(outside) + std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0);
        const std::size_t i = grid.index(v);
        dense.s[i] = solid_from_distance(d / voxel_mm);
        if (dense.s[i] > 0) dense.tissue[i] = Tissue::dentine;
      }
  auto scene = std::make_shared<Scene>();
  scene->method = method;
  scene->specimen = Specimen::build(dense, reading_of(method));
  scene->burrs = {cutter.burr};
  scene->tool_axis = way_axis(way);
  for (TissueFeel& feel : scene->tissues) feel = {1.0, 1e5};
  scene->full_force_n = 1e-9;
  scene->guard = unguarded();
  return scene;
}

ShapeLeft lead_along(const Cutter& cutter, double voxel_mm, Way way, const std::vector<Vec3>& points, double tick_ms,
                     int halves) {
  StepState state(soft_scene(cutter, Method::surface, voxel_mm, way));
  const auto tick_us = static_cast<std::uint32_t>(tick_ms * 1000.0 + 0.5);
  const std::size_t part = (points.size() + static_cast<std::size_t>(halves) - 1) / static_cast<std::size_t>(halves);
  const Frame f = way_frame();
  const Vec3 above = points.front() + f.z * (2.0 * kBeginMm);
  step(state, input_at(above, false));
  for (int k = 0; k < kPlungeTicks; ++k) step(state, input_at(points.front(), true));
  for (std::size_t i = 0; i < points.size(); ++i) {
    // At a half's end the button is up for a tick, where the burr stands.
    if (i > 0 && i % part == 0) step(state, input_at(points[i - 1], false));
    StepInput input = input_at(points[i], true);
    input.elapsed_us = tick_us;
    step(state, input);
  }
  step(state, input_at(points.back(), false));

  ShapeLeft out;
  const Volume& volume = state.volume();
  out.removed_mm3 = removed_solid(volume).total_mm3();
  const Vec3 axis = state.scene().tool_axis;
  // Straight stretches as one: then it is quick.
  std::vector<Vec3> corners{above, points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec3 a = unit(points[i] - corners.back()), b = points[i + 1] - corners.back();
    if (length(b - a * glm::dot(a, b)) > 5e-6) corners.push_back(points[i]);
  }
  corners.push_back(points.back());
  const auto swept = [&](Vec3 p, Vec3& normal) {
    double d = 1e300;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Passing passing = passing_head(cutter.burr, axis, corners[i - 1], corners[i], p, d);
      if (passing.distance_mm >= d) continue;
      d = passing.distance_mm;
      normal = passing.gradient;
    }
    return d;
  };
  double sum = 0.0;
  for (const std::int32_t brick : volume.cut_bricks()) {
    const IVec3 corner = volume.specimen().brick_at(brick) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; ++o) {
      SurfacePoint p;
      if (!surface_point(volume, corner + IVec3(o & 7, o >> 3 & 7, o >> 6), p) || !p.cut) continue;
      if (f.to_local(p.point_mm).z > -kEdgeVoxels * voxel_mm) continue;
      Vec3 normal(0.0);
      const double d = swept(p.point_mm, normal);
      if (!cutter.burr.head.ball()) {
        bool edge = false;
        for (int k = 0; k < 6 && !edge; ++k) {
          Vec3 beside = p.point_mm, other(0.0);
          beside[k % 3] += (k < 3 ? 1.5 : -1.5) * voxel_mm;
          swept(beside, other);
          edge = glm::dot(normal, other) < kEdgeCosine;
        }
        if (edge) continue;
      }
      sum += std::fabs(d) * 1e3;
      out.most_um = std::max(out.most_um, std::fabs(d) * 1e3);
      ++out.points;
    }
  }
  if (out.points > 0) out.mean_um = sum / static_cast<double>(out.points);
  return out;
}

}  // namespace cusp::bench
