/// Round burrs that can be put into an exercise, by US number. Diameters: ISO 6360 sizes of the US numbers.
#pragma once

#include <span>

#include "engine/tool/burr.h"

namespace cusp {

/// Rising diameter. Each has an FG shank and a neck that is thinner than its ball.
std::span<const Burr> round_burrs();

}  // namespace cusp
