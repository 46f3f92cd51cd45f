#include "engine/volume/base_surface.h"

#include "engine/volume/cell_field.h"
#include "engine/volume/specimen.h"

namespace cusp {

BaseSurface BaseSurface::of(const Specimen& specimen) {
  BaseSurface out;
  const IVec3 n = specimen.brick_count();
  const int bricks = n.x * n.y * n.z;
  out.first_.assign(static_cast<std::size_t>(bricks) + 1, 0);
  for (int b = 0; b < bricks; ++b) {
    out.first_[static_cast<std::size_t>(b)] = static_cast<std::uint32_t>(out.points_.size());
    // In a distance band no surface crosses a cell whose lower corner lies in an all-solid or all-empty brick.
    if (specimen.s_of(b) == nullptr) continue;
    const IVec3 corner = specimen.brick_at(b) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const IVec3 cell = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
      const std::uint16_t s0 = specimen.s(cell);
      // Further than a cell's diagonal from the surface.
      if (s0 < 11000 || s0 > 54500) continue;
      CellField field;
      field.load(specimen, cell);
      if (!field.crossed()) continue;
      Vec3 f, normal;
      if (!cell_point(field, f, normal)) continue;
      BasePoint point;
      point.offset = Vec3f(f);
      point.normal = Vec3f(normal);
      point.cell = static_cast<std::uint16_t>(o);
      int most = -1;
      for (int i = 0; i < 8; ++i) {
        const IVec3 v = cell + IVec3(i & 1, i >> 1 & 1, i >> 2);
        const int s = specimen.s(v);
        if (s > most && specimen.tissue(v) != Tissue::empty) {
          most = s;
          point.tissue = specimen.tissue(v);
        }
      }
      out.points_.push_back(point);
    }
  }
  out.first_[static_cast<std::size_t>(bricks)] = static_cast<std::uint32_t>(out.points_.size());
  out.points_.shrink_to_fit();
  return out;
}

}  // namespace cusp
