/// A bur's outline as seen from the side, to scale: tip down, its axis upright at x = 0, the pivot at y = 0; y downwards.
#pragma once

#include <QPainterPath>

#include "engine/tool/bur.h"
#include "ui/modules.h"

namespace cusp::ui {

/// The cutting head alone, `scale` pixels a millimetre.
QPainterPath bur_head_path(const Bur& bur, double scale);

/// From the pivot, mm along the axis: where the head ends.
double bur_head_top_mm(const Bur& bur);

}  // namespace cusp::ui
