#include "engine/removal/carve.h"

#include <algorithm>
#include <cmath>

namespace cusp::engine {

namespace {

constexpr double kHalfDiagonal = 6.07;  // voxels from a brick's middle to its corner voxel: 3.5 sqrt(3), rounded up

/// A ball's sweep, in voxels.
class BallSweep {
 public:
  BallSweep(const Grid& grid, Vec3 a_mm, Vec3 b_mm, double radius_mm) noexcept
      : a_((a_mm - grid.origin_mm) / grid.voxel_mm), radius_(radius_mm / grid.voxel_mm), far_(radius_ + kBandVoxels) {
    const Vec3 b = (b_mm - grid.origin_mm) / grid.voxel_mm;
    low = glm::max(IVec3(glm::floor(glm::min(a_, b) - far_)), IVec3(0));
    high = glm::min(IVec3(glm::ceil(glm::max(a_, b) + far_)), grid.size - 1);
    along_ = b - a_;
    const double square = glm::dot(along_, along_);
    inverse_ = square > 1e-24 ? 1.0 / square : 0.0;
    const double near = radius_ > kBandVoxels ? radius_ - kBandVoxels : 0.0;
    near2_ = near * near;
  }

  bool reaches_brick(IVec3 corner) const noexcept {
    const double reach = far_ + kHalfDiagonal;
    return distance2(Vec3(corner) + 3.5) <= reach * reach;
  }
  /// Solid fraction that the sweep leaves of a voxel.
  std::uint16_t solid(IVec3 voxel) const noexcept {
    const double d2 = distance2(Vec3(voxel));
    if (d2 >= far_ * far_) return kSolid;
    return d2 <= near2_ ? std::uint16_t{0} : solid_from_distance(radius_ - std::sqrt(d2));
  }

  IVec3 low{0}, high{0};  // voxels within the band, inclusive

 private:
  double distance2(Vec3 place) const noexcept {
    const Vec3 v = place - a_;
    double t = glm::dot(v, along_) * inverse_;
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    const Vec3 d = v - along_ * t;
    return glm::dot(d, d);
  }

  Vec3 a_, along_{0.0};
  double radius_, far_, near2_ = 0.0, inverse_ = 0.0;
};

/// What carving has done to a brick.
struct CarvedBrick {
  bool changed = false, overflow = false;
  Carved::Box box;
};

CarvedBrick carve_brick(Volume& volume, const BallSweep& sweep, int brick, IVec3 corner) noexcept {
  CarvedBrick out;
  const IVec3 from = glm::max(sweep.low - corner, IVec3(0));
  const IVec3 to = glm::min(sweep.high - corner, IVec3(7));
  std::uint16_t* values = nullptr;
  for (int z = from.z; z <= to.z; ++z)
    for (int y = from.y; y <= to.y; ++y)
      for (int x = from.x; x <= to.x; ++x) {
        const IVec3 at = corner + IVec3(x, y, z);
        const std::uint16_t s = sweep.solid(at);
        if (s == kSolid) continue;
        if (values == nullptr) values = volume.cut_for_writing(brick);
        if (values == nullptr) {
          out.overflow = true;
          return out;
        }
        std::uint16_t& value = values[brick_offset(x, y, z)];
        if (s >= value) continue;
        value = s;
        out.box.low = out.changed ? glm::min(out.box.low, at) : at;
        out.box.high = out.changed ? glm::max(out.box.high, at) : at;
        out.changed = true;
      }
  return out;
}

}  // namespace

Carved carve_sweep(Volume& volume, Vec3 a, Vec3 b, double radius_mm, CarvePart part) noexcept {
  Carved out;
  const BallSweep sweep(volume.grid(), a, b, radius_mm);
  int walked = 0;
  for (int z = sweep.low.z >> 3; z <= sweep.high.z >> 3; ++z)
    for (int y = sweep.low.y >> 3; y <= sweep.high.y >> 3; ++y)
      for (int x = sweep.low.x >> 3; x <= sweep.high.x >> 3; ++x) {
        if (walked++ < part.first) continue;
        if (out.bricks == part.most) {
          out.next = walked - 1;
          return out;
        }
        const int brick = volume.specimen().brick_index({x, y, z});
        const IVec3 corner = IVec3(x, y, z) * kBrickEdge;
        if (brick < 0 || !volume.cuttable(brick) || !sweep.reaches_brick(corner)) continue;
        const CarvedBrick carved = carve_brick(volume, sweep, brick, corner);
        out.overflow = out.overflow || carved.overflow;
        if (!carved.changed) continue;
        volume.touched(brick);
        out.low = out.any ? glm::min(out.low, carved.box.low) : carved.box.low;
        out.high = out.any ? glm::max(out.high, carved.box.high) : carved.box.high;
        out.any = true;
        if (out.bricks < Carved::kBoxes) out.box[out.bricks] = carved.box;
        ++out.bricks;
      }
  return out;
}

}  // namespace cusp::engine
