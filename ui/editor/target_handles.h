/// The handles of a target, and the target after one of them was moved. Frame: specimen, z up. Units: millimetres.
/// Pure functions.
#pragma once

#include <vector>

#include "scenarios/format/scenario.h"
#include "ui/modules.h"

namespace cusp::ui {

struct TargetHandle {
  enum class Kind {
    point, width, size_x, size_y, depth,                             // of an outline
    place, end, radius, end_radius, extent_x, extent_y, floor,       // of any other shape (part_handles.h)
    whole, rounding, growth,                                         // of a node (node_handles.h)
    landmark                                                         // of a tooth from a file (landmark_handles.h)
  };
  Kind kind = Kind::point;
  std::size_t path = 0, point = 0;  // of a point; of the first path where several meet. Of a landmark: the mark and its point
  Vec3 at_mm{0.0};                  // on the reference plane; for the depth on the floor
  Vec3 along{0.0};                  // unit: the one way in which the handle of a size moves; 0: any way
  MarkState state = MarkState::set;  // of a landmark
  bool of_outline() const { return kind <= Kind::depth; }
  /// It has no size: more and less mean nothing.
  bool is_place() const { return kind == Kind::point || kind == Kind::place || kind == Kind::end || kind == Kind::whole || kind == Kind::landmark; }
  bool is_floor() const { return kind == Kind::depth || kind == Kind::floor; }
  bool is_round() const { return is_floor() || kind == Kind::landmark; }
  friend bool operator==(const TargetHandle&, const TargetHandle&) = default;
};

inline constexpr double kLeastHandleMm = 0.1;  // least width, depth and side
inline constexpr double kHandleStepMm = 0.01;  // a drag rounds to it

/// The nearest multiple of kHandleStepMm, as a decimal number: 124 steps give 1.24.
double on_handle_step(double mm);
Vec3 on_handle_step(Vec3 mm);
/// Rounds to 0.1 µm, so that sums of steps print short.
double tidy(double mm);
Vec3 tidy(Vec3 mm);

/// One handle for each place of a point, then width or sides, then depth.
std::vector<TargetHandle> handles_of(const Outline& target);

/// The target after a handle was moved: a point (with all points at its place) moves in the occlusal plane, width, sides and floor
/// reach the new place. Rounds to kHandleStepMm.
/// Pre: the handle is one of handles_of(target).
Outline moved(const Outline& target, const TargetHandle& handle, Vec3 to_mm);

}  // namespace cusp::ui
