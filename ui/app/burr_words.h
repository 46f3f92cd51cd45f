/// Burrs in words: the shape, and which one it is. Needs no window.
#pragma once

#include <QString>
#include <string_view>

#include "engine/tool/burr.h"

namespace cusp {

/// "Straight fissure" for a key of scenarios/burrs; "Own shape" for a head of no catalogue.
QString burr_shape_name(std::string_view shape);
/// "straight fissure", to stand within a line.
QString burr_shape_word(std::string_view shape);
/// "1.0 mm".
QString burr_diameter_text(const Burr& burr);
/// "57, straight fissure, 1.0 mm".
QString burr_text(const Burr& burr);
/// "Undercuts, flattening": what it is for; empty for a burr of no catalogue.
QString burr_uses_text(const Burr& burr);

}  // namespace cusp
