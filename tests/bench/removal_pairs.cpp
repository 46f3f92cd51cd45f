#include "tests/bench/removal_pairs.h"

#include <algorithm>
#include <numeric>

#include "tests/random.h"

namespace cusp::bench {

using test::Random;

std::vector<std::vector<int>> all_pairs(std::span<const int> levels, std::uint64_t seed) {
  const std::size_t factors = levels.size();
  // Each value of the largest factor is met by a block of runs, as many as the next largest has values: in it every other
  // factor goes through its own values, in an order of its own.
  std::vector<std::size_t> by_size(factors);
  std::iota(by_size.begin(), by_size.end(), std::size_t{0});
  std::stable_sort(by_size.begin(), by_size.end(), [&](std::size_t a, std::size_t b) { return levels[a] > levels[b]; });
  const int block = factors > 1 ? levels[by_size[1]] : 1;
  Random random(seed);
  std::vector<std::vector<int>> runs;
  for (int i = 0; i < levels[by_size[0]]; ++i) {
    const std::size_t first = runs.size();
    for (int k = 0; k < block; ++k) {
      runs.emplace_back(factors, 0);
      runs.back()[by_size[0]] = i;
    }
    for (std::size_t f = 1; f < factors; ++f) {
      const int n = levels[by_size[f]];
      // Its values, then, where the block is longer, some of them again; shuffled.
      std::vector<int> order(static_cast<std::size_t>(block));
      const int turn = i % n;
      for (int k = 0; k < block; ++k) order[static_cast<std::size_t>(k)] = (k + turn) % n;
      for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random.bits() % k]);
      for (int k = 0; k < block; ++k) runs[first + static_cast<std::size_t>(k)][by_size[f]] = order[static_cast<std::size_t>(k)];
    }
  }
  // Pairs of the smaller factors that chance has left out.
  for (std::size_t a = 0; a < factors; ++a)
    for (std::size_t b = a + 1; b < factors; ++b)
      for (int x = 0; x < levels[a]; ++x)
        for (int y = 0; y < levels[b]; ++y) {
          if (std::ranges::any_of(runs, [&](const auto& r) { return r[a] == x && r[b] == y; })) continue;
          std::vector<int> run(factors);
          for (std::size_t f = 0; f < factors; ++f)
            run[f] = static_cast<int>(random.bits() % static_cast<std::uint64_t>(levels[f]));
          run[a] = x;
          run[b] = y;
          runs.push_back(std::move(run));
        }
  return runs;
}

}  // namespace cusp::bench
