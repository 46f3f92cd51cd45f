/// Cusp's own drawings: 20 px grid, 1.6 stroke, round ends, one colour. Painted in the theme's ink at the moment of
/// painting, so that they follow light, dark and scale by themselves.
#pragma once

#include <QIcon>
#include <QPixmap>
#include <QStringList>

#include "ui/widgets/theme.h"

namespace cusp::ui {

enum class Ink { text, text2, text3, accent, on_accent, good, look, bad };
QColor colour_of(Ink ink, const Tokens& tokens = ui::tokens());

/// `name` is the file's in ui/widgets/icons, without its ending. An unknown name is a programmer's mistake (assert).
/// Directional drawings mirror in right-to-left.
QIcon icon(const QString& name, Ink ink = Ink::text);

/// One picture at `size` (px at 100 %).
QPixmap icon_pixmap(const QString& name, Ink ink, int size, double device_pixel_ratio = 1.0);

/// Every name there is.
QStringList icon_names();

}  // namespace cusp::ui
