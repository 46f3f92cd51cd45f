/// Surface points of a banded specimen, found once at load and shared. Each crossed cell has a point, or an edge if the
/// cell is creased outwards; edges end at the outer corners where three meet. By brick, in arrays for eight lanes. Immutable; any thread.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/base/vec.h"
#include "engine/volume/tissue.h"

namespace cusp::engine {

class Specimen;

/// An edge's piece ends this far from its middle, voxels.
inline constexpr double kHalfEdge = 0.7;

/// Unit normal out of the tissue, or an edge's tangent, in 1/32767: 0.002 degrees, which contact polishes on the field.
/// And the cell.
struct BaseNormal {
  static constexpr std::uint16_t kEdge = 0x8000, kBesideEdge = 0x4000;
  std::int16_t x = 0, y = 0, z = 0;
  std::uint16_t place = 0;  // brick_offset of the cell's lower corner; kEdge, kBesideEdge

  int cell() const noexcept { return place & 511; }
  bool edge() const noexcept { return (place & kEdge) != 0; }
  bool beside_edge() const noexcept { return (place & kBesideEdge) != 0; }
  /// To single precision. On a diagonal the integers alone are longer by 1e-5: 5 nm where the device is 0.25 mm behind
  /// the plane.
  Vec3f unit() const noexcept {
    const Vec3f v(x, y, z);
    return v * (1.0f / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
  }
};

/// The points of one brick, in cell order. Place i is (x[i], y[i], z[i]) in voxels from the brick's first voxel centre,
/// rounded to 5e-7 voxel. x, y and z have seven unused values behind `count`, so that eight lanes need no tail.
struct BasePoints {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  const BaseNormal* normal = nullptr;
  const Tissue* tissue = nullptr;
  int count = 0;
  std::uint32_t first = 0;  // of the whole surface's, for edge_details()
};

class BaseSurface {
 public:
  static BaseSurface of(const Specimen& specimen);
  /// Points of the cells whose lower corner lies in this brick.
  BasePoints in(int brick) const noexcept {
    const std::size_t first = first_[static_cast<std::size_t>(brick)];
    return {x_.data() + first, y_.data() + first, z_.data() + first, normal_.data() + first, tissue_.data() + first,
            static_cast<int>(first_[static_cast<std::size_t>(brick) + 1] - first), first_[static_cast<std::size_t>(brick)]};
  }
  /// Further figures of a point at or beside an edge.
  struct EdgeDetail {
    std::uint32_t index = 0;
    float other_d = 0.0f;     // beside: of the point to the other face, negative inside; voxels
    Vec3f vector{0.0f};       // edge: bend in x(t) = place + tangent t + bend t^2, voxels; beside: the other face's normal
  };
  /// second: at an outer corner a point lies beside two faces; else nullptr.
  struct EdgeDetails {
    const EdgeDetail* first;
    const EdgeDetail* second;
  };
  /// Pre: edge() or beside_edge() of point i.
  EdgeDetails edge_details(const BasePoints& points, int i) const noexcept;
  std::size_t size() const noexcept { return tissue_.size(); }
  std::size_t bytes() const noexcept {
    return x_.size() * (3 * sizeof(float) + sizeof(BaseNormal)) + tissue_.size() +
           first_.size() * sizeof(std::uint32_t) + edge_details_.size() * sizeof(EdgeDetail);
  }

 private:
  std::vector<float> x_, y_, z_;
  std::vector<BaseNormal> normal_;
  std::vector<Tissue> tissue_;
  std::vector<std::uint32_t> first_;  // [brick + 1]
  std::vector<EdgeDetail> edge_details_;  // by rising index
};

}  // namespace cusp::engine
