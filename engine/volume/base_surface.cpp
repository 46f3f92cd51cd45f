#include "engine/volume/base_surface.h"

#include <algorithm>

#include "engine/volume/cell_field.h"
#include "engine/volume/sharp_edge.h"
#include "engine/volume/specimen.h"

namespace cusp {

namespace {
/// Outside an edge a distance is that to the edge, up to 0.3 voxel more than to either face.
constexpr double kMostOff = 1.6;

std::int16_t part(double n) noexcept { return static_cast<std::int16_t>(std::floor(n * 32767.0 + 0.5)); }

/// Tissue of the most solid corner; ties go to the lowest.
Tissue corner_tissue(const Specimen& specimen, IVec3 cell) noexcept {
  int most = -1;
  Tissue tissue = Tissue::empty;
  for (int i = 0; i < 8; ++i) {
    const IVec3 v = cell + IVec3(i & 1, i >> 1 & 1, i >> 2);
    const int s = specimen.s(v);
    if (s > most && specimen.tissue(v) != Tissue::empty) {
      most = s;
      tissue = specimen.tissue(v);
    }
  }
  return tissue;
}
}  // namespace

BaseSurface BaseSurface::of(const Specimen& specimen) {
  BaseSurface out;
  const IVec3 n = specimen.brick_count();
  const int bricks = n.x * n.y * n.z;
  out.first_.assign(static_cast<std::size_t>(bricks) + 1, 0);
  for (int b = 0; b < bricks; ++b) {
    out.first_[static_cast<std::size_t>(b)] = static_cast<std::uint32_t>(out.tissue_.size());
    // In a distance band no surface crosses a cell whose lower corner lies in an all-solid or all-empty brick.
    const std::uint16_t* values = specimen.s_of(b);
    if (values == nullptr) continue;
    const IVec3 corner = specimen.brick_at(b) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; ++o) {
      // Further than a cell's diagonal from the surface.
      if (values[o] < 11000 || values[o] > 54500) continue;
      const IVec3 local(o & 7, o >> 3 & 7, o >> 6);
      CellField field;
      field.load(specimen, corner + local);
      if (!field.crossed()) continue;
      Vec3 f, normal;
      std::uint16_t place = static_cast<std::uint16_t>(o);
      const Creased crease =
          creased(field, kMostOff, [&](IVec3 offset, CellField& to) {
        to.load(specimen, corner + local + offset);
        return true;
      });
      const auto index = static_cast<std::uint32_t>(out.tissue_.size());
      if (crease.kind == Creased::Kind::edge) {
        f = crease.edge.at;
        normal = crease.edge.tangent;
        place |= BaseNormal::kEdge;
        out.sharp_.push_back({index, 0.0f, Vec3f(crease.edge.bend)});
      } else if (crease.kind == Creased::Kind::face) {
        f = crease.point;
        normal = crease.normal;
        place |= BaseNormal::kBesideEdge;
        out.sharp_.push_back({index, static_cast<float>(crease.other_d), Vec3f(crease.other_normal)});
      } else if (!cell_point(field, f, normal)) {
        continue;
      }
      out.x_.push_back(static_cast<float>(local.x + f.x));
      out.y_.push_back(static_cast<float>(local.y + f.y));
      out.z_.push_back(static_cast<float>(local.z + f.z));
      out.normal_.push_back({part(normal.x), part(normal.y), part(normal.z), place});
      out.tissue_.push_back(corner_tissue(specimen, corner + local));
    }
  }
  out.first_[static_cast<std::size_t>(bricks)] = static_cast<std::uint32_t>(out.tissue_.size());
  for (std::vector<float>* v : {&out.x_, &out.y_, &out.z_}) {
    v->resize(v->size() + 7, 0.0f);
    v->shrink_to_fit();
  }
  out.normal_.shrink_to_fit();
  out.tissue_.shrink_to_fit();
  return out;
}

const BaseSurface::Sharp& BaseSurface::sharp(const BasePoints& points, int i) const noexcept {
  const std::uint32_t index = points.first + static_cast<std::uint32_t>(i);
  return *std::lower_bound(sharp_.begin(), sharp_.end(), index,
                           [](const Sharp& s, std::uint32_t wanted) { return s.index < wanted; });
}

}  // namespace cusp
