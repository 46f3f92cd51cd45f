#include "ui/render/turned_body.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace cusp::ui {

void add_body(std::vector<BodyVertex>& to, std::span<const BodyRing> rings, int around) {
  const auto at = [around](const BodyRing& ring, int i) {
    const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(i % around) / static_cast<float>(around);
    const float c = std::cos(a), s = std::sin(a);
    return BodyVertex{{ring.radius * c, ring.radius * s, ring.z}, {ring.nr * c, ring.nr * s, ring.nz}, ring.cutting};
  };
  for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
    for (int i = 0; i < around; ++i) {
      const BodyVertex a = at(rings[k], i), b = at(rings[k], i + 1), c = at(rings[k + 1], i + 1), d = at(rings[k + 1], i);
      if (rings[k].radius > 0) to.insert(to.end(), {a, b, c});
      to.insert(to.end(), {a, c, d});
    }
  }
}

glm::mat4 world_from_frame(Vec3 origin_mm, Vec3 x, Vec3 z) {
  const Vec3 y = glm::cross(z, x);
  return {glm::vec4(glm::vec3(x), 0), glm::vec4(glm::vec3(y), 0), glm::vec4(glm::vec3(z), 0), glm::vec4(glm::vec3(origin_mm), 1)};
}

glm::mat4 world_from_body(Vec3 origin_mm, Vec3 along) {
  const Vec3 z = glm::normalize(along);
  return world_from_frame(origin_mm, glm::normalize(glm::cross(std::abs(z.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0), z)), z);
}

}  // namespace cusp::ui
