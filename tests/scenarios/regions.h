// Regions of the plain shapes, for tests. Millimetres.
#pragma once

#include <utility>
#include <vector>

#include "scenarios/format/region.h"
#include "tests/modules.h"

namespace cusp::test {

inline Region box_region(Vec3 centre, Vec3 size) {
  Region out;
  out.kind = RegionKind::box;
  out.from_mm = centre;
  out.size_mm = size;
  return out;
}
inline Region along(RegionKind kind, Vec3 from, Vec3 to, double radius, double end_radius = 0) {
  Region out;
  out.kind = kind;
  out.from_mm = from;
  out.to_mm = to;
  out.radius_mm = radius;
  out.end_radius_mm = end_radius;
  return out;
}
inline Region sphere(Vec3 centre, double radius) { return along(RegionKind::sphere, centre, Vec3(0), radius); }
inline Region half_space(Vec3 at, Vec3 out_of_it) {
  Region out;
  out.kind = RegionKind::half_space;
  out.from_mm = at;
  out.z_axis = out_of_it;
  return out;
}
/// amount: of an offset its distance, else the rounding.
inline Region node(RegionKind kind, std::vector<Region> parts, double amount = 0) {
  Region out;
  out.kind = kind;
  out.parts = std::move(parts);
  (kind == RegionKind::offset ? out.by_mm : out.rounding_mm) = amount;
  return out;
}

}  // namespace cusp::test
