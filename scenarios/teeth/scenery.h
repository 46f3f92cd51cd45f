/// Teeth and gums that no bur can reach, as a visible surface: no voxels, a few thousand triangles each.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/volume/tissue.h"
#include "scenarios/modules.h"
#include "scenarios/teeth/body.h"

namespace cusp::scenarios {

/// Triangles that face outwards and close a body. Any thread.
struct SceneryMesh {
  std::vector<glm::vec3> points_mm, normals;  // per point; normals are unit and point outwards
  std::vector<Tissue> tissue;                 // per point
  std::vector<std::uint8_t> ambient;          // per point: light from around, 0 to 255
  std::vector<std::uint32_t> triangles;       // three indices each
  std::size_t seen = 0;                       // of the indices: those that lie open; the rest is within other bodies
  Tissue within = Tissue::dentine;            // what a section through it shows
  std::size_t bytes() const noexcept {
    return points_mm.size() * (2 * sizeof(glm::vec3) + sizeof(Tissue) + sizeof(std::uint8_t)) +
           triangles.size() * sizeof(std::uint32_t);
  }
};

/// Turned round in x, still facing outwards.
void mirror(SceneryMesh& mesh) noexcept;

/// One point in each cell of `step_mm` that the surface crosses, drawn onto the surface. All of it lies open.
SceneryMesh mesh_of(const Body& body, double step_mm);

/// Triangles whose corners are all nearer than `margin_mm` to a body, or within it, no longer lie open.
void cover(SceneryMesh& mesh, const Body& by, double margin_mm);

/// Moves the edge between the visible and the covered part `under_mm` below the covering body's surface, so that no gap
/// shows between the two.
void tuck_in(SceneryMesh& mesh, const Body& under, double under_mm);

}  // namespace cusp::scenarios
