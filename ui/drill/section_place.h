/// Where the plane of the cutaway stands. Over the target it goes through the bur; elsewhere it stays where the bur was over
/// the target last, and before that it goes through the target's middle: a bur that is lifted aside to look at the cavity
/// leaves the cavity open. Without a target the specimen takes its part. Pure; one thread.
#pragma once

#include "engine/base/vec.h"
#include "ui/render/target_look.h"

namespace cusp::ui {

class SectionPlace {
 public:
  /// `specimen`: its bounds, for an exercise without a target.
  SectionPlace(const TargetLook& look, const Box& specimen);
  /// A place of the plane for a bur with this pivot. Its height is the target's top, wherever the bur hangs.
  Vec3 follow(Vec3 pivot_mm) noexcept;

  static constexpr double kMarginMm = 1.0;  // about the outline: a bur that works along the wall is over the target

 private:
  Box near_;  // flat: its height counts for nothing
  Vec3 last_mm_;
};

}  // namespace cusp::ui
