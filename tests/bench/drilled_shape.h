/// A face with a hole that a straight fissure has drilled at right angles, felt by a ball: its rim is a circle that a head has
/// cut, so that contact knows it by its field alone.
#pragma once

#include <memory>

#include "tests/bench/shapes.h"

namespace cusp::bench {

/// The hole is 1.5 bur radii in radius and depth. A slide goes about the rim, a press into the wall.
std::unique_ptr<Shape> make_drilled(double bur_radius_mm);

}  // namespace cusp::bench
