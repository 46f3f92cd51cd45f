#include "tests/bench/removal_paths.h"

#include <algorithm>
#include <cmath>

#include "engine/tool/swept.h"
#include "engine/volume/cut_volume.h"
#include "engine/volume/surface_cells.h"
#include "tests/bench/frame.h"
#include "tests/bench/motions.h"
#include "tests/bench/swept_bur.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"

namespace cusp::bench {

namespace {

constexpr double kBallBlockHalfMm = 2.6;          // mm; half width of a ball's block
constexpr double kRoundMm = 0.6;         // mm of tissue about the path of another bur
constexpr double kEdgeVoxels = 3.0;      // voxels; nearer to the face a cell contains the edge of the mouth
constexpr double kPathMm = 2.4;
constexpr double kObliqueAsideMm = 0.2;         // mm aside per millimetre of an oblique path
constexpr double kTurnMm = 1.2;          // mm; radius of a curved path
constexpr double kSidewaysMm = 1.5;
constexpr double kBeginMm = 0.02;        // mm of the bur behind the face at the start
constexpr double kBelow = 0.5;           // radii of a ball's pivot behind the face at the end
constexpr double kFallMm = 0.5;          // mm of descent along the path with another bur
constexpr double kInMm = 0.05;           // mm a tick during the entry
constexpr double kSurfaceEdgeCosine = 0.9;      // normals 1.5 voxels apart that differ by more have an edge between them
constexpr double kOnSkinVoxels = 0.05;

bool upright(Path path) { return path == Path::drilled || path == Path::sideways; }

Frame path_frame() { return Frame::of(kPathUp, {1.0, 0.51, 0.0}, Vec3(0.0)); }

Vec3 path_axis(Path path) {
  const Frame f = path_frame();
  return path == Path::tilted ? unit(f.direction({0.3, 0.45, 0.84})) : f.z;
}

/// Depths of a bur at its path's end, along the normal of the face, mm.
struct Depths {
  double low = 0.0;   // from the pivot to the lowest point of the head
  double sunk = 0.0;  // of that point behind the face at the end
  double fall = 0.0;  // part of sunk that the path descends
};
Depths depths_of(const Cutter& cutter, Path path) {
  const Bur& bur = cutter.bur;
  if (bur.head.ball()) {
    const double sunk = (1.0 + kBelow) * bur.radius_mm;
    return {bur.radius_mm, sunk, upright(path) ? 0.0 : sunk - kBeginMm};
  }
  const Frame f = path_frame();
  const Vec3 axis = path_axis(path);
  const double low = -glm::dot(head_furthest(bur, axis, -f.z), f.z);
  // The lowest point of the head's upper end stays outside, and with it the neck.
  const double cosine = glm::dot(axis, f.z);
  const double rim = bur.head.piece(bur.head.size() - 1).from.rho;
  const double top = bur.head.high() * cosine - rim * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  const double sunk = std::min(low + top - kHeadOutMm, kDeepestMm);
  return {low, sunk, upright(path) ? 0.0 : std::min(kFallMm, 0.5 * sunk)};
}

double length_of(Path path) { return path == Path::drilled ? 0.0 : path == Path::sideways ? kSidewaysMm : kPathMm; }

/// Place `s` mm from the beginning of a path.
Vec3 point_on(Path path, double s, const Depths& depths) {
  const Frame f = path_frame();
  const double fall = depths.fall / kPathMm;
  const double begin = depths.low - (depths.sunk - depths.fall);
  if (upright(path)) return f.to_world({s - 0.5 * length_of(path), 0.0, begin});
  const double along = s / std::sqrt(1.0 + fall * fall + (path == Path::curved ? 0.0 : kObliqueAsideMm * kObliqueAsideMm));
  const double z = begin - fall * along;
  const double a = along / kTurnMm;
  if (path == Path::curved) return f.to_world({kTurnMm * std::sin(a), kTurnMm * (std::cos(a) - 1.0) + 0.6, z});
  return f.to_world({along - 1.2, kObliqueAsideMm * (along - 1.0), z});
}

/// Device points of the entry, one a tick; the first is clear of the face. None repeats, because a bur at rest ends its
/// stroke.
std::vector<Vec3> entry_points(const Cutter& cutter, Path path, Vec3 to) {
  const Vec3 axis = path_axis(path);
  if (cutter.bur.head.ball() && !upright(path)) return {to + path_frame().z * (2.0 * kBeginMm)};
  const Depths depths = depths_of(cutter, path);
  const double deep = (depths.sunk - depths.fall) / glm::dot(axis, path_frame().z) + 2.0 * kBeginMm;
  const int ticks = static_cast<int>(deep / kInMm) + 1;
  std::vector<Vec3> out;
  for (int k = 0; k < ticks; ++k)
    out.push_back(input_at(to + axis * (deep * (1.0 - static_cast<double>(k) / ticks))).position_mm());
  return out;
}

/// All places of the pivot, in order, without repetition.
std::vector<Vec3> places_of(const Cutter& cutter, Path path, const std::vector<Vec3>& points) {
  std::vector<Vec3> out = entry_points(cutter, path, points.front());
  out.insert(out.end(), points.begin(), points.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace

std::vector<Vec3> points_of(Path path, const Cutter& cutter, const Feeding& feeding) {
  const double each = feeding.speed_mm_s * feeding.tick_ms * 1e-3, corner_mm = feeding.corner_mm;
  const Depths depths = depths_of(cutter, path);
  std::vector<Vec3> out;
  const auto count = static_cast<int>(length_of(path) / each + 1e-6);
  for (int i = 0; i <= count; ++i) {
    const double s = i * each;
    if (corner_mm > 0.0) {
      const double low = std::floor(s / corner_mm + 1e-9) * corner_mm;
      const Vec3 a = point_on(path, low, depths), b = point_on(path, low + corner_mm, depths);
      out.push_back(a + (b - a) * ((s - low) / corner_mm));
    } else {
      out.push_back(point_on(path, s, depths));
    }
    out.back() = input_at(out.back()).position_mm();
  }
  return out;
}

std::shared_ptr<Scene> soft_scene(const Cutter& cutter, Method method, double voxel_mm, Path path) {
  const Frame f = path_frame();
  // Box of tissue in the axes of the face.
  Vec3 low(-kBallBlockHalfMm), high(kBallBlockHalfMm, kBallBlockHalfMm, 0.0);
  Grid grid;
  if (cutter.bur.head.ball()) {
    const int n = 2 * static_cast<int>(std::ceil(1.25 * kBallBlockHalfMm / voxel_mm)) + 9;
    grid = {IVec3(n, n, (n * 3) / 4), voxel_mm,
            Vec3(-0.5 * (n - 1) * voxel_mm, -0.5 * (n - 1) * voxel_mm, -0.55 * (n - 1) * voxel_mm)};
  } else {
    low = Vec3(1e300);
    high = Vec3(-1e300);
    const double reach = head_reach(cutter.bur) + kRoundMm, across = cutter.bur.radius_mm + kRoundMm;
    for (const Vec3& p : places_of(cutter, path, points_of(path, cutter, {.speed_mm_s = 50.0}))) {
      // A leaning head reaches aside by its length.
      const Vec3 about(path == Path::tilted ? Vec3(reach) : Vec3(across));
      low = glm::min(low, f.to_local(p) - about);
      high = glm::max(high, f.to_local(p) + about);
    }
    low.z = -depths_of(cutter, path).sunk - kRoundMm;
    high.z = 0.0;
    Vec3 first(1e300), last(-1e300);
    for (int i = 0; i < 8; ++i) {
      const Vec3 corner = f.to_world({i & 1 ? low.x : high.x, i & 2 ? low.y : high.y, i & 4 ? low.z : high.z});
      first = glm::min(first, corner);
      last = glm::max(last, corner);
    }
    const double room = (kBandVoxels + Specimen::kRoomVoxels) * voxel_mm;
    grid = {IVec3(glm::ceil((last - first + 2.0 * room) / voxel_mm)) + 1, voxel_mm, first - room};
  }
  const Vec3 middle = 0.5 * (low + high), half = 0.5 * (high - low);
  const auto distance = [&](Vec3 at) {
    const Vec3 beyond = glm::abs(f.to_local(at) - middle) - half;
    return length(glm::max(beyond, Vec3(0.0))) + std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0);
  };
  auto scene = std::make_shared<Scene>();
  scene->method = method;
  scene->specimen = carved::specimen(grid, reading_of(method), distance, [](Vec3) { return Tissue::dentine; });
  scene->burs = {cutter.bur};
  scene->tool_axis = path_axis(path);
  for (TissueFeel& feel : scene->tissues) feel = {1.0, 1e5};
  scene->full_force_n = 1e-9;
  scene->guard = unguarded();
  return scene;
}

RemainingSurface lead_along(const Cutter& cutter, double voxel_mm, Path path, const std::vector<Vec3>& points, double tick_ms,
                     int halves) {
  StepState state(soft_scene(cutter, Method::surface, voxel_mm, path));
  const auto tick_us = static_cast<std::uint32_t>(tick_ms * 1000.0 + 0.5);
  const std::size_t part = (points.size() + static_cast<std::size_t>(halves) - 1) / static_cast<std::size_t>(halves);
  const Frame f = path_frame();
  Button button = Button::up;
  for (const Vec3& p : entry_points(cutter, path, points.front())) {
    step(state, input_at(p, button));
    button = Button::down;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    // The button is up for a tick at the end of a half.
    if (i > 0 && i % part == 0) step(state, input_at(points[i - 1], Button::up));
    StepInput input = input_at(points[i], Button::down);
    input.elapsed_us = tick_us;
    step(state, input);
  }
  step(state, input_at(points.back(), Button::up));

  RemainingSurface out;
  const Volume& volume = state.volume();
  out.removed_mm3 = removed_solid(volume).total_mm3();
  const SweptBur swept(cutter.bur, state.scene().tool_axis, places_of(cutter, path, points));
  double sum = 0.0;
  for (const std::int32_t brick : volume.cut_bricks()) {
    const IVec3 corner = volume.specimen().brick_at(brick) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; ++o) {
      SurfacePoint p;
      if (!surface_point(volume, corner + IVec3(o & 7, o >> 3 & 7, o >> 6), p) || !p.cut) continue;
      if (f.to_local(p.point_mm).z > -kEdgeVoxels * voxel_mm) continue;
      Vec3 normal(0.0);
      const double d = swept.distance_mm(p.point_mm, normal);
      if (!cutter.bur.head.ball()) {
        bool edge = false;
        for (int k = 0; k < 6 && !edge; ++k) {
          Vec3 beside = p.point_mm, other(0.0);
          beside[k % 3] += (k < 3 ? 1.5 : -1.5) * voxel_mm;
          // Only on the tissue side: inside the hole a wall cut by a rim has no normal.
          edge = swept.distance_mm(beside, other) > -kOnSkinVoxels * voxel_mm && glm::dot(normal, other) < kSurfaceEdgeCosine;
        }
        if (edge) {
          ++out.edges;
          continue;
        }
      }
      sum += std::fabs(d) * 1e3;
      if (std::fabs(d) * 1e3 > out.most_um) {
        out.most_um = std::fabs(d) * 1e3;
        out.worst_mm = f.to_local(p.point_mm);
      }
      ++out.points;
    }
  }
  if (out.points > 0) out.mean_um = sum / static_cast<double>(out.points);
  return out;
}

double exact_removed_mm3(const Cutter& cutter, Path path, const std::vector<Vec3>& points) {
  if (upright(path))
    return upright_mm3(cutter.bur, depths_of(cutter, path).sunk, length_of(path));
  return SweptBur(cutter.bur, path_axis(path), places_of(cutter, path, points)).volume_mm3(path_frame());
}

}  // namespace cusp::bench
