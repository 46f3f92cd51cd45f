/// Names of burs: the shape, and which one it is. Needs no window.
#pragma once

#include <QString>
#include <string_view>

#include "engine/tool/bur.h"
#include "ui/modules.h"

namespace cusp::ui {

/// "Straight fissure" for a key of scenarios/burs; "Own shape" for a head of no catalogue.
QString bur_shape_name(std::string_view shape);
/// "straight fissure", to stand within a line.
QString bur_shape_word(std::string_view shape);
/// "1.0 mm".
QString bur_diameter_text(const Bur& bur);
/// "57, straight fissure, 1.0 mm".
QString bur_text(const Bur& bur);
/// "Undercuts, flattening": what it is for; empty for a bur of no catalogue.
QString bur_uses_text(const Bur& bur);

}  // namespace cusp::ui
