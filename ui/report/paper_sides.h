/// Letters of a tooth's sides on its picture on paper. Thread: GUI, or any without a window.
#pragma once

#include "ui/modules.h"
#include "ui/widgets/paper.h"

namespace cusp::ui {

/// At the edges of a picture that is drawn from above (PresetView::occlusal). Nothing where `fdi` is no tooth's number.
void write_sides(Paper& paper, const QRectF& where, int fdi);

}  // namespace cusp::ui
