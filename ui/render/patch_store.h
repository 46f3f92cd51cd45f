/// The drawing side's copy of the mesh: answers what a ray meets. Thread: the drawing one.
#pragma once

#include <optional>
#include <unordered_map>

#include "ui/render/baked_patch.h"
#include "ui/render/camera.h"
#include "ui/render/patch_feed.h"

namespace cusp::ui {

struct PickedPoint {
  Vec3 at_mm{0.0};
  Vec3 normal{0.0, 0.0, 1.0};
  double distance_mm = 0.0;  // from the ray's start
  Tissue tissue = Tissue::empty;
  float value = 0.0f;
};

class PatchStore {
 public:
  void put(BakedPatch patch);
  void clear() { patches_.clear(); }
  bool empty() const noexcept { return patches_.empty(); }
  const std::unordered_map<int, BakedPatch>& patches() const noexcept { return patches_; }
  /// First front face that the ray meets.
  std::optional<PickedPoint> pick(const Ray& ray) const;
  /// Nothing of the mesh lies between the place and the eye. A place up to kSurfaceMm below a surface counts as on it.
  bool shows(Vec3 place_mm, Vec3 eye_mm) const;
  static constexpr double kSurfaceMm = 0.25;  // three voxels of 0.08: a measure's place may be a voxel's centre
  /// Box of everything; nullopt when empty.
  std::optional<Box> bounds() const;
  std::size_t triangles() const noexcept;

 private:
  std::unordered_map<int, BakedPatch> patches_;  // [brick]
};

}  // namespace cusp::ui
