/// What a method on the banded field found.
#pragma once

#include "engine/volume/volume.h"

namespace cusp::engine {

struct BandedContact {
  Vec3 pose_mm{0.0};  // of the bur: device point + F / K
  bool touching = false;
  double stiffness_n_per_mm = 0.0;  // of what is touched
  Tissue tissue = Tissue::empty;    // touched most
  bool shank = false;               // the neck or the shank touches ...
  Vec3 shank_normal{0.0};           // ... and is pushed this way
  bool infeasible = false;          // the pose still overlaps tissue by more than 1 um after the last pass
  bool deferred = false;            // still on its way: the rest next tick
};

}  // namespace cusp::engine
