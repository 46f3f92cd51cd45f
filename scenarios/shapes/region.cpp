#include "scenarios/shapes/region.h"

#include <span>

namespace cusp::scenarios {
namespace {

/// A face that there is none of lies so far off that it is never the nearest.
constexpr double kNoneMm = 100.0;

Vec3 unit(Vec3 v) noexcept {
  const double length = std::sqrt(glm::dot(v, v));
  return length > 0.0 ? v / length : Vec3(0.0, 0.0, 1.0);
}

/// The nearest of a leaf's faces, from how far the place lies out of each.
Near near_of(double d, std::span<const double> out, const std::array<FaceName, 6>& faces) noexcept {
  Near near{.distance_mm = d, .wall_mm = d - kNoneMm, .floor_mm = d - kNoneMm, .face = faces[0]};
  double most = out[0];
  for (std::size_t i = 0; i < out.size(); ++i) {
    double& side = is_floor(faces[i]) ? near.floor_mm : near.wall_mm;
    if (out[i] > side) (is_floor(faces[i]) ? near.floor : near.wall) = faces[i];
    side = std::max(side, out[i]);
    if (out[i] > most) {
      most = out[i];
      near.face = faces[i];
    }
  }
  return near;
}

/// Convex body between two planes and a side: exact beyond one of them, a lower bound beyond both edges of a cone.
double capped(double side, double ends) noexcept {
  const double a = std::max(side, 0.0), b = std::max(ends, 0.0);
  return std::sqrt(a * a + b * b) + std::min(std::max(side, ends), 0.0);
}

}  // namespace

RegionShape::RegionShape(const Region& region, std::shared_ptr<const Specimen> specimen) {
  add(region, specimen);
  bounds_ = bounds_of(0);
}

std::size_t RegionShape::add(const Region& region, const std::shared_ptr<const Specimen>& specimen) {
  const std::size_t index = nodes_.size();
  nodes_.emplace_back();
  Node node;
  node.kind = region.kind;
  node.from = region.from_mm;
  node.half = 0.5 * region.size_mm;
  node.radius = region.radius_mm;
  node.end_radius = region.end_radius_mm;
  node.rounding = region.rounding_mm;
  node.by = region.by_mm;
  const Vec3 along = region.to_mm - region.from_mm;
  const bool by_ends = region.kind == RegionKind::cylinder || region.kind == RegionKind::cone || region.kind == RegionKind::capsule;
  node.length = by_ends ? std::sqrt(glm::dot(along, along)) : 0.0;
  node.axes[2] = unit(by_ends ? along : region.z_axis);
  node.axes[0] = unit(region.x_axis - glm::dot(region.x_axis, node.axes[2]) * node.axes[2]);
  node.axes[1] = glm::cross(node.axes[2], node.axes[0]);
  const double widens = region.end_radius_mm - region.radius_mm;
  if (node.length > 0.0) node.slant = node.length / std::sqrt(node.length * node.length + widens * widens);
  const auto slots = face_slots(region.kind);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const auto named = region.faces.find(std::string(slots[i]));
    node.faces[i] = named != region.faces.end() ? named->second : default_face(region.kind, i);
  }
  if (region.kind == RegionKind::outline) {
    node.outline = outlines_.size();
    outlines_.emplace_back(region.outline);
  }
  if (is_of_voxels(region.kind) && specimen != nullptr) node.voxels = std::make_shared<const TissueShape>(specimen, tissues_of(region));
  for (const Region& part : region.parts) node.parts.push_back(add(part, specimen));
  nodes_[index] = std::move(node);
  return index;
}

Near RegionShape::leaf(const Node& node, Vec3 p) const noexcept {
  const Vec3 q = p - node.from;
  switch (node.kind) {
    case RegionKind::outline: return outlines_[node.outline].near(p, node.faces);
    case RegionKind::box: {
      const Vec3 own(glm::dot(q, node.axes[0]), glm::dot(q, node.axes[1]), glm::dot(q, node.axes[2]));
      const std::array<double, 6> out = {-own.z - node.half.z, own.z - node.half.z, -own.x - node.half.x,
                                         own.x - node.half.x,  -own.y - node.half.y, own.y - node.half.y};
      return near_of(box_distance(own, Vec3(0.0), node.half), out, node.faces);
    }
    case RegionKind::cylinder:
    case RegionKind::cone: {
      const double t = glm::dot(q, node.axes[2]);
      const Vec3 off = q - t * node.axes[2];
      const double radius = std::sqrt(glm::dot(off, off));
      const bool cone = node.kind == RegionKind::cone;
      const double wide = cone ? node.radius + (node.end_radius - node.radius) * t / node.length : node.radius;
      const double side = cone ? (radius - wide) * node.slant : radius - wide;
      const std::array<double, 3> out = {-t, t - node.length, side};
      const double ends = std::max(out[0], out[1]);
      return near_of(cone ? std::max(side, ends) : capped(side, ends), out, node.faces);
    }
    case RegionKind::tissue:
    case RegionKind::lesion: {
      const double d = node.voxels ? node.voxels->distance_mm(p) : TissueShape::kFarMm;
      return near_of(d, {&d, 1}, node.faces);
    }
    case RegionKind::sphere: {
      const double d = ball_distance(p, node.from, node.radius);
      return near_of(d, {&d, 1}, node.faces);
    }
    case RegionKind::capsule: {
      const double d = capsule_distance(p, node.from, node.from + node.length * node.axes[2], node.radius);
      return near_of(d, {&d, 1}, node.faces);
    }
    case RegionKind::ellipsoid: {
      const Vec3 share = q / node.half;
      const double d = (std::sqrt(glm::dot(share, share)) - 1.0) * std::min({node.half.x, node.half.y, node.half.z});
      return near_of(d, {&d, 1}, node.faces);
    }
    default: {
      const double d = glm::dot(q, node.axes[2]);
      return near_of(d, {&d, 1}, node.faces);
    }
  }
}

Near RegionShape::at(std::size_t index, Vec3 p) const noexcept {
  const Node& node = nodes_[index];
  if (!is_node(node.kind)) return leaf(node, p);
  Near out = at(node.parts.front(), p);
  if (node.kind == RegionKind::offset) {
    out.distance_mm -= node.by;
    out.wall_mm -= node.by;
    out.floor_mm -= node.by;
    return out;
  }
  for (std::size_t i = 1; i < node.parts.size(); ++i) {
    const Node& part = nodes_[node.parts[i]];
    // Voxels are asked only where a union may come to them.
    if (node.kind == RegionKind::joined && part.voxels) {
      const double least = part.voxels->least_mm(p);
      if (least > 0.0 && least >= out.distance_mm + kBlendReach * node.rounding) continue;
    }
    Near next = at(node.parts[i], p);
    if (node.kind == RegionKind::difference) next.distance_mm = -next.distance_mm;
    const bool joined = node.kind == RegionKind::joined;
    const double d = joined ? -blended_max(-out.distance_mm, -next.distance_mm, node.rounding)
                            : blended_max(out.distance_mm, next.distance_mm, node.rounding);
    if (joined ? next.distance_mm < out.distance_mm : next.distance_mm > out.distance_mm) out = next;
    out.distance_mm = d;
  }
  return out;
}

RegionBounds RegionShape::bounds_of(std::size_t index) const noexcept {
  const Node& node = nodes_[index];
  const Vec3 far(kEndlessMm), to = node.from + node.length * node.axes[2];
  const double wide = std::max(node.radius, node.end_radius);
  switch (node.kind) {
    case RegionKind::outline: {
      const OutlineShape& o = outlines_[node.outline];
      return {Vec3(o.low(), o.floor_mm()), Vec3(o.high(), kEndlessMm)};
    }
    case RegionKind::box: {
      const Vec3 reach = node.half.x * glm::abs(node.axes[0]) + node.half.y * glm::abs(node.axes[1]) + node.half.z * glm::abs(node.axes[2]);
      return {node.from - reach, node.from + reach};
    }
    case RegionKind::ellipsoid: return {node.from - node.half, node.from + node.half};
    case RegionKind::half_space: return {-far, far};
    case RegionKind::tissue:
    case RegionKind::lesion: return node.voxels ? RegionBounds{node.voxels->low(), node.voxels->high()} : RegionBounds{};
    case RegionKind::joined: {
      RegionBounds out = bounds_of(node.parts.front());
      for (const std::size_t part : node.parts) {
        const RegionBounds b = bounds_of(part);
        out = {glm::min(out.low, b.low), glm::max(out.high, b.high)};
      }
      return {out.low - node.rounding, out.high + node.rounding};  // a blended union stands out of both
    }
    case RegionKind::common: {
      RegionBounds out = bounds_of(node.parts.front());
      for (const std::size_t part : node.parts) {
        const RegionBounds b = bounds_of(part);
        out = {glm::max(out.low, b.low), glm::min(out.high, b.high)};
      }
      return {out.low, glm::max(out.low, out.high)};
    }
    case RegionKind::difference: return bounds_of(node.parts.front());
    case RegionKind::offset: {
      const RegionBounds b = bounds_of(node.parts.front());
      return {b.low - node.by, glm::max(b.low - node.by, b.high + node.by)};
    }
    default: return {glm::min(node.from, to) - wide, glm::max(node.from, to) + wide};
  }
}

}  // namespace cusp::scenarios
