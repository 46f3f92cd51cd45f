/// All-pairs design: runs that contain every pair of values of any two factors. Their number is about the product of the
/// two largest factors. Deterministic.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cusp::bench {

/// [run][factor]: index of a value. levels: number of values of each factor, at least one.
std::vector<std::vector<int>> all_pairs(std::span<const int> levels, std::uint64_t seed = 1);

}  // namespace cusp::bench
