/// The plain trilinear distance of a banded volume, min(B, C), and its gradient by central differences: what the
/// penalty and the gradient proxy stand on, as their users have it. (The surface proxy reads B and C apart, corrected.)
/// Wait-free; only + - * /, sqrt and comparisons.
#pragma once

#include <array>

#include "engine/volume/cell_field.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

class TrilinearField {
 public:
  explicit TrilinearField(const Volume& volume) noexcept
      : volume_(volume), voxel_(volume.grid().voxel_mm), inverse_(1.0 / voxel_), origin_(volume.grid().origin_mm) {}

  /// Distance in mm, negative in tissue; clamped at the band, kBandVoxels either way.
  double at(Vec3 p_mm) const noexcept {
    const Vec3 x = (p_mm - origin_) * inverse_;
    const IVec3 cell = cell_of_voxels(x);
    const Vec3 f = x - Vec3(cell);
    double s[8];
    load(cell, s);
    const double s00 = s[0] + f.x * (s[1] - s[0]);
    const double s10 = s[2] + f.x * (s[3] - s[2]);
    const double s01 = s[4] + f.x * (s[5] - s[4]);
    const double s11 = s[6] + f.x * (s[7] - s[6]);
    const double s0 = s00 + f.y * (s10 - s00);
    const double s1 = s01 + f.y * (s11 - s01);
    return (kBandVoxels - (s0 + f.z * (s1 - s0)) * (2.0 * kBandVoxels / 65535.0)) * voxel_;
  }

  /// Unit normal out of the tissue, by differences over a voxel either way. False where the field says no direction:
  /// beyond the band, or in the middle of a wall.
  bool normal(Vec3 p_mm, Vec3& n) const noexcept {
    Vec3 g;
    for (int a = 0; a < 3; ++a) {
      Vec3 low = p_mm, high = p_mm;
      low[a] -= voxel_;
      high[a] += voxel_;
      g[a] = (at(high) - at(low)) * (0.5 * inverse_);
    }
    const double length = length_of(g);
    if (!(length > 0.25)) return false;
    n = g / length;
    return true;
  }

  Tissue tissue(Vec3 p_mm) const noexcept {
    return volume_.tissue(cell_of_voxels((p_mm - origin_) * inverse_ + 0.5));
  }
  double band_mm() const noexcept { return kBandVoxels * voxel_; }

 private:
  /// One brick's values, base and cut; a brick that is all alike reads from one of two that are.
  struct Source {
    const std::uint16_t* base;
    const std::uint16_t* cut;
  };
  static constexpr std::array<std::uint16_t, kBrickVoxels> kEmptyBrick{};
  static constexpr std::array<std::uint16_t, kBrickVoxels> kSolidBrick = [] {
    std::array<std::uint16_t, kBrickVoxels> out{};
    out.fill(kSolid);
    return out;
  }();
  Source source(int x, int y, int z) const noexcept {
    const Specimen& specimen = volume_.specimen();
    const int b = specimen.brick_index({x, y, z});
    if (b < 0) return {kEmptyBrick.data(), kSolidBrick.data()};
    const std::uint16_t* base = specimen.s_of(b);
    const std::uint16_t* cut = volume_.cut_of(b);
    if (!base) base = specimen.s_in(b, 0) > 0 ? kSolidBrick.data() : kEmptyBrick.data();
    return {base, cut ? cut : kSolidBrick.data()};
  }
  static double value(const Source& from, int at) noexcept {
    const std::uint16_t b = from.base[at];
    const std::uint16_t c = from.cut[at];
    return b < c ? b : c;
  }
  /// The eight samples round a cell, x fastest.
  void load(IVec3 cell, double* s) const noexcept {
    const int bx = cell.x >> 3, by = cell.y >> 3, bz = cell.z >> 3;
    const int x = cell.x & 7, y = cell.y & 7, z = cell.z & 7;
    if (x < 7 && y < 7 && z < 7) {
      const Source from = source(bx, by, bz);
      const int o = brick_offset(x, y, z);
      s[0] = value(from, o), s[1] = value(from, o + 1), s[2] = value(from, o + 8), s[3] = value(from, o + 9);
      s[4] = value(from, o + 64), s[5] = value(from, o + 65), s[6] = value(from, o + 72), s[7] = value(from, o + 73);
      return;
    }
    // The cell reaches into the next brick along the axes where it is the last.
    const int x1 = (x + 1) & 7, y1 = ((y + 1) & 7) << 3, z1 = ((z + 1) & 7) << 6;
    const int y0 = y << 3, z0 = z << 6;
    const bool over_x = x == 7;
    for (int i = 0; i < 4; ++i) {
      const int to_y = i & 1, to_z = i >> 1;
      const int row = (to_y ? y1 : y0) | (to_z ? z1 : z0);
      const int ny = by + (to_y & (y == 7)), nz = bz + (to_z & (z == 7));
      const Source from = source(bx, ny, nz);
      s[2 * i] = value(from, row | x);
      s[2 * i + 1] = value(over_x ? source(bx + 1, ny, nz) : from, row | x1);
    }
  }

  const Volume& volume_;
  double voxel_, inverse_;
  Vec3 origin_;
};

}  // namespace cusp::engine
