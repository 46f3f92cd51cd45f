/// Vectors in double precision: a float has 4 bits too few for 0.1 µm in a tooth of 20 mm.
/// Frame: specimen, right-handed, x mesial, y buccal, z up (occlusal), millimetres, unless a name has another unit.
#pragma once

#include <cmath>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace cusp {

using Vec3 = glm::dvec3;
using Vec3f = glm::vec3;
using IVec3 = glm::ivec3;
using Quat = glm::dquat;

inline double length_of(Vec3 v) noexcept { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

}  // namespace cusp
