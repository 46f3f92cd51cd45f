/// The box of everything that held tissue at the start: outside it nothing can be touched.
#pragma once

#include "engine/volume/volume.h"

namespace cusp::engine {

/// Voxels with s > 0, inclusive; low above high when there are none. Not for the haptic thread.
struct TissueVoxels {
  IVec3 low{0}, high{-1};

  explicit TissueVoxels(const Specimen& specimen) : low(specimen.grid().size) {
    const IVec3 n = specimen.brick_count();
    for (int brick = 0; brick < n.x * n.y * n.z; ++brick) {
      const IVec3 corner = specimen.brick_at(brick) * kBrickEdge;
      if (specimen.uniform(brick)) {
        if (specimen.s_in(brick, 0) == 0) continue;
        low = glm::min(low, corner);
        high = glm::max(high, corner + (kBrickEdge - 1));
        continue;
      }
      for (int o = 0; o < kBrickVoxels; ++o)
        if (specimen.s_in(brick, o) > 0) {
          const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
          low = glm::min(low, v);
          high = glm::max(high, v);
        }
    }
  }
};

/// The same in mm, a voxel wider: beyond it every distance is the band's.
struct TissueBox {
  Vec3 low{1.0}, high{-1.0};

  explicit TissueBox(const Volume& volume) {
    const TissueVoxels voxels(volume.specimen());
    if (voxels.high.x < 0) return;
    low = volume.grid().centre_mm(voxels.low - 1);
    high = volume.grid().centre_mm(voxels.high + 1);
  }
  bool contains(Vec3 p, double wider_mm = 0.0) const noexcept {
    for (int i = 0; i < 3; ++i)
      if (!(p[i] >= low[i] - wider_mm && p[i] <= high[i] + wider_mm)) return false;
    return true;
  }
  /// How far a tube of this radius about p + t axis, t >= 0, can still meet the box; negative: nowhere.
  double leaves(Vec3 p, Vec3 axis, double radius_mm) const noexcept {
    double enter = 0.0, leave = 1e9;
    for (int i = 0; i < 3; ++i) {
      const double a = low[i] - radius_mm - p[i];
      const double b = high[i] + radius_mm - p[i];
      if (axis[i] > 1e-9 || axis[i] < -1e-9) {
        const double s = a / axis[i], t = b / axis[i];
        enter = s < t ? (s > enter ? s : enter) : (t > enter ? t : enter);
        leave = s < t ? (t < leave ? t : leave) : (s < leave ? s : leave);
      } else if (a > 0.0 || b < 0.0) {
        return -1.0;
      }
    }
    return enter <= leave ? leave : -1.0;
  }
};

}  // namespace cusp::engine
