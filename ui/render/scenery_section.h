/// Scenery where a section's plane cuts it. Thread: the drawing one.
#pragma once

#include <vector>

#include "engine/volume/tissue.h"
#include "ui/modules.h"
#include "ui/render/scenery_look.h"
#include "ui/render/section.h"

namespace cusp::ui {

/// What a pixel of a section shows of the scenery.
struct SceneryPixel {
  Tissue tissue = Tissue::empty;  // empty: nothing there
  float edge = 0.0f;              // share of it that the line round a body covers
};

/// [y][x]; empty when the plane misses all of it. Each body has its skin to kSkinMm deep, and one tissue within: a surface
/// knows no more.
inline constexpr double kSkinMm = 0.9;
std::vector<SceneryPixel> scenery_in_section(const SceneryLook& scenery, const SectionSettings& settings);

}  // namespace cusp::ui
