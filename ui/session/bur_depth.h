/// How deep the bur stands: the one place that computes it for gauge, coach and report. Pure; any thread.
#pragma once

#include <algorithm>
#include <optional>

#include "engine/scene/scene.h"
#include "engine/step/step.h"
#include "engine/tool/swept.h"
#include "scenarios/shapes/target.h"
#include "ui/modules.h"

namespace cusp::ui {

/// Lowest point of the bur's head below the target's reference plane, mm; negative above the plane.
inline double bur_depth_mm(const TargetShape& target, const StepOutput& output, const Bur& bur) noexcept {
  return target.top_mm() - (output.proxy_mm.z + head_furthest(bur, output.axis, {0.0, 0.0, -1.0}).z);
}

/// Height of the target's floor under a place, mm; of an upright outline its one floor. nullopt beside the target.
inline std::optional<double> floor_under_mm(const TargetShape& target, Vec2 at) noexcept {
  constexpr double kStepMm = 0.05;  // the finest voxels of a tooth
  if (target.upright() != nullptr) return target.floor_mm();
  for (double z = target.floor_mm(); z < target.top_mm();) {
    const double outside = target.distance_mm({at.x, at.y, z});
    if (outside < 0.0) return z;
    z += std::max(outside, kStepMm);
  }
  return std::nullopt;
}

/// Distance in plan from the target's wall, negative inside, at half the depth of the floor under the place.
inline double wall_mm(const TargetShape& target, Vec2 at) noexcept {
  const auto floor_mm = target.upright() == nullptr ? floor_under_mm(target, at) : std::nullopt;
  return floor_mm ? target.distance_mm({at.x, at.y, 0.5 * (*floor_mm + target.top_mm())}) : target.outline_mm(at);
}

}  // namespace cusp::ui
