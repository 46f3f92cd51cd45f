#include "scenarios/metrics/remaining.h"

#include <algorithm>
#include <cmath>
#include <map>

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
    const Grid& grid = volume_.grid();
    const Specimen& specimen = volume_.specimen();
    const int last = direction_ > 0 ? grid.size.x - 1 : 0;
    for (v.x = last; v.x >= 0 && v.x < grid.size.x; v.x -= direction_) {
      if (specimen.s(v) < kHalf || !is_own_hard(specimen.tissue(v))) continue;
      const IVec3 next = v + IVec3(direction_, 0, 0);
      const bool sharp = specimen.s(next) < kHalf;
      Vec3 p = grid.centre_mm(v);
      p.y = y_mm;
      const Vec3 out(direction_ * grid.voxel_mm, 0, 0);
      p = sharp ? search_.between(p + out, p - out) : p + 0.5 * out;
      if (!best.found || direction_ * (p.x - best.x) > 0.0) best = {p.x, p, sharp, true};
      return;
    }
  }

  const Volume& volume_;
  SurfaceSearch search_;
  int direction_;
};

}  // namespace

std::optional<RidgeThickness> ridge_thickness(const CutFaces& faces, const Reference& reference, const Volume& volume,
                                              FaceName wall) {
  if (reference.mesial_x() == 0 || faces.of(wall).empty()) return std::nullopt;
  const int direction = wall == FaceName::mesial_wall ? reference.mesial_x() : -reference.mesial_x();
  // The wall's outermost place in each strip of half a voxel: no other of that strip can be nearer to the contour.
  std::map<int, Vec3> outermost;
  const double strip = 0.5 * volume.grid().voxel_mm;
  double low = faces.of(wall).front().middle_mm.z;
  for (const CutFace& face : faces.of(wall)) {
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
