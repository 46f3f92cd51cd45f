/// How deep the bur stands: the one place that computes it for gauge, coach and report. Pure; any thread.
#pragma once

#include "engine/scene/scene.h"
#include "engine/step/step.h"
#include "scenarios/shapes/target.h"
#include "ui/modules.h"

namespace cusp::ui {

/// Lowest point of the bur's head below the target's reference plane, mm; negative above the plane.
inline double bur_depth_mm(const TargetShape& target, const StepOutput& output, const Bur& bur) noexcept {
  return target.top_mm() - (output.proxy_mm.z - bur.radius_mm);
}

}  // namespace cusp::ui
