/// Measurements of preparations carved by analysis, counted against the truth: tests of scenarios/metrics/groups.h.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/format/keys.h"
#include "scenarios/metrics/measure.h"
#include "tests/full_run.h"
#include "tests/modules.h"

namespace cusp::test {

inline std::vector<double> known_voxels() { return full_run() ? std::vector<double>{0.05, 0.078, 0.1} : std::vector<double>{0.1}; }

/// All cases of one measurement at one voxel.
struct KnownRow {
  int cases = 0, within = 0, unmeasured = 0;
  double worst = 0, uncertainty = 0;  // largest error, largest stated uncertainty
  std::string unit;
};
using KnownRows = std::map<std::string, KnownRow>;

/// Measures what the truth names, and counts.
inline void count_case(const Reference& reference, const Volume& volume, const std::map<std::string, double>& truth, KnownRows& rows) {
  const std::vector<Measure> all = measure(reference, volume, {});
  for (const auto& [metric, value] : truth) {
    KnownRow& row = rows[metric];
    ++row.cases;
    const auto m = std::ranges::find(all, metric, &Measure::metric);
    ASSERT_NE(m, all.end()) << metric;
    row.unit = m->unit;
    if (!m->measured) {
      ++row.unmeasured;
      continue;
    }
    const double error = std::fabs(m->value - value);
    row.within += error <= m->uncertainty;
    row.worst = std::max(row.worst, error);
    row.uncertainty = std::max(row.uncertainty, m->uncertainty);
    if (std::getenv("CUSP_CASES") != nullptr) std::printf("%s %.4f truth %.4f +- %.4f\n", metric.c_str(), m->value, value, m->uncertainty);
  }
}

/// Issue 22, "Must show" 1: within the stated uncertainty in at least 93 % of the cases pooled and 85 % of each measurement.
inline void expect_known(double voxel_mm, const KnownRows& rows) {
  int all = 0, within = 0;
  for (const auto& [metric, row] : rows) {
    std::printf("| %.3f | %s | %d | %.1f %% | %.4f %s | %.4f %s |\n", voxel_mm, metric.c_str(), row.cases, 100.0 * row.within / row.cases,
                row.worst, row.unit.c_str(), row.uncertainty, row.unit.c_str());
    EXPECT_EQ(row.unmeasured, 0) << metric;
    EXPECT_GE(row.within, 0.85 * row.cases) << metric;
    all += row.cases;
    within += row.within;
  }
  EXPECT_GE(within, 0.93 * all) << within << " of " << all;
}

/// A rubric that asks for every measurement.
inline Rubric whole_rubric() {
  Rubric out;
  for (const MetricKey& key : kMetricKeys) out.criteria.push_back({std::string(key.key), 1, {}});
  return out;
}

/// One that asks for these alone.
inline Rubric rubric_of(const std::map<std::string, double>& truth) {
  Rubric out;
  for (const auto& [metric, value] : truth) out.criteria.push_back({metric, 1, {}});
  return out;
}

/// One seed for each kind of preparation; printed where a test fails.
struct Draw {
  std::mt19937_64 random;
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
};

}  // namespace cusp::test
