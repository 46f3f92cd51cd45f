#include "scenarios/operators/faulty_target.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace cusp::scenarios {

namespace {

FaceName face_of(const Region& leaf, std::size_t slot) {
  const auto named = leaf.faces.find(std::string(face_slots(leaf.kind)[slot]));
  return named != leaf.faces.end() ? named->second : default_face(leaf.kind, slot);
}

bool move_outline(Region& leaf, const FaceChoice& chosen, double out_mm) {
  Outline& outline = leaf.outline;
  bool moved = false, widened = false;
  for (std::size_t slot = 0; slot < face_slots(leaf.kind).size(); ++slot) {
    if (!chosen(face_of(leaf, slot))) continue;
    if (slot == 0) outline.depth_mm += out_mm;
    else if (outline.shape == "box") {
      const int axis = slot <= 2 ? 0 : 1;
      outline.box_size_mm[axis] += out_mm;
      outline.paths[0][0][axis] += (slot % 2 == 1 ? -0.5 : 0.5) * out_mm;
    } else if (!widened) {
      outline.width_mm += 2.0 * out_mm;
      widened = true;
    }
    moved = true;
  }
  return moved;
}

/// Unit vectors of a box's sides, as scenarios/shapes takes them.
std::array<Vec3, 3> axes_of(const Region& box) {
  const Vec3 z = glm::normalize(box.z_axis);
  const Vec3 x = glm::normalize(box.x_axis - glm::dot(box.x_axis, z) * z);
  return {x, glm::cross(z, x), z};
}

bool move_box(Region& leaf, const FaceChoice& chosen, double out_mm) {
  const std::array<Vec3, 3> axes = axes_of(leaf);
  bool moved = false;
  for (std::size_t slot = 0; slot < face_slots(leaf.kind).size(); ++slot) {
    if (!chosen(face_of(leaf, slot))) continue;
    const int axis = slot < 2 ? 2 : slot < 4 ? 0 : 1;
    leaf.size_mm[axis] += out_mm;
    leaf.from_mm += (slot % 2 == 0 ? -0.5 : 0.5) * out_mm * axes[static_cast<std::size_t>(axis)];
    moved = true;
  }
  return moved;
}

bool move_round(Region& leaf, const FaceChoice& chosen, double out_mm) {
  const std::size_t slots = face_slots(leaf.kind).size();
  bool moved = false;
  if (slots == 3 && chosen(face_of(leaf, 0))) {
    leaf.from_mm -= out_mm * glm::normalize(leaf.to_mm - leaf.from_mm);
    moved = true;
  }
  if (chosen(face_of(leaf, slots - 1))) {
    leaf.radius_mm += out_mm;
    if (leaf.kind == RegionKind::cone) leaf.end_radius_mm += out_mm;
    moved = true;
  }
  return moved;
}

/// The box, and a wedge of it beyond its side +y.
bool tilt_box(Region& leaf, double deg) {
  const double angle = deg * std::numbers::pi / 180.0;
  const std::array<Vec3, 3> axes = axes_of(leaf);
  Region plane;
  plane.kind = RegionKind::half_space;
  plane.from_mm = leaf.from_mm + 0.5 * leaf.size_mm.y * axes[1] - 0.5 * leaf.size_mm.z * axes[2];
  plane.z_axis = std::cos(angle) * axes[1] - std::sin(angle) * axes[2];
  plane.faces["surface"] = face_of(leaf, 5);
  Region wide = leaf;
  const double more = leaf.size_mm.z * std::tan(angle);
  wide.size_mm.y += more;
  wide.from_mm += 0.5 * more * axes[1];
  Region wedge;
  wedge.kind = RegionKind::common;
  wedge.parts = {std::move(wide), std::move(plane)};
  leaf = either(std::move(leaf), std::move(wedge));
  return true;
}

const Region* find_lesion(const Region& region) {
  if (region.kind == RegionKind::lesion) return &region;
  for (const Region& part : region.parts)
    if (const Region* found = find_lesion(part)) return found;
  return nullptr;
}

}  // namespace

bool move_faces(Region& region, const FaceChoice& chosen, double out_mm) {
  switch (region.kind) {
    case RegionKind::outline: return move_outline(region, chosen, out_mm);
    case RegionKind::box: return move_box(region, chosen, out_mm);
    case RegionKind::cylinder:
    case RegionKind::cone:
    case RegionKind::sphere:
    case RegionKind::capsule: return move_round(region, chosen, out_mm);
    default: break;
  }
  bool moved = false;
  // What is taken off has its faces turned round.
  for (std::size_t i = 0; i < region.parts.size(); ++i)
    moved |= move_faces(region.parts[i], chosen, region.kind == RegionKind::difference && i > 0 ? -out_mm : out_mm);
  return moved;
}

bool tilt_walls(Region& region, double deg) {
  if (region.kind == RegionKind::outline) {
    region.outline.taper_deg[3] += deg;
    return true;
  }
  if (region.kind == RegionKind::box) return tilt_box(region, deg);
  bool tilted = false;
  for (std::size_t i = 0; i < region.parts.size(); ++i)
    if (region.kind != RegionKind::difference || i == 0) tilted |= tilt_walls(region.parts[i], deg);
  return tilted;
}

Region either(Region a, Region b) {
  Region out;
  out.kind = RegionKind::joined;
  out.parts = {std::move(a), std::move(b)};
  return out;
}

Region without(Region a, Region b) {
  Region out;
  out.kind = RegionKind::difference;
  out.parts = {std::move(a), std::move(b)};
  return out;
}

Region grown(Region a, double by_mm) {
  Region out;
  out.kind = RegionKind::offset;
  out.by_mm = by_mm;
  out.parts = {std::move(a)};
  return out;
}

Region region_of(Tissue tissue) {
  Region out;
  out.kind = RegionKind::tissue;
  out.tissue = tissue;
  return out;
}

Region lesion_of(const Region& target) {
  if (const Region* found = find_lesion(target)) return *found;
  Region out;
  out.kind = RegionKind::lesion;
  return out;
}

}  // namespace cusp::scenarios
