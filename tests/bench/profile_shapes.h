/// Extruded shapes: outer edge of 90 degrees, groove of 60 degrees, step of 0.5 mm, rim of the volume, narrow slot.
#pragma once

#include <memory>
#include <string_view>

#include "tests/bench/shapes.h"

namespace cusp::bench {

/// nullptr for another name.
std::unique_ptr<Shape> make_profile_shape(std::string_view name, double bur_radius_mm);

}  // namespace cusp::bench
