/// Points on a bur's skin: its head, each with its share of it, and its neck and shank, coarser.
/// Made of + - * / and sqrt alone, so that the same bur has the same points everywhere.
#pragma once

#include <vector>

#include "engine/base/vec.h"
#include "engine/tool/bur.h"

namespace cusp::engine {

struct PointShell {
  struct HeadPoint {
    Vec3 offset_mm{0.0};  // from the pivot
    Vec3 out{0.0};        // unit normal
    double share = 0.0;   // of the head's skin; all shares are 1 together
  };
  struct HolderPoint {
    Vec3 offset_mm{0.0};  // from the pivot
    Vec3 out{0.0};        // unit normal
    double along_mm = 0.0;
  };
  std::vector<HeadPoint> head;
  std::vector<HolderPoint> holder;  // in order of along_mm; none inside the head
};

/// axis: unit, from the head towards the shank. Spacings in mm, about. Not for the haptic thread.
PointShell shell_of(const Bur& bur, Vec3 axis, double head_spacing_mm, double holder_spacing_mm);

}  // namespace cusp::engine
