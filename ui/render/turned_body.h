/// Bodies of revolution: bur, and the mount and handle of a mirror. Frame of a body: z along its axis, millimetres.
/// Thread: any.
#pragma once

#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::ui {

struct BodyVertex {
  Vec3f position_mm;
  Vec3f normal;
  float cutting;  // 1 on a bur's head, else 0
};

/// A circle of the outline with its normal (along z, outwards).
struct BodyRing {
  float z, radius;
  float nz, nr;
  float cutting = 0.0f;
};

/// Triangles between consecutive rings, counter-clockwise seen from outside; `around` sides.
void add_body(std::vector<BodyVertex>& to, std::span<const BodyRing> rings, int around);

/// Puts a body's origin at a place, its x and z axes along directions. x, z: unit, at right angles.
glm::mat4 world_from_frame(Vec3 origin_mm, Vec3 x, Vec3 z);
/// Puts a body's origin at a place and its z axis along a direction.
glm::mat4 world_from_body(Vec3 origin_mm, Vec3 along);

}  // namespace cusp::ui
