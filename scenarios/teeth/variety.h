/// What a seed changes in a tooth's table, besides the lengths and the bending that ToothShape sees to: how high each cusp
/// stands, and whether the cusp of Carabelli is there. How often and how much: [M].
#pragma once

#include <cstdint>

#include "scenarios/teeth/tables.h"

namespace cusp::scenarios {

/// Seed 0 changes nothing.
ToothTable varied_table(ToothTable table, std::uint64_t seed);

}  // namespace cusp::scenarios
