/// Measurements of preparations carved by analysis, counted against the truth.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/format/keys.h"
#include "scenarios/metrics/groups.h"
#include "scenarios/metrics/measure.h"
#include "tests/full_run.h"
#include "tests/modules.h"

namespace cusp::test {

inline std::vector<double> known_voxels() { return full_run() ? std::vector<double>{0.05, 0.078, 0.1} : std::vector<double>{0.1}; }

/// Cases at a voxel size: `few` by default, `all` at 0.1 mm of a whole run and half as many where a voxel costs more.
inline int known_cases(double voxel_mm, int few, int all) { return !full_run() ? few : voxel_mm < 0.1 ? (all + 1) / 2 : all; }

/// All cases of one measurement at one voxel.
struct KnownRow {
  int cases = 0, within = 0, unmeasured = 0;
  double worst = 0, uncertainty = 0, sum = 0;  // largest error, largest stated uncertainty, sum of those
  std::string unit;
};
using KnownRows = std::map<std::string, KnownRow>;

/// Counts those that the truth names.
inline void count_case(const std::vector<Measure>& all, const std::map<std::string, double>& truth, KnownRows& rows) {
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
    constexpr double kRounding = 1e-9;  // of sums that a whole cut makes equal
    row.within += error <= m->uncertainty + kRounding;
    row.worst = std::max(row.worst, error);
    row.uncertainty = std::max(row.uncertainty, m->uncertainty);
    row.sum += m->uncertainty;
    if (std::getenv("CUSP_CASES") != nullptr)
      std::printf("%s %.4f truth %.4f +- %.4f%s\n", metric.c_str(), m->value, value, m->uncertainty, error <= m->uncertainty ? "" : " OUT");
  }
}

/// Measures the groups of groups.h alone, and counts.
inline void count_groups(const Reference& reference, const Volume& volume, const std::map<std::string, double>& truth, KnownRows& rows) {
  std::vector<Measure> all;
  add_groups(CutFaces(reference, volume, floor_depth(reference, volume)), margin_points(volume), reference, volume, all);
  count_case(all, truth, rows);
}

/// Issue 22, "Must show" 1: the greatest uncertainty at voxels of 0.078 mm; none for volumes. A border of tissues is known to 0.6 voxel.
inline std::optional<double> greatest_uncertainty(const std::string& metric, const std::string& unit) {
  if (unit == "deg") return 1.0;
  if (unit == "%") return 0.5;
  if (unit != "mm") return std::nullopt;
  const bool border = metric.starts_with("axial_past_junction") || metric.starts_with("clearance_") || metric == "remaining_over_pulp";
  return border ? 0.6 * 0.078 + 1e-9 : 0.02;
}

/// Rows by voxel size of one kind of specimen.
class KnownTable {
 public:
  explicit KnownTable(std::string where) : where_(std::move(where)) {}
  KnownRows& rows(double voxel_mm) { return rows_[voxel_mm]; }

  /// Issue 22, "Must show" 1: within the stated uncertainty in at least 93 % of the cases pooled and 85 % of each measurement, that
  /// uncertainty no greater than asked and halving with the voxel, but of those measurements that are `less_sure`.
  void expect(std::uint64_t seed, const std::set<std::string>& less_sure = {}) const {
    for (const auto& [voxel_mm, rows] : rows_) {
      SCOPED_TRACE(testing::Message() << where_ << ", voxel " << voxel_mm << " mm, seed " << seed);
      int all = 0, within = 0;
      for (const auto& [metric, row] : rows) {
        print(voxel_mm, metric, row);
        EXPECT_EQ(row.unmeasured, 0) << metric;
        EXPECT_GE(row.within, 0.85 * row.cases) << metric;
        all += row.cases;
        within += row.within;
        if (!less_sure.contains(metric)) expect_sure(voxel_mm, metric, row);
      }
      EXPECT_GE(within, 0.93 * all) << within << " of " << all;
    }
  }

 private:
  void expect_sure(double voxel_mm, const std::string& metric, const KnownRow& row) const {
    if (const auto most = greatest_uncertainty(metric, row.unit); most && voxel_mm == 0.078) {
      EXPECT_LE(row.uncertainty, *most) << metric;
    }
    const auto coarse = rows_.find(0.1);
    if (voxel_mm != 0.05 || coarse == rows_.end()) return;
    const KnownRow& twice = coarse->second.at(metric);
    constexpr double kOtherCases = 1.1;  // the same cases would give half
    EXPECT_LE(row.sum / row.cases, 0.5 * kOtherCases * twice.sum / twice.cases) << metric;
  }
  void print(double voxel_mm, const std::string& metric, const KnownRow& row) const {
    const char* unit = row.unit.c_str();
    std::printf("| %s | %.3f | %s | %d | %d | %.4f %s | %.4f %s | mean %.4f %s |\n", where_.c_str(), voxel_mm, metric.c_str(), row.within,
                row.cases, row.worst, unit, row.uncertainty, unit, row.sum / row.cases, unit);
  }
  std::string where_;
  std::map<double, KnownRows> rows_;
};

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
