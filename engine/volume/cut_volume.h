/// Volumes and areas from the surface s = 1/2, cut cell by cell. A sum of s is 22 % too large for a 0.25 mm ball. Base
/// and cut are two smooth fields. Each cell is cut by one and then by the other, so their crease at a cut's mouth is
/// not rounded. Not for the haptic thread; the volume must not change meanwhile.
///
/// A cell has eight octants, one for each corner voxel, with that voxel's tissue. An octant has six tetrahedra with a
/// linear field. A shift makes its mean over the octant that of the corrected field (cell_field.h). Measured
/// (tests/engine/volume/cut_volume_test.cpp): balls 0.011 % at 3 voxels of radius, 0.0014 % at 6, 0.0002 % at 12. A
/// sharp edge of the specimen loses 0.14 h² a mm, and so does a ridge between two cuts. At a corner that a flat head
/// left, the faces beside it are continued to their meeting line (sharp_edge.h). It loses a quarter of that, for a
/// third more time. A filled reading counts voxels with s > 0 and their faces.
#pragma once

#include <array>

#include "engine/volume/volume.h"

namespace cusp::engine {

/// Receives boxes, tetrahedra and faces of a solid. Lengths in mm, specimen frame.
class SolidSink {
 public:
  virtual ~SolidSink() = default;
  /// Begins a cell: until the next call, everything lies in this box.
  virtual void cell(Vec3 low, Vec3 high) = 0;
  virtual void box(Vec3 low, Vec3 high, Tissue tissue) = 0;
  virtual void tetrahedron(const std::array<Vec3, 4>& corners, double mm3, Tissue tissue) = 0;
  /// A triangle of the specimen's surface, or of the one that a bur left (emit_removed()).
  virtual void face(const std::array<Vec3, 3>& corners, double mm2, Tissue tissue) = 0;
};

/// Emits what the specimen held at the start in the cells of this brick. Cell (i,j,k) belongs to the brick of voxel
/// (i,j,k); bricks at the low ends of the grid also have the cells that reach out of it.
void emit_specimen(const Specimen& specimen, int brick, SolidSink& sink);
/// Emits what cutting has removed in the cells of this brick, and the faces that it left. Depends on this brick and its
/// 26 neighbours.
void emit_removed(const Volume& volume, int brick, SolidSink& sink);

/// Volume by tissue, and area of the surface.
struct SolidMeasure {
  std::array<double, kTissueCodes> mm3{};
  double area_mm2 = 0;
  double total_mm3() const noexcept;
};

[[nodiscard]] SolidMeasure specimen_solid(const Specimen& specimen);
[[nodiscard]] SolidMeasure removed_solid(const Volume& volume);

}  // namespace cusp::engine
