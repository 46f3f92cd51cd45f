/// How deep a ball stands in tissue that no stroke has taken, told by the strokes themselves: a field rounds the ridge between
/// two cuts by up to a third of a voxel. Thread: haptic; wait-free; only + - * / sqrt.
#pragma once

#include "engine/contact/cut_memory.h"
#include "engine/volume/volume.h"

namespace cusp {

struct Uncut {
  double depth_mm = 0.0;  // of the ball's surface in what is left, where it is deepest; not above 0: none was found
  Vec3 towards{0.0};      // unit, from the ball's centre to that place
};

/// Looks on the ball's surface from `towards` (unit) on, uphill and about kUncutReachMm at most, at last along the crest that
/// the nearest strokes have left, which it finds to 0.1 um. Pre: all that was swept
/// is carved. Nothing is told where the cut's field holds more than the balls' strokes that are known (another head's, a
/// fragment's, forgotten ones), and where these are more than kUncutStrokes.
inline constexpr double kUncutReachMm = 0.1;
inline constexpr int kUncutStrokes = 512;
Uncut deepest_uncut(const Volume& volume, const CutMemory& memory, double radius_mm, Vec3 pose, Vec3 towards) noexcept;

}  // namespace cusp
