/// k_max of a cell beside the exact proxy's, with more seeds where five are too few to compare them.
///
/// Five seeds leave k_max itself uncertain where the net energy of a window goes up and down about its bound
/// (README.md, "How fine k_max is"). Where the first set gives a ratio that is off by more than kSettledShare, both are
/// found anew with kMostSets sets of five seeds, at every place of the grid as the definition has it, and the cell's
/// figures are the medians of the sets. The rule is the same for every cell, and looks at the first set alone.
#pragma once

#include <functional>
#include <vector>

#include "tests/bench/stability_kmax.h"

namespace cusp::bench {

inline constexpr double kSettledShare = 0.10;  // of the exact proxy's k_max
inline constexpr int kMostSets = 5;            // odd: the median is one of them

/// Of one set of seeds.
struct KMaxPair {
  KMax own, exact;
};

/// What several sets came to, N/mm.
struct KMaxSpread {
  double median = 0.0, first = 0.0, least = 0.0, most = 0.0;
};

struct KMaxSets {
  int sets = 1;
  KMax own;  // of the set that is the median
  KMaxSpread own_spread, exact_spread;
};

/// Pre: values are there, an odd number of them.
KMaxSpread spread_of(const std::vector<double>& values);

/// True when a first set is not enough. guard: a method behind its guard is there to bear more; only less is off.
bool unsettled(GuardUse guard, double own_n_per_mm, double exact_n_per_mm);

/// first: as quickly found. nth(i): of set i, from 0 (the first set's seeds again), place by place. most_sets: how many
/// sets an unsettled cell takes, odd; 1: the first one stands.
KMaxSets settle(GuardUse guard, const KMaxPair& first, int most_sets, const std::function<KMaxPair(int)>& nth);

}  // namespace cusp::bench
