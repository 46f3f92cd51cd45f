/// Shapes with a closed-form proxy: plane, joint of two tissues, sphere, pit, cylinder, wall and inner corner.
#pragma once

#include <memory>
#include <string_view>

#include "tests/bench/shapes.h"

namespace cusp::bench {

/// nullptr for another name.
std::unique_ptr<Shape> make_round_shape(std::string_view name, double bur_radius_mm);

}  // namespace cusp::bench
