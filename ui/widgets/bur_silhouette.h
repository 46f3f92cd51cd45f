/// Side view of a bur as a path: tip down, axis at x = 0, pivot at y = 0, y downwards. Pure functions.
#pragma once

#include <QPainterPath>

#include "engine/tool/bur.h"
#include "ui/modules.h"

namespace cusp::ui {

/// The cutting head alone, `scale` pixels a millimetre.
QPainterPath bur_head_path(const Bur& bur, double scale);

/// End of the head, mm along the axis from the pivot.
double bur_head_top_mm(const Bur& bur);

}  // namespace cusp::ui
