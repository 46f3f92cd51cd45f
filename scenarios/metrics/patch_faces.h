/// Triangles of the surface that is left, of which the patches of measures are made.
/// Frame: specimen. Millimetres. Not for the haptic thread; the volume must not change meanwhile.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

using Triangle = std::array<Vec3, 3>;

inline Vec3 middle_of(const Triangle& t) noexcept { return (t[0] + t[1] + t[2]) / 3.0; }

/// The voxel that stands under a triangle, whichever side of it is within; nullopt where none does.
[[nodiscard]] std::optional<IVec3> voxel_under(const Volume& volume, const Triangle& t) noexcept;

/// Some voxels of a grid.
class VoxelSet {
 public:
  VoxelSet(const Grid& grid, const std::vector<IVec3>& voxels) : size_(grid.size) {
    for (const IVec3 v : voxels) codes_.push_back(code_of(v));
    std::ranges::sort(codes_);
  }
  bool has(std::optional<IVec3> v) const noexcept { return v && std::ranges::binary_search(codes_, code_of(*v)); }

 private:
  std::int64_t code_of(IVec3 v) const noexcept { return v.x + static_cast<std::int64_t>(size_.x) * (v.y + static_cast<std::int64_t>(size_.y) * v.z); }
  IVec3 size_;
  std::vector<std::int64_t> codes_;
};

/// Whether a triangle belongs to a patch. The tissue is that of the nearest voxel before anything was cut.
using IsKept = std::function<bool(const Triangle&, Tissue)>;

/// Of the cut surface. Milliseconds.
[[nodiscard]] std::vector<Triangle> cut_where(const Volume& volume, const IsKept& is_kept);

/// Of the specimen's own surface that still stands. Tenths of a second for a molar at 0.1 mm.
[[nodiscard]] std::vector<Triangle> standing_where(const Volume& volume, const IsKept& is_kept);

/// The free surface of these voxels, cut or the specimen's own. A triangle belongs to the voxel that stands under it; none of a
/// voxel that is gone. Looks only at the bricks about them.
[[nodiscard]] std::vector<Triangle> surface_of(const Volume& volume, const std::vector<IVec3>& voxels);

/// For each voxel the last of those that stand without a gap straight above it.
[[nodiscard]] std::vector<IVec3> top_above(const Volume& volume, const std::vector<IVec3>& voxels);

}  // namespace cusp::scenarios
