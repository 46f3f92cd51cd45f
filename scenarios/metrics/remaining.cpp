#include "scenarios/metrics/remaining.h"

#include <algorithm>
#include <cmath>
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

}  // namespace

std::optional<RidgeThickness> ridge_thickness(const CutFaces& faces, const Reference& reference, const Volume& volume,
                                              FaceName wall) {
  if (reference.mesial_x() == 0 || faces.of(wall).empty()) return std::nullopt;
  const int direction = wall == FaceName::mesial_wall ? reference.mesial_x() : -reference.mesial_x();
  if (opened_by_target(reference, direction)) return std::nullopt;
  // The wall's outermost place in each strip of half a voxel: no other of that strip can be nearer to the contour.
  std::map<int, Vec3> outermost;
  const double strip = 0.5 * volume.grid().voxel_mm;
  double low = faces.of(wall).front().middle_mm.z;
  for (const CutFace& face : faces.of(wall)) {
    if (!is_of_cavity(volume, face.middle_mm, direction)) continue;
    const int key = static_cast<int>(std::floor(face.middle_mm.y / strip));
    const auto [it, first] = outermost.try_emplace(key, face.middle_mm);
    if (!first && direction * (face.middle_mm.x - it->second.x) > 0.0) it->second = face.middle_mm;
    low = std::min(low, face.middle_mm.z);
  }
  ProximalContour contour(volume, direction);
  std::optional<RidgeThickness> best;
  for (const auto& [key, at] : outermost) {
    const Contour edge = contour.at(at.y, low);
    if (!edge.found) continue;
    const double mm = direction * (edge.x - at.x);
    if (best && mm >= best->mm) continue;
    const double sigma = edge.sharp ? std::sqrt(2.0) * reference.point_sigma_mm()
                                    : reference.point_sigma_mm() + 0.5 * volume.grid().voxel_mm;
    best = RidgeThickness{mm, sigma, at, edge.at_mm};
  }
  return best;
}

}  // namespace cusp::scenarios
