/// Answer of the surface method: where the bur stands, and what holds it there. mm, unit vectors, the specimen's frame.
#pragma once

#include <algorithm>
#include <functional>

#include "engine/base/vec.h"
#include "engine/volume/tissue.h"

namespace cusp::engine {

struct Contact {
  Vec3 pose_mm{0.0};
  int active = 0;                 // constraints in the active set, at most 3
  Vec3 normal[3];                 // out of the tissue
  double weight[3] = {0, 0, 0};   // pose - device = sum weight * normal
  Tissue tissue[3] = {Tissue::empty, Tissue::empty, Tissue::empty};
  bool of_shank[3] = {};          // the constraint is the neck's or the shank's, which cut nothing
  bool infeasible = false;        // no pose met all constraints: they were relaxed to the pose before
  bool overflow = false;          // more candidates than room
  bool in_steps = false;          // the way to pose_mm was made in short steps
  bool deferred = false;          // the budget ended before the pose had converged: the next tick continues

  /// The active set contains the neck or the shank.
  bool shank() const noexcept { return std::any_of(of_shank, of_shank + active, std::identity{}); }
};

}  // namespace cusp::engine
