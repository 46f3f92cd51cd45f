/// Points on a bur's skin: its head, each with its share of it, and its neck and shank, coarser.
/// Made of + - * / and sqrt alone, so that the same bur has the same points everywhere.
#pragma once

#include <vector>

#include "engine/base/vec.h"
#include "engine/contact/methods/tissue_box.h"
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
  Vec3 axis{0.0, 0.0, 1.0};         // unit, from the head towards the shank
  double reach_mm = 0.0;            // of the head from the pivot
  double holder_radius_mm = 0.0;    // of neck or shank, the wider one

  /// Calls on_head(point, place) for the head's points that lie in the box, then on_holder(point, place) for those of neck and
  /// shank. at: the pivot, mm. Wait-free.
  template <class OnHead, class OnHolder>
  void for_points_in(const TissueBox& box, Vec3 at, OnHead&& on_head, OnHolder&& on_holder) const noexcept {
    if (box.contains(at, reach_mm))
      for (const HeadPoint& point : head)
        if (const Vec3 place = at + point.offset_mm; box.contains(place)) on_head(point, place);
    const double leaves_mm = box.leaves(at, axis, holder_radius_mm);
    for (const HolderPoint& point : holder) {
      if (point.along_mm > leaves_mm) break;
      if (const Vec3 place = at + point.offset_mm; box.contains(place)) on_holder(point, place);
    }
  }
};

/// axis: unit, from the head towards the shank. Spacings in mm, about. Not for the haptic thread.
PointShell shell_of(const Bur& bur, Vec3 axis, double head_spacing_mm, double holder_spacing_mm);

}  // namespace cusp::engine
