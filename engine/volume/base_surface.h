/// The surface points of a banded specimen, found once when it is loaded and shared: one for each crossed cell, by
/// brick. Immutable; any thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "engine/volume/tissue.h"

namespace cusp {

class Specimen;

struct BasePoint {
  Vec3f offset{0.0f};       // from the cell's lower corner, in voxels; rounding 4e-8 voxel
  Vec3f normal{0.0f};       // unit, out of the tissue
  std::uint16_t cell = 0;   // brick_offset of the cell's lower corner
  Tissue tissue = Tissue::empty;
};

class BaseSurface {
 public:
  static BaseSurface of(const Specimen& specimen);
  /// Points of the cells whose lower corner lies in this brick, in cell order.
  std::span<const BasePoint> in(int brick) const noexcept {
    const auto b = static_cast<std::size_t>(brick);
    return {points_.data() + first_[b], first_[b + 1] - first_[b]};
  }
  std::size_t size() const noexcept { return points_.size(); }
  std::size_t bytes() const noexcept {
    return points_.size() * sizeof(BasePoint) + first_.size() * sizeof(std::uint32_t);
  }

 private:
  std::vector<BasePoint> points_;
  std::vector<std::uint32_t> first_;  // [brick + 1]
};

}  // namespace cusp
