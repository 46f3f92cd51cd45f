/// The surface points of a banded specimen, found once when it is loaded and shared: one for each crossed cell, by
/// brick, laid out for eight at a time. Immutable; any thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/vec.h"
#include "engine/volume/tissue.h"

namespace cusp {

class Specimen;

/// Unit normal out of the tissue in 1/32767 (0.002 degrees; contact polishes it on the field), and the cell.
struct BaseNormal {
  std::int16_t x = 0, y = 0, z = 0;
  std::uint16_t cell = 0;  // brick_offset of the cell's lower corner

  Vec3f unit() const noexcept { return Vec3f(x, y, z) * (1.0f / 32767.0f); }
};

/// The points of one brick, in cell order: place i is (x[i], y[i], z[i]) in voxels from the brick's first voxel centre,
/// rounded to 5e-7 voxel. Seven more of each array may be read (and mean nothing), so that eight lanes need no tail.
struct BasePoints {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  const BaseNormal* normal = nullptr;
  const Tissue* tissue = nullptr;
  int count = 0;
};

class BaseSurface {
 public:
  static BaseSurface of(const Specimen& specimen);
  /// Points of the cells whose lower corner lies in this brick.
  BasePoints in(int brick) const noexcept {
    const std::size_t first = first_[static_cast<std::size_t>(brick)];
    return {x_.data() + first, y_.data() + first, z_.data() + first, normal_.data() + first, tissue_.data() + first,
            static_cast<int>(first_[static_cast<std::size_t>(brick) + 1] - first)};
  }
  std::size_t size() const noexcept { return tissue_.size(); }
  std::size_t bytes() const noexcept {
    return x_.size() * (3 * sizeof(float) + sizeof(BaseNormal)) + tissue_.size() + first_.size() * sizeof(std::uint32_t);
  }

 private:
  std::vector<float> x_, y_, z_;
  std::vector<BaseNormal> normal_;
  std::vector<Tissue> tissue_;
  std::vector<std::uint32_t> first_;  // [brick + 1]
};

}  // namespace cusp
