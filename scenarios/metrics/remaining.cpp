#include "scenarios/metrics/remaining.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "scenarios/metrics/surface_search.h"
#include "scenarios/teeth/own_tissues.h"

namespace cusp::scenarios {

namespace {

struct Contour {
  double x = 0;
  Vec3 at_mm{0.0};
  bool sharp = true;  // the surface borders on air
  bool found = false;
};

/// The tooth's voxel furthest along x in a row.
std::optional<IVec3> outermost_own(const Specimen& specimen, int y, int z, int direction) noexcept {
  const int size = specimen.grid().size.x;
  IVec3 v(direction > 0 ? size - 1 : 0, y, z);
  for (; v.x >= 0 && v.x < size; v.x -= direction)
    if (specimen.s(v) >= kHalf && is_own_hard(specimen.tissue(v))) return v;
  return std::nullopt;
}

/// Furthest place of the tooth along x at one buccolingual place, over all heights of the crown's voxels from `from_mm` up.
class ProximalContour {
 public:
  ProximalContour(const Volume& volume, int direction)
      : volume_(volume), search_(volume, Solid::original), direction_(direction) {}

  Contour at(double y_mm, double from_mm) {
    const Grid& grid = volume_.grid();
    Contour best;
    IVec3 v = nearest_voxel(grid, {grid.origin_mm.x, y_mm, from_mm});
    for (v.z = std::max(v.z, 0); v.z < grid.size.z; ++v.z) offer(v, y_mm, best);
    return best;
  }

 private:
  void offer(IVec3 v, double y_mm, Contour& best) {
    const std::optional<IVec3> outermost = outermost_own(volume_.specimen(), v.y, v.z, direction_);
    if (!outermost) return;
    const Grid& grid = volume_.grid();
    const bool sharp = volume_.specimen().s(*outermost + IVec3(direction_, 0, 0)) < kHalf;
    Vec3 p = grid.centre_mm(*outermost);
    p.y = y_mm;
    const Vec3 out(direction_ * grid.voxel_mm, 0, 0);
    p = sharp ? search_.between(p + out, p - out) : p + 0.5 * out;
    if (!best.found || direction_ * (p.x - best.x) > 0.0) best = {p.x, p, sharp, true};
  }

  const Volume& volume_;
  SurfaceSearch search_;
  int direction_;
};

bool opened_by_target(const Reference& reference, int direction) {
  const Specimen& specimen = reference.specimen();
  const TargetShape& shape = reference.shape();
  const Grid& grid = specimen.grid();
  const IVec3 last = grid.size - 1;
  const IVec3 low = glm::clamp(nearest_voxel(grid, {0, shape.low().y, shape.floor_mm()}), IVec3(0), last);
  const IVec3 high = glm::clamp(nearest_voxel(grid, {0, shape.high().y, 0}), IVec3(0), last);
  double greatest = 0;
  std::vector<double> held;  // mesially or distally, of what the target holds
  bool any = false;
  for (int z = low.z; z <= last.z; ++z)
    for (int y = low.y; y <= high.y; ++y) {
      const std::optional<IVec3> v = outermost_own(specimen, y, z, direction);
      if (!v) continue;
      const Vec3 at = grid.centre_mm(*v);
      greatest = any ? std::max(greatest, direction * at.x) : direction * at.x;
      any = true;
      if (shape.distance_mm(at) < 0.0) held.push_back(direction * at.x);
    }
  return std::ranges::any_of(held, [greatest](double mm) { return mm > greatest - kRidgeMm; });
}

/// Whether the cut that left this place of a wall is higher than a scratch: removed tissue stands above or below it.
bool is_of_cavity(const Volume& volume, Vec3 wall_at, int direction) noexcept {
  const auto removed = [&](double up_mm) {
    const IVec3 v = nearest_voxel(volume.grid(), wall_at + Vec3(-direction * kLeastWallMm, 0.0, up_mm));
    return volume.specimen().s(v) >= kHalf && !volume.occupied(v);
  };
  return removed(kLeastWallMm) || removed(-kLeastWallMm);
}

/// A place of the wall towards the ridge.
struct Wall {
  Vec3 at_mm{0.0};
  bool through = false;  // the cut runs out of the tooth there
};

/// The last removed voxel of a row towards the ridge, if removed tissue joins it to the target over more than kWallReachMm.
/// `v`: the row's outermost voxel of the tooth.
std::optional<IVec3> far_end(const Reference& reference, const Volume& volume, IVec3 v, int direction) {
  const Grid& grid = volume.grid();
  std::optional<IVec3> end;
  int length = 0;
  for (; v.x >= 0 && v.x < grid.size.x; v.x -= direction) {
    if (volume.specimen().s(v) < kHalf || volume.occupied(v)) {
      end.reset();
      length = 0;
      continue;
    }
    if (!end) end = v;
    if (reference.shape().distance_mm(grid.centre_mm(v)) < 0.0) return (length + 1) * grid.voxel_mm > kWallReachMm ? end : std::nullopt;
    ++length;
  }
  return std::nullopt;
}

/// Of each buccolingual place of the target the wall and the way through that lie furthest out, beyond the reach of the walls' faces.
std::vector<Wall> far_walls(const Reference& reference, const Volume& volume, int direction) {
  const TargetShape& shape = reference.shape();
  const Grid& grid = volume.grid();
  const IVec3 last = grid.size - 1;
  const IVec3 low = glm::clamp(nearest_voxel(grid, {0, shape.low().y, shape.floor_mm()}), IVec3(0), last);
  const IVec3 high = glm::clamp(nearest_voxel(grid, {0, shape.high().y, 0}), IVec3(0), last);
  const Vec3 outwards(direction * grid.voxel_mm, 0, 0);
  SurfaceSearch search(volume, Solid::remaining);
  std::vector<Wall> out;
  for (int y = low.y; y <= high.y; ++y) {
    std::array<std::optional<Wall>, 2> furthest;  // [through]
    for (int z = low.z; z <= last.z; ++z) {
      const std::optional<IVec3> v = outermost_own(volume.specimen(), y, z, direction);
      const std::optional<IVec3> end = v ? far_end(reference, volume, *v, direction) : std::nullopt;
      if (!end) continue;
      const bool through = *end == *v;
      if (!through && !volume.occupied(*end + IVec3(direction, 0, 0))) continue;  // it opens into a fossa
      const Vec3 at = grid.centre_mm(*end);
      const Wall wall{through ? at : search.between(at, at + outwards), through};
      if (!is_of_cavity(volume, wall.at_mm, direction)) continue;
      std::optional<Wall>& so_far = furthest[through ? 1 : 0];
      if (!so_far || direction * (wall.at_mm.x - so_far->at_mm.x) > 0.0) so_far = wall;
    }
    for (const std::optional<Wall>& one : furthest)
      if (one) out.push_back(*one);
  }
  return out;
}

}  // namespace

std::optional<RidgeThickness> ridge_thickness(const CutFaces& faces, const Reference& reference, const Volume& volume,
                                              FaceName wall) {
  if (reference.is_one_with_neighbours()) return std::nullopt;
  if (reference.mesial_x() == 0 || reference.shape().empty() || volume.cut_bricks().empty() || volume.specimen().reading() == Reading::filled)
    return std::nullopt;
  const int direction = wall == FaceName::mesial_wall ? reference.mesial_x() : -reference.mesial_x();
  if (opened_by_target(reference, direction)) return std::nullopt;
  // The wall's outermost place in each strip of half a voxel: no other of that strip can be nearer to the contour.
  std::map<int, Vec3> outermost;
  const double strip = 0.5 * volume.grid().voxel_mm;
  double low = std::numeric_limits<double>::max();
  const auto take = [&](const CutFace& face) {
    if (!is_of_cavity(volume, face.middle_mm, direction)) return false;
    const int key = static_cast<int>(std::floor(face.middle_mm.y / strip));
    const auto [it, first] = outermost.try_emplace(key, face.middle_mm);
    if (!first && direction * (face.middle_mm.x - it->second.x) > 0.0) it->second = face.middle_mm;
    return true;
  };
  for (const CutFace& face : faces.of(wall))
    if (take(face)) low = std::min(low, face.middle_mm.z);
  const std::vector<Wall> far = far_walls(reference, volume, direction);
  for (const Wall& one : far) low = std::min(low, one.at_mm.z);
  if (outermost.empty() && far.empty()) return std::nullopt;
  for (const CutFace& face : faces.foot_of(wall)) take(face);  // of a wall that converges occlusally the outermost
  ProximalContour contour(volume, direction);
  std::optional<RidgeThickness> best;
  const auto offer = [&](const Wall& one) {
    const Contour edge = contour.at(one.at_mm.y, low);
    if (!edge.found) return;
    const double left = direction * (edge.x - one.at_mm.x);
    const double mm = one.through && left <= kRidgeMm ? 0.0 : left;  // further in, a cusp is cut off
    if (best && mm >= best->mm) return;
    const double sigma = edge.sharp ? std::sqrt(2.0) * reference.point_sigma_mm()
                                    : reference.point_sigma_mm() + 0.5 * volume.grid().voxel_mm;
    best = RidgeThickness{mm, sigma, one.at_mm, edge.at_mm};
  };
  for (const auto& [key, at] : outermost) offer({at});
  for (const Wall& one : far) offer(one);
  return best;
}

}  // namespace cusp::scenarios
