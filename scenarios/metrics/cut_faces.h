/// The cut surface as triangles by the faces of the target: what the measurements of form look at.
/// Frame: specimen. Millimetres. Not for the haptic thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/metrics/depth.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// A triangle of the surface that the bur left.
struct CutFace {
  Vec3 middle_mm{0.0};
  Vec3 area_mm2{0.0};  // vector: along the normal into the void, as long as the triangle's area
  Vec3 normal{0.0};    // of the cut field there: a sliver of a triangle has none of its own
  std::array<Vec3, 3> corners_mm{};
};

/// Faces of one volume.
///
/// A lone upright outline has its faces by their normals: the floor leans less than 45 degrees (dental.md 2.2) and lies where the
/// target's floor is flat; a wall leans less than 45 degrees from the axis and lies above the rounded line angle, at most
/// kWallReachMm off the outline. A wall faces away from the side that names it, by the nearer of the two directions.
///
/// In a tree a triangle belongs to the face that it faces (scenarios/shapes/facing.h), at most reach_mm() beyond it
/// and kWallReachMm beside it.
/// A floor lies off the walls of its part by the rounded line angle and where the target is flat; a wall above the floor that was cut
/// there. What faces a
/// side_wall, of no named side, is named by its normal; without a tooth's number it stays a side_wall.
class CutFaces {
 public:
  /// Tens of milliseconds. A filled reading has steps for faces: it stays empty. `depth`: floor_depth() of the volume.
  CutFaces(const Reference& reference, const Volume& volume, const std::optional<FloorDepth>& depth);

  const std::vector<CutFace>& of(FaceName name) const noexcept { return faces_[static_cast<std::size_t>(name)]; }
  /// What lies below a wall, in the line angle or deeper: it has the wall's normal, but no part in the wall's form.
  const std::vector<CutFace>& foot_of(FaceName wall) const noexcept { return feet_[static_cast<std::size_t>(wall)]; }
  /// Without a tooth's number nobody knows where mesial is: walls named by their normals are then in of(), mirrored or not.
  bool side_known(FaceName name) const noexcept { return side_known_[static_cast<std::size_t>(name)]; }

 private:
  std::array<std::vector<CutFace>, kFaceNames> faces_, feet_;
  std::array<bool, kFaceNames> side_known_{};
};

/// Name of a wall whose normal into the void leans so. Without a tooth's number (mesial_x 0) mesial is taken along +x.
[[nodiscard]] FaceName wall_by_normal(Vec3 into_void, int mesial_x) noexcept;

/// Further off the target a cut is damage and none of its faces, mm [M].
inline constexpr double kWallReachMm = 1.0;
/// The same of an axial wall, and of the margin of a box, mm [M].
inline constexpr double kBoxReachMm = 2.5;
/// How far beyond a face of the target what was cut is still that face, mm. A floor is one at any depth.
[[nodiscard]] double reach_mm(FaceName face) noexcept;

}  // namespace cusp::scenarios
