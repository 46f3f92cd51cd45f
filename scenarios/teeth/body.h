/// What can be turned into voxels: a field whose zero is the surface, and the tissues within. Any thread (read only).
#pragma once

#include "engine/base/vec.h"
#include "engine/volume/tissue.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Slope that no field of a body exceeds away from fissures.
inline constexpr double kSlopeMost = 1.5;
/// Distance (mm) by which a field may be too large within a fissure.
inline constexpr double kFissureMm = 0.35;

class Body {
 public:
  Body() = default;
  Body(const Body&) = default;
  Body& operator=(const Body&) = default;
  virtual ~Body() = default;

  /// First-order signed distance (mm) to the surface, negative inside.
  virtual double outside(Vec3 p) const noexcept = 0;
  /// Tissue of a place inside; `outside_mm`: the best known distance to the surface there.
  virtual Tissue inside(Vec3 p, double outside_mm) const noexcept = 0;
  /// Tissue that a place on the surface is of.
  virtual Tissue skin(Vec3 p) const noexcept = 0;
  /// The one tissue of everything within `far` (in steps of the fields) of a place deep inside; empty when it is not one.
  virtual Tissue whole(Vec3 p, double far) const noexcept = 0;
  /// Corners of a box that holds the body with little to spare.
  virtual Vec3 low() const noexcept = 0;
  virtual Vec3 high() const noexcept = 0;
};

}  // namespace cusp::scenarios
