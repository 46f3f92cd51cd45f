#include "ui/editor/part_handles.h"

#include <algorithm>
#include <cmath>

#include "scenarios/format/ranges.h"
#include "ui/editor/node_handles.h"

namespace cusp::ui {
namespace {

using Kind = TargetHandle::Kind;

double least(double mm) { return std::max(on_handle_step(mm), kLeastHandleMm); }

struct Axes {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};  // unit
};
/// Of box and ellipsoid; the box's second axis stands on the other two.
Axes axes_of(const Region& part) {
  if (part.kind != RegionKind::box) return {};
  Axes out;
  out.z = glm::normalize(part.z_axis);
  out.y = glm::normalize(glm::cross(out.z, part.x_axis));
  out.x = glm::cross(out.y, out.z);
  return out;
}

/// At right angles to the way from one end to the other, as level as it can be.
Vec3 aside(const Region& part) {
  const Vec3 along = part.to_mm - part.from_mm;
  const Vec3 level = glm::cross(along, Vec3(0, 0, 1));
  return glm::length(level) < 1e-6 ? Vec3(1, 0, 0) : glm::normalize(level);
}

/// A rounding and a growth may be 0.
double in_range(std::string_view range, double mm) {
  const NumberRange& ends = *range_of(range);
  return std::clamp(on_handle_step(mm), ends.least, ends.most);
}

TargetHandle at(Kind kind, Vec3 place_mm, Vec3 along = Vec3(0.0)) { return {.kind = kind, .at_mm = place_mm, .along = along}; }

}  // namespace

std::vector<TargetHandle> handles_of_part(const Region& part) {
  const TargetHandle place = at(Kind::place, part.from_mm);
  switch (part.kind) {
    case RegionKind::half_space: return {place};
    case RegionKind::sphere: return {place, at(Kind::radius, part.from_mm + Vec3(part.radius_mm, 0, 0), {1, 0, 0})};
    case RegionKind::box:
    case RegionKind::ellipsoid: {
      const Axes axes = axes_of(part);
      if (!(glm::dot(axes.x, axes.x) + glm::dot(axes.z, axes.z) > 1.5)) return {place};  // a file's axes may span no box
      return {place, at(Kind::extent_x, part.from_mm + 0.5 * part.size_mm.x * axes.x, axes.x),
              at(Kind::extent_y, part.from_mm + 0.5 * part.size_mm.y * axes.y, axes.y),
              at(Kind::floor, part.from_mm - 0.5 * part.size_mm.z * axes.z, -axes.z)};
    }
    case RegionKind::cylinder:
    case RegionKind::cone:
    case RegionKind::capsule: {
      const Vec3 side = aside(part);
      std::vector<TargetHandle> out = {place, at(Kind::end, part.to_mm), at(Kind::radius, part.from_mm + part.radius_mm * side, side)};
      if (part.kind == RegionKind::cone) out.push_back(at(Kind::end_radius, part.to_mm + part.end_radius_mm * side, side));
      return out;
    }
    default: return {};
  }
}

Region moved_part(const Region& part, const TargetHandle& handle, Vec3 to_mm) {
  Region out = part;
  const auto from_middle = [&](Vec3 middle) { return std::abs(glm::dot(to_mm - middle, handle.along)); };
  const double further = glm::dot(to_mm - handle.at_mm, handle.along);
  switch (handle.kind) {
    case Kind::whole: return shifted(part, on_handle_step(to_mm - handle.at_mm));
    case Kind::rounding: out.rounding_mm = in_range("/target/rounding_mm", part.rounding_mm + further); break;
    case Kind::growth: out.by_mm = in_range("/target/by_mm", part.by_mm + further); break;
    case Kind::place: out.from_mm = on_handle_step(to_mm); break;
    case Kind::end: out.to_mm = on_handle_step(to_mm); break;
    case Kind::radius: out.radius_mm = least(from_middle(part.from_mm)); break;
    case Kind::end_radius: out.end_radius_mm = least(from_middle(part.to_mm)); break;
    case Kind::extent_x: out.size_mm.x = least(2 * from_middle(part.from_mm)); break;
    case Kind::extent_y: out.size_mm.y = least(2 * from_middle(part.from_mm)); break;
    case Kind::floor: {
      const Vec3 top = part.from_mm - 0.5 * part.size_mm.z * handle.along;
      out.size_mm.z = least(glm::dot(to_mm - top, handle.along));
      out.from_mm = top + 0.5 * out.size_mm.z * handle.along;
      break;
    }
    default: break;
  }
  return out;
}

}  // namespace cusp::ui
