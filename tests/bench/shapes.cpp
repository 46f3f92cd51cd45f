#include "tests/bench/shapes.h"

#include <algorithm>
#include <cmath>
#include <list>

#include "tests/bench/cut_shape.h"
#include "tests/bench/drilled_shape.h"
#include "tests/bench/profile_shapes.h"
#include "tests/bench/round_shapes.h"

namespace cusp::bench {

namespace {

constexpr double kBoxMm = 10.0;
constexpr double kPaddingVoxels = 4.0;

VoxelVolume sampled(const Shape& shape, double voxel_mm) {
  const double need = shape.half_mm() > 0.0 ? 2.0 * (shape.half_mm() / voxel_mm + kBandVoxels + kPaddingVoxels) : 0.0;
  const int n = static_cast<int>(std::ceil(std::max(kBoxMm / voxel_mm - 1e-9, need)));
  const Grid grid{IVec3(n), voxel_mm, Vec3(-(n - 1) * voxel_mm / 2.0)};
  VoxelVolume out(grid);
  if (shape.fills_grid()) {
    std::ranges::fill(out.s, kSolid);
    std::ranges::fill(out.tissue, Tissue::dentine);
    return out;
  }
  // The outermost four voxels stay empty: the shape is cut off at the padding's inner side, s = 1/2 half a voxel
  // before.
  const double half = (0.5 * n - kPaddingVoxels - kBandVoxels) * voxel_mm;
  IVec3 v;
  for (v.z = 0; v.z < n; ++v.z)
    for (v.y = 0; v.y < n; ++v.y)
      for (v.x = 0; v.x < n; ++v.x) {
        const Vec3 p = grid.centre_mm(v);
        const Vec3 beyond = glm::abs(p) - half;
        const Vec3 outside = glm::max(beyond, Vec3(0.0));
        const double box =
            std::sqrt(glm::dot(outside, outside)) + std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0);
        if (box >= kBandVoxels * voxel_mm) continue;
        const std::size_t i = grid.index(v);
        out.s[i] = solid_from_distance(std::max(shape.distance_mm(p), box) / voxel_mm);
        if (out.s[i] > 0) out.tissue[i] = shape.tissue(p);
      }
  return out;
}

struct Kept {
  std::string key;
  double voxel_mm;
  Reading reading;
  std::shared_ptr<const Specimen> specimen;
};
constexpr std::size_t kKept = 6;

}  // namespace

std::unique_ptr<Shape> make_shape(std::string_view name, double bur_radius_mm, std::string_view variant) {
  if (auto shape = make_round_shape(name, bur_radius_mm)) return shape;
  if (auto shape = make_profile_shape(name, bur_radius_mm)) return shape;
  if (name == "cut" && variant == "drilled") return make_drilled(bur_radius_mm);
  if (name == "cut") return make_cut(bur_radius_mm, variant == "crossing" ? CutKind::crossing : CutKind::single);
  if (name == "islet") return make_islet(bur_radius_mm);
  return nullptr;
}

std::shared_ptr<const Specimen> specimen_of(const Shape& shape, double voxel_mm, Reading reading) {
  static std::list<Kept> kept;
  for (auto k = kept.begin(); k != kept.end(); ++k)
    if (k->key == shape.key() && k->voxel_mm == voxel_mm && k->reading == reading) {
      kept.splice(kept.begin(), kept, k);
      return k->specimen;
    }
  kept.push_front({shape.key(), voxel_mm, reading, Specimen::build(sampled(shape, voxel_mm), reading)});
  if (kept.size() > kKept) kept.pop_back();
  return kept.front().specimen;
}

std::shared_ptr<Scene> scene_of(const Shape& shape, Method method, double voxel_mm) {
  auto scene = std::make_shared<Scene>();
  scene->method = method;
  scene->specimen = specimen_of(shape, voxel_mm, reading_of(method));
  for (const double radius : {shape.bur_radius_mm(), shape.cutter_radius_mm()}) {
    if (radius <= 0.0) continue;
    Bur bur;
    bur.name = "bench";
    bur.radius_mm = radius;
    bur.neck_radius_mm = 0.4 * radius;
    bur.neck_length_mm = 4.0 + radius;
    bur.shank_radius_mm = bur.neck_radius_mm;
    bur.shank_length_mm = 4.0;
    if (const std::optional<Profile> head = shape.cutter_head(); head && !scene->burs.empty()) bur.head = *head;
    scene->burs.push_back(bur);
  }
  scene->tool_axis = shape.tool_axis();
  for (TissueFeel& feel : scene->tissues) feel = {1.0, 1.0};
  scene->friction = false;
  scene->guard.ramp_in_ms = 0.0;
  scene->guard.limit_n = 1e6;
  scene->guard.slew_n_per_ms = 1e6;
  scene->guard.jump_mm = 1e6;
  return scene;
}

}  // namespace cusp::bench
