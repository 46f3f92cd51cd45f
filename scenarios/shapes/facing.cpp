// RegionShape::facing, and the faces of each kind of leaf.

#include <limits>
#include <span>

#include "scenarios/shapes/region.h"

namespace cusp::scenarios {
namespace {

/// A wall or floor that the leaf has none of lies so far off that nothing is near it.
constexpr double kNoFaceMm = 100.0;

Vec3 direction_of(Vec3 v) noexcept {
  const double length = std::sqrt(glm::dot(v, v));
  return length > 0.0 ? v / length : Vec3(0.0);
}

/// Out of all faces but one: how far beside its patch a place lies.
double beside(std::span<const LeafFace> faces, std::size_t own) noexcept {
  double square = 0.0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const double out = i == own ? 0.0 : std::max(0.0, faces[i].out_mm);
    square += out * out;
  }
  return std::sqrt(square);
}

}  // namespace

std::size_t RegionShape::faces_of(const Node& node, Vec3 p, std::array<LeafFace, 6>& out) const noexcept {
  const Vec3 q = p - node.from;
  const auto one = [&](double mm, Vec3 normal) {
    out[0] = {node.faces[0], mm, direction_of(normal)};
    return std::size_t{1};
  };
  switch (node.kind) {
    case RegionKind::outline: return outlines_[node.outline].faces_at(p, node.faces, out);
    case RegionKind::box:
      for (std::size_t i = 0; i < 6; ++i) {
        const std::size_t axis = i < 2 ? 2 : i < 4 ? 0 : 1;
        const Vec3 normal = (i % 2 == 0 ? -1.0 : 1.0) * node.axes[axis];
        out[i] = {node.faces[i], glm::dot(q, normal) - node.half[static_cast<int>(axis)], normal};
      }
      return 6;
    case RegionKind::cylinder:
    case RegionKind::cone: {
      const double t = glm::dot(q, node.axes[2]);
      const Vec3 off = q - t * node.axes[2];
      const double widens = node.end_radius - node.radius;
      const bool cone = node.kind == RegionKind::cone;
      const double wide = cone ? node.radius + widens * t / node.length : node.radius;
      const double steep = cone ? node.slant : 1.0;
      out[0] = {node.faces[0], -t, -node.axes[2]};
      out[1] = {node.faces[1], t - node.length, node.axes[2]};
      const Vec3 lean = cone ? widens / node.length * node.axes[2] : Vec3(0.0);
      out[2] = {node.faces[2], (std::sqrt(glm::dot(off, off)) - wide) * steep, direction_of(direction_of(off) - lean)};
      return 3;
    }
    case RegionKind::capsule: {
      const double t = std::clamp(glm::dot(q, node.axes[2]), 0.0, node.length);
      return one(leaf(node, p).distance_mm, q - t * node.axes[2]);
    }
    case RegionKind::tissue:
    case RegionKind::lesion:
      if (!node.voxels || node.voxels->empty()) return 0;
      return one(node.voxels->distance_mm(p), node.voxels->out_of(p));
    case RegionKind::sphere: return one(leaf(node, p).distance_mm, q);
    case RegionKind::ellipsoid: return one(leaf(node, p).distance_mm, q / (node.half * node.half));
    default: return one(leaf(node, p).distance_mm, node.axes[2]);
  }
}

void RegionShape::offer_faces(const Sought& sought, std::size_t index, double grown, Sense sense, Found& best) const noexcept {
  const Node& node = nodes_[index];
  if (is_node(node.kind)) {
    const double by = node.kind == RegionKind::offset ? node.by : 0.0;
    for (std::size_t i = 0; i < node.parts.size(); ++i) {
      // What an offset adds to a difference, the part that is taken off loses.
      const bool taken = node.kind == RegionKind::difference && i > 0;
      offer_faces(sought, node.parts[i], taken ? -grown : grown + by, taken ? opposite(sense) : sense, best);
    }
    return;
  }
  std::array<LeafFace, 6> faces;
  const std::size_t count = faces_of(node, sought.p, faces);
  Facing leaf;
  leaf.wall_mm = leaf.floor_mm = -kNoFaceMm;
  for (std::size_t i = 0; i < count; ++i) {
    faces[i].out_mm -= grown;
    const double out = sense == Sense::taken ? -faces[i].out_mm : faces[i].out_mm;
    double& kind = is_floor(faces[i].face) ? leaf.floor_mm : leaf.wall_mm;
    if (is_floor(faces[i].face) && out > kind) leaf.floor = faces[i].face;
    kind = std::max(kind, out);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 into_void = sense == Sense::taken ? faces[i].out : -faces[i].out;
    if (glm::dot(into_void, sought.into_void) < kFacingCosine) continue;
    Facing one = leaf;
    one.face = faces[i].face;
    one.into_void = into_void;
    one.beyond_mm = sense == Sense::taken ? -faces[i].out_mm : faces[i].out_mm;
    one.beside_mm = beside({faces.data(), count}, i);
    const double off = one.beyond_mm * one.beyond_mm + one.beside_mm * one.beside_mm;
    if (off < best.off) best = {off, one};
  }
}

std::optional<Facing> RegionShape::facing(Vec3 p, Vec3 into_void) const noexcept {
  Found best{std::numeric_limits<double>::max(), {}};
  offer_faces({p, into_void}, 0, 0.0, Sense::added, best);
  return best.off < std::numeric_limits<double>::max() ? std::optional(best.facing) : std::nullopt;
}

}  // namespace cusp::scenarios
