/// A tooth's fields take a fifth of a second to fit: who asks for the same while someone still has them shares them. So a
/// jaw's left and right average teeth are fitted once, and those that its voxels and its scenery both need.
#pragma once

#include <cstdint>
#include <memory>

#include "scenarios/teeth/shape.h"

namespace cusp::scenarios {

/// ToothShape(table, seed, voxel_mm). `table` must be of table_for. Any thread; waits while another thread fits the same.
std::shared_ptr<const ToothShape> shared_shape(const ToothTable& table, std::uint64_t seed, double voxel_mm);

}  // namespace cusp::scenarios
