/// The plain trilinear distance of a banded volume, min(B, C), and its gradient by central differences: what the penalty
/// and the gradient proxy stand on, as their users have it. (The surface proxy reads B and C apart, corrected.)
/// Wait-free; only + - * /, floor and comparisons.
#pragma once

#include <cmath>

#include "engine/volume/volume.h"

namespace cusp {

class TrilinearField {
 public:
  explicit TrilinearField(const Volume& volume) noexcept
      : volume_(volume), voxel_(volume.grid().voxel_mm), inverse_(1.0 / voxel_), origin_(volume.grid().origin_mm) {}

  /// Distance in mm, negative in tissue; clamped at the band, kBandVoxels either way.
  double at(Vec3 p_mm) const noexcept {
    const Vec3 x = (p_mm - origin_) * inverse_;
    const Vec3 low(std::floor(x.x), std::floor(x.y), std::floor(x.z));
    const IVec3 cell(low);
    const Vec3 f = x - low;
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
    const double length = std::sqrt(g.x * g.x + g.y * g.y + g.z * g.z);
    if (!(length > 0.25)) return false;
    n = g / length;
    return true;
  }

  Tissue tissue(Vec3 p_mm) const noexcept {
    const Vec3 x = (p_mm - origin_) * inverse_ + 0.5;
    return volume_.tissue({static_cast<int>(std::floor(x.x)), static_cast<int>(std::floor(x.y)),
                           static_cast<int>(std::floor(x.z))});
  }
  double band_mm() const noexcept { return kBandVoxels * voxel_; }

 private:
  void load(IVec3 cell, double* s) const noexcept {
    const Specimen& specimen = volume_.specimen();
    if ((cell.x & 7) < 7 && (cell.y & 7) < 7 && (cell.z & 7) < 7) {
      const int brick = specimen.brick_index({cell.x >> 3, cell.y >> 3, cell.z >> 3});
      if (brick < 0) {
        for (int i = 0; i < 8; ++i) s[i] = 0.0;
        return;
      }
      const int o = brick_offset(cell.x & 7, cell.y & 7, cell.z & 7);
      const std::uint16_t* base = specimen.s_of(brick);
      const std::uint16_t* cut = volume_.cut_of(brick);
      const std::uint16_t all = base ? kSolid : specimen.s_in(brick, 0);
      for (int i = 0; i < 8; ++i) {
        const int at = o + (i & 1) + (i >> 1 & 1) * 8 + (i >> 2) * 64;
        const std::uint16_t b = base ? base[at] : all;
        const std::uint16_t c = cut ? cut[at] : kSolid;
        s[i] = b < c ? b : c;
      }
      return;
    }
    for (int i = 0; i < 8; ++i) s[i] = volume_.s(cell + IVec3(i & 1, i >> 1 & 1, i >> 2));
  }

  const Volume& volume_;
  double voxel_, inverse_;
  Vec3 origin_;
};

}  // namespace cusp
