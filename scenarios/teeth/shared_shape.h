/// A tooth's fields take a fifth of a second to fit: who asks for the same shares them, while someone has them or they are of
/// the last kKeptShapes. So a template's preview and a grade fit the tooth once, and a jaw its left and right average teeth.
#pragma once

#include <cstdint>
#include <memory>

#include "scenarios/teeth/shape.h"

namespace cusp::scenarios {

inline constexpr std::size_t kKeptShapes = 4;  // a tooth, its two neighbours and the one before; 1 to 3 MB each

/// ToothShape(table, seed, voxel_mm). `table` must be of table_for. Any thread; waits while another thread fits the same.
std::shared_ptr<const ToothShape> shared_shape(const ToothTable& table, std::uint64_t seed, double voxel_mm);

}  // namespace cusp::scenarios
