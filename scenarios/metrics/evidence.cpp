#include "scenarios/metrics/evidence.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/volume/cell_field.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

namespace {

IVec3 voxel_at(const Grid& grid, Vec3 p) noexcept {
  return IVec3(glm::floor((p - grid.origin_mm) / grid.voxel_mm + 0.5));
}

bool was_there(const Specimen& specimen, IVec3 v) noexcept {
  return specimen.reading() == Reading::filled ? specimen.s(v) > 0 : specimen.s(v) >= kHalf;
}

}  // namespace

bool FaceJudge::solid_at(Vec3 p) const noexcept { return volume_.occupied(voxel_at(volume_.grid(), p)); }

bool FaceJudge::inside_original(Vec3 p) const noexcept {
  const Grid& grid = volume_.grid();
  for (int axis = 0; axis < 3; ++axis)
    for (const double step : {-grid.voxel_mm, grid.voxel_mm}) {
      Vec3 beside = p;
      beside[axis] += step;
      if (!was_there(volume_.specimen(), voxel_at(grid, beside))) return false;
    }
  return true;
}

bool FaceJudge::open_above(Vec3 p) const noexcept {
  const Grid& grid = volume_.grid();
  IVec3 v = voxel_at(grid, p);
  for (; v.z < grid.size.z; ++v.z)
    if (volume_.occupied(v)) return false;
  return true;
}

void FaceJudge::offer(const std::array<Vec3, 3>& corners, FaceKind kind, double mm, Evidence& best) const noexcept {
  const Vec3 cross = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = glm::length(cross);
  if (!(length > 0.0)) return;
  Vec3 normal = cross / length;
  const bool level = std::fabs(normal.z) >= kFloorCosine;
  bool fits = kind == FaceKind::any || level == (kind == FaceKind::floor);
  const auto hopeless = [&] {
    const int most = fits ? kBestRank : kBestRank - 4;
    return most < best.rank || (most == best.rank && mm <= best.mm);
  };
  if (hopeless()) return;
  const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  const double voxel = volume_.grid().voxel_mm;
  if (solid_at(middle + voxel * normal)) normal = -normal;  // into the removed part
  if (kind == FaceKind::floor && normal.z < 0.0) fits = false;  // a ceiling
  if (hopeless()) return;
  const int rank = (fits ? 4 : 0) + (inside_original(middle) ? 2 : 0) + (open_above(middle + voxel * normal) ? 1 : 0);
  const Evidence found{rank, mm, middle};
  if (found.better_than(best)) best = found;
}

std::optional<Vec3> standing_place(const Reference& reference, const Volume& volume) {
  const TargetShape& shape = reference.shape();
  const Grid& grid = volume.grid();
  const IVec3 low = glm::max(voxel_at(grid, {shape.low().x, shape.low().y, shape.floor_mm()}), IVec3(0));
  const IVec3 high = glm::min(voxel_at(grid, {shape.high().x, shape.high().y, 0.0}), grid.size - 1);
  double deepest = 0.0;
  std::optional<IVec3> found;
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x) {
      const Vec3 foot = grid.centre_mm({x, y, low.z});
      const OutlineShape* upright = shape.upright();
      const double u = upright != nullptr ? upright->outline_mm({foot.x, foot.y}) : 0.0;
      if (upright != nullptr && u >= deepest) continue;
      for (int z = low.z; z < grid.size.z; ++z) {
        if (!volume.occupied({x, y, z})) continue;
        const Vec3 centre = grid.centre_mm({x, y, z});
        const double d = upright != nullptr ? rounded_corner(u, upright->below_floor_mm(centre.z), upright->corner_mm())
                                            : shape.distance_mm(centre);
        if (d >= deepest) continue;
        deepest = d;
        found = IVec3(x, y, z);
      }
    }
  if (!found) return std::nullopt;
  IVec3 top = *found;
  while (volume.occupied({top.x, top.y, top.z + 1})) ++top.z;
  if (volume.specimen().reading() == Reading::filled) return grid.centre_mm(top) + Vec3(0, 0, 0.5 * grid.voxel_mm);
  // Between the last voxel's centre inside and the first outside the distance runs as good as straight.
  const double inside = distance_from_solid(volume.s(top)), outside = distance_from_solid(volume.s(top + IVec3(0, 0, 1)));
  const double share = outside > inside ? std::clamp(-inside / (outside - inside), 0.0, 1.0) : 0.5;
  return grid.centre_mm(top) + Vec3(0, 0, share * grid.voxel_mm);
}

std::optional<Vec3> exposed_pulp(const Reference& reference, const Volume& volume) {
  const Specimen& specimen = volume.specimen();
  const Grid& grid = volume.grid();
  const auto gone = [&](IVec3 v) { return was_there(specimen, v) && !volume.occupied(v); };
  std::vector<Vec3> faces;       // between a remaining pulp voxel and a removed place
  std::optional<Vec3> all_gone;  // a removed pulp voxel
  Vec3 sum(0.0);
  for (const IVec3 v : reference.pulp().voxels()) {
    if (gone(v)) {
      all_gone = grid.centre_mm(v);
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
      for (int step = -1; step <= 1; step += 2) {
        IVec3 next = v;
        next[axis] += step;
        if (!gone(next)) continue;
        faces.push_back(0.5 * (grid.centre_mm(v) + grid.centre_mm(next)));
        sum += faces.back();
      }
  }
  if (faces.empty()) return all_gone;
  const Vec3 middle = sum / static_cast<double>(faces.size());
  return *std::ranges::min_element(
      faces, [&](Vec3 a, Vec3 b) { return glm::dot(a - middle, a - middle) < glm::dot(b - middle, b - middle); });
}

}  // namespace cusp::scenarios
