/// A burr's outline as seen from the side, to scale: tip down, its axis upright at x = 0, the pivot at y = 0; y downwards.
#pragma once

#include <QPainterPath>

#include "engine/tool/burr.h"

namespace cusp {

/// The cutting head alone, `scale` pixels a millimetre.
QPainterPath burr_head_path(const Burr& burr, double scale);

/// From the pivot, mm along the axis: where the head ends.
double burr_head_top_mm(const Burr& burr);

}  // namespace cusp
