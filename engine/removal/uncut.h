/// How deep a ball stands in tissue that no stroke has taken, told by the strokes themselves: a field rounds the ridge between
/// two cuts by up to a third of a voxel. Thread: haptic; wait-free; only + - * / sqrt.
#pragma once

#include <array>

#include "engine/contact/cut_memory.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

struct Uncut {
  double depth_mm = 0.0;  // of the ball's surface in what is left, where it is deepest; not above 0: none was found
  Vec3 towards{0.0};      // unit, from the ball's centre to that place, or to where was looked last
  Vec3 along{0.0};        // unit, of the crest there; zero: none was seen
};

/// Looks at one place of a ball's surface, about `towards` (unit), from poses that differ by a few um: the strokes there are
/// gathered once. 34 KB, to stand on the stack of a tick, and 37 more while they are gathered. Cost of a tick's gathering and
/// looks, six at most, by instructions (callgrind, ball of 2.3 mm at 50 mm/s): sliding on a face that it wears 0.16 million,
/// most 0.95; to and fro over the ridge between two strokes in tissue that all but resists 0.07, most 0.25, and with some 350
/// strokes about the place, as where wear enters in every tick, 0.7, most 2.0. Only ticks that slide further than they wear
/// pay it.
class UncutPlace {
 public:
  static constexpr double kReachMm = 0.16;  // of the place, along the ball
  static constexpr int kStrokes = 512;

  /// Pre: all that was swept is carved.
  UncutPlace(const Volume& volume, const CutMemory& memory, double radius_mm, Vec3 pose, Vec3 towards) noexcept;

  /// Uphill on the ball's surface from `towards` on, at last along the crest that the nearest strokes have left, which it finds
  /// to 0.1 um. Where it is surely no deeper than `enough` it need not be found. Nothing is told where the cut's field holds
  /// more than the balls' strokes that are known (another head's, a fragment's, forgotten ones), or where these are more
  /// than kStrokes. Pre: pose within kNearMm of the first.
  /// kNearMm: no deeper either, for what lies further from the strokes that were gathered is not known.
  static constexpr double kNearMm = 0.03;
  /// beside: `towards` is near a crest already, along which there are others, as high perhaps.
  Uncut deepest(Vec3 pose, Vec3 towards, double enough_mm, bool beside = false) noexcept;

 private:
  struct Crest;
  /// What a ball took, with what its distance needs.
  struct Taken {
    Vec3 a{0.0}, along{0.0};
    double inverse = 0.0, radius_mm = 0.0;  // inverse: 1 / |along|^2, 0 where it stood still
    /// From its axis to a place.
    Vec3 off_axis(Vec3 place) const noexcept {
      const Vec3 from = place - a;
      const double part = glm::dot(from, along) * inverse;
      return from - along * (part < 0.0 ? 0.0 : part > 1.0 ? 1.0 : part);
    }
    double off(Vec3 place) const noexcept;
  };
  double depth(Vec3 place, double enough_mm) noexcept;
  void take_at_hand(Vec3 place, double reach_mm) noexcept;
  double climb(Vec3 pose, bool beside, Vec3& towards) noexcept;
  double along_crest(Vec3 pose, double best, double enough_mm, Vec3& towards, Vec3& along) const noexcept;
  bool told(Vec3 place) noexcept;

  const Volume& volume_;
  double radius_;
  Vec3 pose_, towards_;     // at first
  Vec3 normal_{0.0};        // of the face there, which is flat enough within the reach
  double level_ = 0.0;      // normal times a place of it
  int strokes_ = 0;         // -1: more than there is room for
  IVec3 told_cell_{0};      // where all that the field holds is told by the strokes
  bool told_ = false;
  std::array<Taken, kStrokes> stroke_;
  std::array<std::uint16_t, kStrokes> order_;  // the first at_hand_ of them: strokes that are looked at
  int at_hand_ = 0;
  int asked_ = 0;  // distances to strokes
};

}  // namespace cusp::engine
