/// Penetration depth of a ball into tissue that no stroke has carved, computed from the strokes: the field rounds the ridge
/// between two cuts by up to a third of a voxel. Frame: specimen, mm. Thread: haptic. Wait-free.
#pragma once

#include <array>

#include "engine/contact/cut_memory.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

struct Penetration {
  double depth_mm = 0.0;  // greatest depth of the ball's surface; at most 0: none was found
  Vec3 towards{0.0};      // unit, from the ball's centre to the deepest point, or to the last one tried
  Vec3 along{0.0};        // unit, along the ridge there; zero: no ridge was found
};

/// Searches one area of a ball's surface, about `towards` (unit), from poses that differ by a few um. The constructor
/// gathers the strokes once. 71 KB in all, on the stack of a tick. Only ticks that slide further than they wear use it.
class PenetrationSearch {
 public:
  static constexpr double kReachMm = 0.16;  // of the place, along the ball
  static constexpr int kStrokes = 512;

  /// Pre: all that was swept is carved.
  PenetrationSearch(const Volume& volume, const CutMemory& memory, double radius_mm, Vec3 pose, Vec3 towards) noexcept;

  /// Climbs on the ball's surface from `towards`, then along the ridge that the nearest strokes have left, to 0.1 um.
  /// enough_mm: the search may stop if the depth is surely no greater. Finds nothing if the cut field holds more than the
  /// known strokes of balls (another head's, a fragment's, forgotten ones), or more than kStrokes strokes are near.
  /// Pre: pose within kNearMm of the first; strokes further away were not gathered, so no depth exceeds it.
  static constexpr double kNearMm = 0.03;
  /// beside: `towards` is near a ridge already; the search stays close to it.
  Penetration deepest(Vec3 pose, Vec3 towards, double enough_mm, bool beside = false) noexcept;

 private:
  struct Crest;
  /// The capsule that a ball swept.
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
  void choose_strokes(Vec3 place, double reach_mm) noexcept;
  double climb(Vec3 pose, bool beside, Vec3& towards) noexcept;
  double along_crest(Vec3 pose, double best, double enough_mm, Vec3& towards, Vec3& along) const noexcept;
  bool known_from_strokes(Vec3 place) noexcept;

  const Volume& volume_;
  double radius_;
  Vec3 pose_, towards_;     // at first
  Vec3 normal_{0.0};        // of the face there, which is flat enough within the reach
  double level_ = 0.0;      // normal times a place of it
  int strokes_ = 0;         // -1: more than there is room for
  IVec3 known_cell_{0};      // cell whose samples the strokes explain
  bool known_ = false;
  std::array<Taken, kStrokes> stroke_;
  std::array<std::uint16_t, kStrokes> order_;  // the first at_hand_ of them are evaluated
  int at_hand_ = 0;
  int evaluations_ = 0;  // of distances to strokes, bounded by kMostEvaluations
};

}  // namespace cusp::engine
