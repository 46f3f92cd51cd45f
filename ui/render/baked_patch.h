/// A patch as the graphics memory takes it: packed vertices with the costly shading (colour, ambient light) computed
/// once, when the patch changes, not per pixel. Thread: whichever owns the volume; the result is a plain value.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/mirror/surface_patches.h"
#include "scenarios/metrics/deviation.h"
#include "ui/modules.h"
#include "ui/render/solid_shares.h"
#include "ui/render/vertex_look.h"

namespace cusp::ui {

struct PackedVertex {
  float position_mm[3];
  std::int16_t normal[4];  // unit in 1/32767; the fourth: light that comes through a thin ridge, of 32767
  std::uint8_t tissue;
  std::uint8_t cut;        // 255 where a bur left the surface, less at its margin, else 0
  std::uint8_t ambient;    // light that reaches the place from around, 0 to 255
  std::uint8_t beyond;     // 255 where the cut lies beyond the leeway, else 0
  float value;             // mm from the target: above 0 over-cut, below 0 uncut remainder
  std::uint8_t colour[3];  // square root of linear light, 0 to 255
  std::uint8_t enamel;     // its share, 0 to 255
};
static_assert(sizeof(PackedVertex) == 32);

struct BakedPatch {
  int brick = -1;
  int level = kFinePatch;
  std::vector<PackedVertex> vertices;
  std::vector<std::uint16_t> indices;  // triangles; empty: the brick shows nothing (any more)
  Vec3f low_mm{0.0f}, high_mm{0.0f};   // box of the vertices
  Vec3f cone_axis{0.0f, 0.0f, 1.0f};   // every normal lies within acos(cone_cos) of it
  float cone_cos = -1.0f;
  std::uint64_t tick = 0;              // state of the session that it shows; 0 outside a session

  std::size_t bytes() const noexcept {
    return vertices.size() * sizeof(PackedVertex) + indices.size() * sizeof(std::uint16_t);
  }
};

/// How a place of the surface stands to the target.
struct Deviation {
  float mm = 0.0f;      // above 0 over-cut, below 0 uncut remainder, 0 where nothing was to be done
  bool beyond = false;  // cut further than the leeway allows
};
using DeviationAt = std::function<Deviation(Vec3 mm, SurfaceKind kind)>;

/// What a patch needs to know of more than its own voxels.
struct PatchSurroundings {
  SolidShares shares;   // of the volume as it stands
  JunctionDepth depth;  // of its specimen
};

/// Packs a patch. Of the triangles under its neighbours those stay that reach a
/// brick for which `is_fine` is true (empty: none stay). `deviation` may be empty.
BakedPatch bake_patch(const Volume& volume, const PatchSurroundings& around, const Patch& patch,
                      const std::function<bool(int brick)>& is_fine, const DeviationAt& deviation);

/// Writes what a vertex looks like; position, normal, colour, enamel, cut.
void put_look(const VertexLook& look, PackedVertex& out) noexcept;

}  // namespace cusp::ui
