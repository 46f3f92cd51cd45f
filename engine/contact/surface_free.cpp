// Free space: how far the bur may go without a search, found from the surface's nearest point.
#include <algorithm>
#include <cmath>

#include "engine/contact/surface_near.h"

namespace cusp::engine {

namespace {

constexpr double kFreeMargin = 0.5;   // mm: largest margin of a free space
constexpr double kCloseMm = 0.2;      // mm: the nearest point is searched within this first
constexpr double kLeastFree = 0.02;   // mm: less is not worth keeping
constexpr int kCellsATick = 400;      // computed for it: some 0.1 ms
constexpr int kPause = 16;            // solves without a search after too little was found

/// The lowest place of head, neck and shank along a direction that the axis leans to by the cosine `up`, from the pose.
double lowest_of(const Bur& bur, double up) noexcept {
  const double across2 = 1.0 - up * up;
  const double across = across2 > 0.0 ? std::sqrt(across2) : 0.0;
  const double neck = -across * bur.neck_radius_mm - up * bur.neck_radius_mm;
  const double shank = up * bur.neck_length_mm - across * bur.shank_radius_mm;
  double head = -bur.radius_mm;
  if (!bur.head.ball()) {
    const OnHalf deepest = bur.head.support({-up, across}, {});
    head = up * deepest.t - across * deepest.rho;
  }
  return std::min(head, std::min(neck, shank));
}

}  // namespace

void SurfaceContact::find_free(const Volume& volume, const Tool& tool, Vec3 pose) noexcept {
  free_.valid = false;
  // Changed cells near the bur are computed some a tick; until all are, searches answer.
  int budget = kCellsATick;
  free_bricks(volume, tool, pose, [&](int brick, IVec3, auto&& cells) {
    if (budget >= 0 && volume.has_cut(brick)) budget = cut_.prepare(volume, brick, cells(CellsNear::kAllSlices), budget);
  });
  if (budget < 0) return;
  // The plane of the nearest point, moved up to the highest point of every brick in reach of head, neck and shank, and
  // half a voxel more for what stands between points.
  Vec3 n = tool.axis;
  if (tool.ball())
    nearest_to_ball(volume, tool, pose, n);
  else
    nearest_to_head(volume, tool, pose, n);
  if (!raise_free(volume, tool, pose, n)) free_pause_ = kPause;
}

/// Cells of a brick within the margin of a ball.
CellsNear SurfaceContact::cells_free(const Tool& tool, Vec3 pose, Vec3 corner_mm, unsigned slices) const noexcept {
  const double per_mm = 1.0 / voxel_mm_;
  return CellsNear::ball(Vec3f((pose - corner_mm) * per_mm), static_cast<float>((tool.bur->radius_mm + kFreeMargin) * per_mm + kFloatSlack), slices);
}

/// Calls visit(brick, at, cells) for the bricks with points that may lie within kFreeMargin of the head, then of neck and shank.
/// cells(slices): those of the brick that may hold one.
template <class Visit>
void SurfaceContact::free_bricks(const Volume& volume, const Tool& tool, Vec3 pose, Visit&& visit) const noexcept {
  const auto in_cylinders = [&](int brick, IVec3 at, const TwoCylinders& shape) {
    visit(brick, at, [&](unsigned slices) { return CellsNear::cylinders(shape, slices); });
  };
  if (tool.ball())
    ball_bricks(volume, pose, tool.bur->radius_mm + kFreeMargin, [&](int brick, IVec3 at, double) {
      visit(brick, at, [&](unsigned slices) { return cells_free(tool, pose, brick_corner(volume.grid(), at), slices); });
    });
  else
    bricks_within(volume, tool.axis, pose, head_within(tool, kFreeMargin), in_cylinders);
  bricks_within(volume, tool.axis, pose, shank_within(tool, kFreeMargin), in_cylinders);
}

/// Normal of the surface's point that is nearest to a head that is no ball; n as it was where none is near.
void SurfaceContact::nearest_to_head(const Volume& volume, const Tool& tool, Vec3 pose, Vec3& n) noexcept {
  double nearest = 1e300;
  for (const double margin : {kCloseMm, kFreeMargin}) {
    bricks_within(volume, tool.axis, pose, head_within(tool, margin), [&](int brick, IVec3 at, const TwoCylinders& shape) {
      const Vec3 corner_mm = brick_corner(volume.grid(), at);
      const CylinderLanes inside(shape);
      features(volume, brick, [&](unsigned slices) { return CellsNear::cylinders(shape, slices); },
               [&](const float* x, const float* y, const float* z, int count, auto&& feature) {
                 for_inside(x, y, z, count, inside, [&](int i) {
                   Vec3 gradient;
                   const double gap = head_distance(*tool.bur, tool.axis, corner_mm + voxel_mm_ * Vec3(x[i], y[i], z[i]) - pose, gradient);
                   if (gap >= nearest) return;
                   nearest = gap;
                   const CutFeature& f = feature(i);
                   n = f.edge ? -gradient : Vec3(f.normal);
                 });
               });
    });
    if (nearest < 1e200) return;
  }
}

/// The same of a ball.
void SurfaceContact::nearest_to_ball(const Volume& volume, const Tool& tool, Vec3 pose, Vec3& n) noexcept {
  const double r = tool.bur->radius_mm;
  double nearest2 = 1e300;
  Vec3 nearest(0.0);
  for (const double reach : {r + kCloseMm, r + kFreeMargin}) {
    const double per_mm = 1.0 / voxel_mm_;
    ball_bricks(volume, pose, reach, [&](int brick, IVec3 at, double square) {
      if (square > nearest2) return;
      const Vec3 corner_mm = brick_corner(volume.grid(), at);
      features(volume, brick, [&](unsigned slices) { return cells_free(tool, pose, corner_mm, slices); },
               [&](const float* x, const float* y, const float* z, int count, auto&& feature) {
                 const double wide = (nearest2 < 1e200 ? std::sqrt(nearest2) : reach) * per_mm + kFloatSlack;
                 int best = -1;
                 for_near(x, y, z, count, Vec3f((pose - corner_mm) * per_mm), static_cast<float>(wide * wide), [&](int i) {
                   const Vec3 d = pose - (corner_mm + voxel_mm_ * Vec3(x[i], y[i], z[i]));
                   const double d2 = glm::dot(d, d);
                   if (d2 >= nearest2) return;
                   nearest2 = d2;
                   nearest = d;
                   best = i;
                 });
                 if (best < 0) return;
                 const CutFeature& f = feature(best);
                 nearest = f.edge ? nearest / std::sqrt(nearest2) : Vec3(f.normal);
               });
    });
    if (nearest2 < 1e200) break;
  }
  if (nearest2 < 1e200) n = nearest;
}

/// Free space beyond a plane with normal n, if there is enough.
bool SurfaceContact::raise_free(const Volume& volume, const Tool& tool, Vec3 pose, Vec3 n) noexcept {
  const Bur& bur = *tool.bur;
  FreeSpace found{pose, n, std::max(0.0, kFreeMargin - voxel_mm_), 0.0, tool.index, true, false, tool.axis};
  double highest = -1e300;
  const Vec3f slim_n(n);
  free_bricks(volume, tool, pose, [&](int brick, IVec3 at, auto&& cells) {
    const Vec3 corner_mm = brick_corner(volume.grid(), at);
    // Its highest corner along n is not above what there is.
    if (found.bounded && !volume.has_cut(brick)) {
      const PointsBox& box = boxes_[static_cast<std::size_t>(brick)];
      const Vec3 low = box.low(), high = box.high();
      const double top = glm::dot(n, corner_mm) +
                         voxel_mm_ * ((n.x > 0.0 ? high.x : low.x) * n.x + (n.y > 0.0 ? high.y : low.y) * n.y +
                                      (n.z > 0.0 ? high.z : low.z) * n.z);
      if (top <= highest) return;
    }
    features(volume, brick, cells, [&](const float* x, const float* y, const float* z, int count, auto&&) {
      if (count == 0) return;
      found.bounded = true;
      const double height = glm::dot(n, corner_mm) + voxel_mm_ * highest_along(x, y, z, count, slim_n);
      highest = height > highest ? height : highest;
    });
  });
  if (found.bounded) {
    const double up = glm::dot(n, tool.axis);
    if (up < 0.0) return false;
    found.c = highest + 0.5 * voxel_mm_ + 0.01 - lowest_of(bur, up);
    if (glm::dot(n, pose) - found.c < kLeastFree) return false;
  }
  free_ = found;
  return true;
}

bool SurfaceContact::inside_tissue(const Volume& volume, Vec3 pose) const noexcept {
  return volume.s(cell_of_voxels((pose - volume.grid().origin_mm) / voxel_mm_ + 0.5)) >= kHalf;
}

bool SurfaceContact::in_free_space(const Volume& volume, const Bur& bur, Vec3 axis, Vec3 pose) const noexcept {
  const Specimen& specimen = volume.specimen();
  const Grid& grid = volume.grid();
  const auto empty = [&](Vec3 a, Vec3 b) {
    const IVec3 low = glm::max(brick_floor(grid, a), IVec3(0));
    const IVec3 high = glm::min(brick_floor(grid, b), specimen.brick_count() - 1);
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) {
          const int brick = specimen.brick_index({x, y, z});
          if (specimen.s_of(brick) != nullptr || specimen.s_in(brick, 0) != 0) return false;
        }
    return true;
  };
  const double wide = head_reach(bur) + 2.0 * grid.voxel_mm;
  if (!empty(pose - wide, pose + wide)) return false;
  const Vec3 end = pose + axis * (bur.neck_length_mm + bur.shank_length_mm);
  const double thick = std::max(bur.neck_radius_mm, bur.shank_radius_mm) + 2.0 * grid.voxel_mm;
  return empty(glm::min(pose, end) - thick, glm::max(pose, end) + thick);
}

}  // namespace cusp::engine
