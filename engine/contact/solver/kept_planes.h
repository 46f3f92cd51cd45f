/// Planes that held a bur in earlier passes of a search that goes to and fro. Where the nearest cell changes with the pose, a
/// pass knows but one of two planes; together they end the search. Thread: haptic. No heap.
#pragma once

#include "engine/contact/solver/plane_search.h"
#include "engine/volume/tissue.h"

namespace cusp::engine {

struct KeptPlane {
  Plane plane;
  Vec3 seen_from{0.0};  // pose of the pass, mm
  Tissue tissue = Tissue::empty;
  bool of_shank = false;
};

class KeptPlanes {
 public:
  static constexpr int kMost = 6;  // the newest: two passes of three

  void clear() noexcept { added_ = 0; }
  void add(const KeptPlane& kept) noexcept { at_[added_++ % kMost] = kept; }
  int count() const noexcept { return added_ < kMost ? added_ : kMost; }
  const KeptPlane& operator[](int i) const noexcept { return at_[i]; }

 private:
  KeptPlane at_[kMost];
  int added_ = 0;
};

}  // namespace cusp::engine
