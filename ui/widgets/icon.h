/// The icons of icons/: 20 px grid, 1.6 stroke, round ends, one colour. The engine tints them at each paint, so a change of
/// theme or scale needs no new icon. Thread: GUI.
#pragma once

#include <QIcon>
#include <QPixmap>

#include "ui/widgets/theme.h"

namespace cusp::ui {

enum class Ink { text, text2, text3, accent, on_accent, good, look, bad };
QColor colour_of(Ink ink, const Tokens& tokens = ui::tokens());

/// `name`: of the file in ui/widgets/icons, without .svg; an unknown one asserts. Directional icons mirror in right-to-left.
QIcon icon(const QString& name, Ink ink = Ink::text);

/// One picture at `size` (px at 100 %).
QPixmap icon_pixmap(const QString& name, Ink ink, int size, double device_pixel_ratio = 1.0);

}  // namespace cusp::ui
