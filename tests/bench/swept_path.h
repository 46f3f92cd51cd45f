/// SweptPath: the union of balls of one radius swept along straight sweeps, exactly, with an index by place.
/// Frame: specimen. Unit: mm. Thread: any but the haptic one; it allocates at construction only.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::bench {

/// A ball's centre moved straight from a to b.
struct Sweep {
  Vec3 a{0.0}, b{0.0};
};

/// The sweep's place nearest to p.
Vec3 nearest_on(const Sweep& sweep, Vec3 p);

class SweptPath {
 public:
  /// Pre: one sweep at least, radius_mm > 0.
  SweptPath(std::vector<Sweep> sweeps, double radius_mm);

  double radius_mm() const { return radius_; }
  std::size_t size() const { return sweeps_.size(); }
  const Sweep& sweep(int i) const { return sweeps_[static_cast<std::size_t>(i)]; }

  /// Depth of a place below the surface of one sweep, positive inside. gradient: unit, towards the sweep.
  double depth(int sweep, Vec3 p, Vec3* gradient) const;
  /// The deepest of all, and its sweep. The depth is exact; of equal ones any sweep. guess: a sweep that may be near, -1: none.
  struct Deepest {
    double mm = 0.0;
    int sweep = -1;
  };
  Deepest deepest(Vec3 p, int guess = -1) const;
  /// True if a sweep other than the two holds p deeper than more_mm.
  bool taken(Vec3 p, int but, int but_other, double more_mm) const;

 private:
  /// Node of a binary tree over the sweeps, by the median of the longest side. A leaf holds order_[first..first + count).
  struct Node {
    Vec3 low{1e300}, high{-1e300};
    std::int32_t left = -1, right = -1, first = 0, count = 0;
  };
  /// A sweep in the order of the leaves, for a search without a division.
  struct Leg {
    Vec3 a{0.0}, along{0.0};
    double per_square = 0.0;  // 1 over the square of `along`; 0 for a ball at rest
    double distance2(Vec3 p) const {
      const Vec3 from = p - a;
      const double t = glm::dot(from, along) * per_square;
      const Vec3 off = from - along * (t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t);
      return glm::dot(off, off);
    }
  };
  std::int32_t build(std::int32_t first, std::int32_t count);

  std::vector<Sweep> sweeps_;
  double radius_;
  std::vector<std::int32_t> order_;
  std::vector<Leg> legs_;  // as order_
  std::vector<Node> nodes_;
};

}  // namespace cusp::bench
