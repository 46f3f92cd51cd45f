/// The chosen meshes of an import, one by one: checked, placed in the specimen's frame, and as solid fractions.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/import/import.h"
#include "scenarios/import/triangle_mesh.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

struct MeshPart {
  TriangleMesh mesh;  // specimen frame, mm
  Tissue tissue = Tissue::empty;
  MeshCheck checked;
  std::size_t first_cap = 0;  // triangles from here on close holes: the file does not have them
  std::string turned_at;      // place of a shell that is inside out beside the others (turned_outside), as text; else empty
};

/// s of one part alone, on the box of the grid about it.
struct PartField {
  IVec3 first{0}, size{0};       // of the box, in voxels of the grid
  std::vector<std::uint16_t> s;  // [z][y][x]
  bool contains(IVec3 v) const noexcept {
    const IVec3 d = v - first;
    return d.x >= 0 && d.y >= 0 && d.z >= 0 && d.x < size.x && d.y < size.y && d.z < size.z;
  }
  /// 0 outside the box.
  std::uint16_t at(IVec3 v) const noexcept {
    if (!contains(v)) return 0;
    const IVec3 d = v - first;
    return s[static_cast<std::size_t>(d.x) +
             static_cast<std::size_t>(size.x) *
                 (static_cast<std::size_t>(d.y) + static_cast<std::size_t>(size.y) * static_cast<std::size_t>(d.z))];
  }
};

/// In the order in which they were asked for, mended where that was asked for too.
[[nodiscard]] Result<std::vector<MeshPart>, ImportFailure> choose_parts(std::vector<TriangleMesh> meshes, const MeshImport& what,
                                                                        std::vector<ImportRemark>& remarks);

/// Voxel centres at odd multiples of half a voxel, kPadVoxels about the box of all parts. Pre: parts is not empty.
[[nodiscard]] Result<Grid, ImportFailure> grid_about(const std::vector<MeshPart>& parts, const MeshImport& what);

/// A part's solids less its cavities. Throws std::bad_alloc.
[[nodiscard]] Result<PartField, ImportFailure> field_of(const MeshPart& part, const Grid& grid, const ImportProgress& progress);

}  // namespace cusp::scenarios
