/// What a place of the surface looks like, but for the light and the eye: its colour by the tissue and by the depth of the
/// enamel, and its normal. The costly part of the picture, done once, when a patch changes. Thread: the volume's owner.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/mirror/surface_patches.h"
#include "ui/modules.h"
#include "ui/render/colours.h"
#include "ui/render/junction_depth.h"

namespace cusp::ui {

struct VertexLook {
  Vec3f position_mm{0.0f};     // drawn; a groove narrower than some voxels is filled by up to kMostFillVoxels
  Vec3f normal{0.0f, 0.0f, 1.0f};
  Vec3f colour{0.0f};          // linear light
  float enamel = 0.0f;         // share of enamel, 0 to 1
  float thin = 0.0f;           // how much light comes through from behind, 0 to 1
  float cut = 0.0f;            // 1 where a bur left the surface, less within a voxel of the margin
};
inline constexpr float kMostFillVoxels = 2.0f;

/// The voxels of the specimen, uncut, that the vertices of one patch read.
class LookWindow {
 public:
  LookWindow(const Specimen& specimen, int brick, int level);

  struct Around {
    float depth_mm = 0.0f;  // of the enamel
    float ridge = 0.0f;     // how much less than half of the neighbourhood is solid, 0 to 0.5
  };
  VertexLook look(const PatchVertex& vertex, const Around& around) const;

 private:
  struct Kernel;
  struct Sums {
    float solid = 0.0f;
    Vec3f gradient{0.0f};                        // of solid, 1/voxel
    std::array<float, kTissueCodes> tissue{};  // weights; sum 1 but for empty voxels
  };
  void read_brick(IVec3 brick);
  Sums sums_at(Vec3f voxel) const noexcept;

  const Specimen& specimen_;
  IVec3 corner_{0};
  int size_ = 0;
  bool mixed_ = false;                // more than one tissue within
  Tissue only_ = Tissue::empty;
  std::vector<float> solid_;          // [x + size (y + size z)], 0 to 1
  std::vector<Tissue> tissue_;        // as solid_
};

/// Colour of enamel over dentine, linear light.
Vec3f enamel_colour(float depth_mm) noexcept;
/// What settles in a fissure of whole enamel. `groove`: 0 to 1.
void stain(VertexLook& look, float groove) noexcept;
/// Enamel where light comes through from behind, by how much of it does, 0 to 1.
Vec3f ridge_colour(Vec3f enamel, float thin) noexcept;
/// The body's colour of a tissue, linear light. `at_mm`: gums vary from place to place.
Vec3f body_colour(Tissue tissue, Vec3f at_mm) noexcept;
/// Smooth noise of a wavelength, -1 to 1.
float noise(Vec3f at_mm, float wavelength_mm) noexcept;

}  // namespace cusp::ui
