#include "tests/bench/tick_times.h"

#include <algorithm>

namespace cusp::bench {

double percentile(std::vector<double>& values, double share) {
  std::sort(values.begin(), values.end());
  const double place = std::ceil(share * static_cast<double>(values.size())) - 1.0;
  return values[static_cast<std::size_t>(std::max(0.0, place))];
}

double TickTimes::sum_s() const {
  double sum = 0.0;
  for (const float us : us_) sum += static_cast<double>(us);
  return sum * 1e-6;
}

void TickTimes::fill(Row& row) const {
  if (us_.empty()) return;
  std::vector<double> us(us_.begin(), us_.end());
  row.updates_per_s = static_cast<double>(us.size()) / sum_s();
  std::sort(us.begin(), us.end());
  const auto at = [&us](double share) {
    const double place = std::ceil(share * static_cast<double>(us.size())) - 1.0;
    return us[static_cast<std::size_t>(std::max(0.0, place))];
  };
  row.tick_us_p50 = at(0.5);
  row.tick_us_p99 = at(0.99);
  row.tick_us_p999 = at(0.999);
  row.tick_us_p9999 = at(0.9999);
  row.tick_us_max = us.back();
}

}  // namespace cusp::bench
