#include "engine/volume/base_surface.h"

#include <algorithm>

#include "engine/volume/cell_field.h"
#include "engine/volume/sharp_edge.h"
#include "engine/volume/specimen.h"

namespace cusp::engine {

namespace {
/// Voxels, summed over a cell's corners. Outside an edge the distance to the edge exceeds that to either face by up to
/// 0.3 voxel.
constexpr double kMostOff = 1.6;

std::int16_t in_32767ths(double n) noexcept { return static_cast<std::int16_t>(std::floor(n * 32767.0 + 0.5)); }

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
      if (values[o] < 11000 || values[o] > 54500) continue;  // further than a cell's diagonal from the surface
      const IVec3 local(o & 7, o >> 3 & 7, o >> 6);
      CellField field;
      field.load(specimen, corner + local);
      if (!field.crossed()) continue;
      Vec3 f, normal;
      const auto load = [&](IVec3 offset, CellField& to) {
        to.load(specimen, corner + local + offset);
        return true;
      };
      const Creased crease = creased(field, kMostOff, load, CreaseSearch::every_cell);
      const auto add = [&](Vec3 at, Vec3 direction, std::uint16_t flags) {
        out.x_.push_back(static_cast<float>(local.x + at.x));
        out.y_.push_back(static_cast<float>(local.y + at.y));
        out.z_.push_back(static_cast<float>(local.z + at.z));
        out.normal_.push_back({in_32767ths(direction.x), in_32767ths(direction.y), in_32767ths(direction.z),
                               static_cast<std::uint16_t>(o | flags)});
        out.tissue_.push_back(corner_tissue(specimen, corner + local));
      };
      const auto add_detail = [&](double other_d, Vec3 vector) {
        out.edge_details_.push_back(
            {static_cast<std::uint32_t>(out.tissue_.size()), static_cast<float>(other_d), Vec3f(vector)});
      };
      if (crease.kind == Creased::Kind::edge) {
        add_detail(0.0, crease.edge.bend);
        add(crease.edge.at, crease.edge.tangent, BaseNormal::kEdge);
        for (int k = 0; k < crease.sides; ++k) {
          add_detail(crease.side[k].other_d, crease.side[k].other_normal);
          add(crease.side[k].point, crease.side[k].normal, BaseNormal::kBesideEdge);
        }
      } else if (crease.kind == Creased::Kind::face) {
        add_detail(crease.other_d, crease.other_normal);
        add(crease.point, crease.normal, BaseNormal::kBesideEdge);
      } else if (crease.kind == Creased::Kind::no && cell_point(field, f, normal)) {
        add(f, normal, 0);
      }
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

const BaseSurface::EdgeDetail& BaseSurface::edge_detail(const BasePoints& points, int i) const noexcept {
  const std::uint32_t index = points.first + static_cast<std::uint32_t>(i);
  return *std::lower_bound(edge_details_.begin(), edge_details_.end(), index,
                           [](const EdgeDetail& d, std::uint32_t wanted) { return d.index < wanted; });
}

}  // namespace cusp::engine
