/// k_max of a cell and of the exact proxy, with more seeds if five do not settle the ratio.
///
/// Near the limit the net energy of a window crosses its bound of 0.01 mJ several times, so k_max depends on the seeds:
/// the exact proxy's own k_max spreads by 13 to 29 % over five sets. If the ratio of the first set differs from 1 by more
/// than kSettledShare, both are found again with kMostSets sets of five seeds by KMaxSearch::every_place, and the medians
/// count. The rule is the same for every cell and depends on the first set alone.
#pragma once

#include <functional>
#include <vector>

#include "tests/bench/stability_kmax.h"

namespace cusp::bench {

inline constexpr double kSettledShare = 0.10;  // of the exact proxy's k_max
inline constexpr int kMostSets = 5;            // odd: the median is one of them

/// Result of one set of seeds.
struct KMaxPair {
  KMax own, exact;
};

/// k_max over several sets, N/mm.
struct KMaxSpread {
  double median = 0.0, first = 0.0, least = 0.0, most = 0.0;
};

struct KMaxSets {
  int sets = 1;
  KMax own;  // of the median set
  KMaxSpread own_spread, exact_spread;
};

/// Pre: an odd number of values.
KMaxSpread spread_of(const std::vector<double>& values);

/// True if the first set is not enough. With the guard on a larger k_max is expected; only a smaller one is unsettled.
bool unsettled(GuardUse guard, double own_n_per_mm, double exact_n_per_mm);

/// first: by spot checks. nth(i): set i by every place; set 0 has the seeds of the first. most_sets: odd number of sets of
/// an unsettled cell; 1: the first result counts.
KMaxSets settle(GuardUse guard, const KMaxPair& first, int most_sets, const std::function<KMaxPair(int)>& nth);

}  // namespace cusp::bench
