/// The four figures of the performance page and the data of its charts. Plain numbers, no text, no widget. Pure functions.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "storage/summary/history.h"
#include "ui/modules.h"

namespace cusp::ui {

struct Interval {
  double low = 0, high = 0;
};

/// Quantile by linear interpolation between order statistics (Hyndman and Fan, type 7). Pre: not empty, 0 <= q <= 1.
double quantile(std::vector<double> values, double q);

/// 95 % interval of a share (Wilson's score interval), in [0, 1]. Pre: 0 <= successes <= n, n > 0.
Interval wilson_95(int successes, int n);

struct Figures {
  int attempts = 0, students = 0;               // graded attempts, by how many students
  std::optional<double> median_score;
  Interval middle_half;                     // of the scores
  int passed = 0;
  std::optional<Interval> passed_95;
  std::optional<double> median_time_s;
};
Figures figures_of(std::span<const HistoryRow> rows);

/// How many graded attempts fall into each bar of `width` points from `from` to 100; what lies below goes into the first.
std::vector<int> spread_of(std::span<const HistoryRow> rows, double from, double width);

/// By number of the attempt: median and middle half of the scores, for attempts that at least three students have made.
struct LearningPoint {
  int attempt = 1, students = 0;
  double median = 0;
  Interval middle_half;
};
std::vector<LearningPoint> learning_of(std::span<const HistoryRow> rows);

}  // namespace cusp::ui
