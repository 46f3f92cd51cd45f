#include "engine/volume/base_surface.h"

#include <algorithm>

#include "engine/volume/cell_field.h"
#include "engine/volume/outer_corner.h"
#include "engine/volume/sharp_edge.h"
#include "engine/volume/specimen.h"

namespace cusp::engine {

namespace {
/// Voxels, summed over a cell's corners. Outside an edge the distance to the edge exceeds that to either face by up to
/// 0.3 voxel.
constexpr double kMostOff = 1.6;

std::int16_t in_32767ths(double n) noexcept { return static_cast<std::int16_t>(std::floor(n * 32767.0 + 0.5)); }

/// CellField::crossed() of the base field, by the cell's corners alone. Half of the cells near a surface are not crossed.
bool crossed(const Specimen& specimen, IVec3 cell) noexcept {
  const auto outside = [&](int i) { return distance_from_solid(specimen.s(cell + IVec3(i & 1, i >> 1 & 1, i >> 2))) > 0.0; };
  const bool first = outside(0);
  for (int i = 1; i < 8; ++i)
    if (outside(i) != first) return true;
  return false;
}

/// Each crossed cell's own, by brick, then by cell.
std::vector<BasePlace> points_of_cells(const Specimen& specimen) {
  std::vector<BasePlace> out;
  const IVec3 n = specimen.brick_count();
  for (int b = 0; b < n.x * n.y * n.z; ++b) {
    // In a distance band no surface crosses a cell whose lower corner lies in an all-solid or all-empty brick.
    const std::uint16_t* values = specimen.s_of(b);
    if (values == nullptr) continue;
    const IVec3 corner = specimen.brick_at(b) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; ++o) {
      if (values[o] < 11000 || values[o] > 54500) continue;  // further than a cell's diagonal from the surface
      const IVec3 local(o & 7, o >> 3 & 7, o >> 6);
      if (!crossed(specimen, corner + local)) continue;
      CellField field;
      field.load(specimen, corner + local);
      Vec3 f, normal;
      const auto load = [&](IVec3 offset, CellField& to) {
        if (!crossed(specimen, corner + local + offset)) return false;
        to.load(specimen, corner + local + offset);
        return true;
      };
      const Creased crease = creased(field, kMostOff, load, CreaseSearch::every_cell);
      const auto add = [&](Vec3 at, Vec3 direction, std::uint16_t flag, BasePlace::Detail detail = {}) {
        out.push_back({b, static_cast<std::uint16_t>(o | flag), corner_tissue(specimen, corner + local), flag != 0 ? 1 : 0,
                       Vec3(local) + at, direction, {detail, {}}});
      };
      if (crease.kind == Creased::Kind::edge) {
        add(crease.edge.at, crease.edge.tangent, BaseNormal::kEdge, {0.0, crease.edge.bend});
        for (int k = 0; k < crease.sides; ++k) {
          const Creased::Side& side = crease.side[k];
          add(side.point, side.normal, BaseNormal::kBesideEdge, {side.other_d, side.other_normal});
        }
      } else if (crease.kind == Creased::Kind::face) {
        add(crease.point, crease.normal, BaseNormal::kBesideEdge, {crease.other_d, crease.other_normal});
      } else if (crease.kind == Creased::Kind::no && cell_point(field, f, normal)) {
        add(f, normal, 0);
      }
    }
  }
  return out;
}
}  // namespace

BaseSurface BaseSurface::of(const Specimen& specimen) {
  std::vector<BasePlace> points = points_of_cells(specimen);
  add_outer_corners(specimen, points);
  BaseSurface out;
  const IVec3 n = specimen.brick_count();
  out.first_.reserve(static_cast<std::size_t>(n.x * n.y * n.z) + 1);
  for (std::vector<float>* v : {&out.x_, &out.y_, &out.z_}) v->reserve(points.size() + 7);
  out.normal_.reserve(points.size());
  out.tissue_.reserve(points.size());
  for (const BasePlace& point : points) {
    const auto index = static_cast<std::uint32_t>(out.tissue_.size());
    while (out.first_.size() <= static_cast<std::size_t>(point.brick)) out.first_.push_back(index);
    for (int k = 0; k < point.details; ++k)
      out.edge_details_.push_back({index, static_cast<float>(point.detail[k].other_d), Vec3f(point.detail[k].vector)});
    out.x_.push_back(static_cast<float>(point.at.x));
    out.y_.push_back(static_cast<float>(point.at.y));
    out.z_.push_back(static_cast<float>(point.at.z));
    out.normal_.push_back({in_32767ths(point.direction.x), in_32767ths(point.direction.y), in_32767ths(point.direction.z), point.place});
    out.tissue_.push_back(point.tissue);
  }
  out.first_.resize(static_cast<std::size_t>(n.x * n.y * n.z) + 1, static_cast<std::uint32_t>(points.size()));
  for (std::vector<float>* v : {&out.x_, &out.y_, &out.z_}) v->resize(points.size() + 7, 0.0f);
  out.edge_details_.shrink_to_fit();
  return out;
}

BaseSurface::EdgeDetails BaseSurface::edge_details(const BasePoints& points, int i) const noexcept {
  const std::uint32_t index = points.first + static_cast<std::uint32_t>(i);
  const auto first = std::lower_bound(edge_details_.begin(), edge_details_.end(), index,
                                      [](const EdgeDetail& d, std::uint32_t wanted) { return d.index < wanted; });
  const auto next = first + 1;
  return {&*first, next != edge_details_.end() && next->index == index ? &*next : nullptr};
}

}  // namespace cusp::engine
