#include "tests/bench/stability_sets.h"

#include <algorithm>
#include <cmath>

namespace cusp::bench {

KMaxSpread spread_of(const std::vector<double>& values) {
  std::vector<double> sorted = values;
  std::ranges::sort(sorted);
  return {sorted[sorted.size() / 2], values.front(), sorted.front(), sorted.back()};
}

bool unsettled(GuardUse guard, double own, double exact) {
  if (guard == GuardUse::on && own > exact) return false;
  return std::fabs(own - exact) > kSettledShare * exact;
}

KMaxSets settle(GuardUse guard, const KMaxPair& first, int most_sets, const std::function<KMaxPair(int)>& nth) {
  KMaxSets out;
  std::vector<KMax> own{first.own};
  std::vector<double> own_k{first.own.k_max_n_per_mm}, exact_k{first.exact.k_max_n_per_mm};
  if (most_sets > 1 && unsettled(guard, own_k[0], exact_k[0])) {
    out.sets = most_sets;
    own.clear();
    own_k.clear();
    exact_k.clear();
    for (int i = 0; i < most_sets; ++i) {
      const KMaxPair set = nth(i);
      own.push_back(set.own);
      own_k.push_back(set.own.k_max_n_per_mm);
      exact_k.push_back(set.exact.k_max_n_per_mm);
    }
  }
  out.own_spread = spread_of(own_k);
  out.exact_spread = spread_of(exact_k);
  out.own = *std::ranges::find(own, out.own_spread.median, &KMax::k_max_n_per_mm);
  return out;
}

}  // namespace cusp::bench
