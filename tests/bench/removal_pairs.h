/// Runs that together hold every pair of values of any two factors: as many as the two largest factors ask for, instead of
/// the whole product. The same everywhere.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cusp::bench {

/// [run][factor]: which value. levels: how many values each factor has, at least one. Rows are filled where a factor's
/// values are used up; every pair is in at least one of them.
std::vector<std::vector<int>> all_pairs(std::span<const int> levels, std::uint64_t seed = 1);

}  // namespace cusp::bench
