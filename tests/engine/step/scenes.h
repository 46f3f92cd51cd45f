/// Analytic specimens and inputs for the tests of the step.
#pragma once

#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>

#include "engine/step/step.h"
#include "engine/volume/surface_cells.h"
#include "engine/tool/voxel_tool.h"
#include "tests/modules.h"

namespace cusp::test {

inline constexpr double kPaperVoxelMm = 10.0 / 128;  // the paper's

/// `value`; 0 under CUSP_TOLERANCE_ZERO=1, which prints the residuals by failing every bound.
inline double bound(double value) { return std::getenv("CUSP_TOLERANCE_ZERO") ? 0.0 : value; }

/// A cube of voxels about the origin, `edge_mm` wide with 4 voxels of padding, filled from a signed distance (mm).
inline VoxelVolume from_distance(double edge_mm, double voxel_mm, const std::function<double(Vec3)>& distance_mm,
                                 const std::function<Tissue(Vec3)>& tissue = [](Vec3) { return Tissue::dentine; }) {
  const int n = static_cast<int>(std::ceil(edge_mm / voxel_mm)) + 8;
  Grid grid{IVec3(n), voxel_mm, Vec3(-(n - 1) * voxel_mm / 2.0)};
  VoxelVolume out(grid);
  IVec3 v;
  for (v.z = 0; v.z < n; ++v.z)
    for (v.y = 0; v.y < n; ++v.y)
      for (v.x = 0; v.x < n; ++v.x) {
        const Vec3 p = grid.centre_mm(v);
        const std::size_t i = grid.index(v);
        out.s[i] = solid_from_distance(distance_mm(p) / voxel_mm);
        if (out.s[i] > 0) out.tissue[i] = tissue(p);
      }
  return out;
}

inline double length(Vec3 v) { return std::sqrt(glm::dot(v, v)); }

inline double box_distance(Vec3 p, Vec3 half) {
  const Vec3 q = glm::abs(p) - half;
  const Vec3 m = glm::max(q, Vec3(0.0));
  return length(m) + std::min(std::max(q.x, std::max(q.y, q.z)), 0.0);
}

/// A cube 4 mm wide.
inline VoxelVolume block_of(double voxel_mm) {
  return from_distance(4.0, voxel_mm, [](Vec3 p) { return box_distance(p, Vec3(2.0)); });
}

/// A scene with one ball bur, every tissue at the same stiffness (1 N/mm) and speed, and a guard that
/// bounds nothing unless a test asks for it.
inline std::shared_ptr<Scene> scene_of(const VoxelVolume& volume, Method method, double radius_mm,
                                       double speed_mm_s = 1.0) {
  auto scene = std::make_shared<Scene>();
  scene->method = method;
  scene->specimen = Specimen::build(volume, reading_of(method));
  Bur bur;
  bur.name = "test";
  bur.radius_mm = radius_mm;
  bur.neck_radius_mm = 0.6 * radius_mm;
  scene->burs = {bur};
  for (TissueFeel& feel : scene->tissues) feel = {1.0, speed_mm_s};
  scene->full_force_n = 0.3;
  scene->guard.ramp_in_ms = 0.0;
  scene->guard.limit_n = 100.0;
  scene->guard.slew_n_per_ms = 100.0;
  return scene;
}

enum class CutButton : std::uint8_t { up, pressed };

inline StepInput input_at(Vec3 device_mm, CutButton button = CutButton::up, std::uint32_t elapsed_us = 1000) {
  Sample sample;
  sample.status = Sample::Status::fresh;
  sample.position_mm = device_mm;
  sample.buttons = button == CutButton::pressed ? StepInput::kCut : std::uint16_t{0};
  return quantise(sample, elapsed_us, StepInput{});
}

/// From `above` straight to `to` in steps of 20 um, without cutting.
inline StepOutput approach(StepState& state, Vec3 above, Vec3 to) {
  StepOutput out;
  const int steps = static_cast<int>(length(to - above) / 0.02) + 1;
  for (int i = 0; i <= steps; ++i) out = step(state, input_at(above + (to - above) * (static_cast<double>(i) / steps)));
  return out;
}

}  // namespace cusp::test
