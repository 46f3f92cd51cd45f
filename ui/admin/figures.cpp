#include "ui/admin/figures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>

namespace cusp::ui {
namespace {

constexpr double kZ95 = 1.959963984540054;  // normal quantile of 0.975
constexpr int kLeastStudents = 3;           // fewer make no group

}  // namespace

double quantile(std::vector<double> values, double q) {
  assert(!values.empty());
  std::sort(values.begin(), values.end());
  const double at = q * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(at));
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

Interval wilson_95(int successes, int n) {
  const double p = static_cast<double>(successes) / n, z2 = kZ95 * kZ95;
  const double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = kZ95 / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4.0 * n * n));
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

Figures figures_of(std::span<const HistoryRow> rows) {
  Figures f;
  std::vector<double> scores, times;
  std::set<UserId> students;
  for (const HistoryRow& r : rows) {
    if (!r.score) continue;
    scores.push_back(*r.score);
    times.push_back(static_cast<double>(r.elapsed_us) * 1e-6);
    students.insert(r.student);
    if (r.passed.value_or(false)) ++f.passed;
  }
  f.attempts = static_cast<int>(scores.size());
  f.students = static_cast<int>(students.size());
  if (scores.empty()) return f;
  f.median_score = quantile(scores, 0.5);
  f.middle_half = {quantile(scores, 0.25), quantile(scores, 0.75)};
  f.passed_95 = wilson_95(f.passed, f.attempts);
  f.median_time_s = quantile(times, 0.5);
  return f;
}

std::vector<int> spread_of(std::span<const HistoryRow> rows, double from, double width) {
  std::vector<int> bars(static_cast<std::size_t>(std::lround((100 - from) / width)), 0);
  for (const HistoryRow& r : rows) {
    if (!r.score) continue;
    const double at = std::floor((*r.score - from) / width);
    const auto last = static_cast<double>(bars.size() - 1);
    ++bars[static_cast<std::size_t>(std::clamp(at, 0.0, last))];
  }
  return bars;
}

std::vector<LearningPoint> learning_of(std::span<const HistoryRow> rows) {
  std::map<int, std::vector<double>> by_attempt;
  for (const HistoryRow& r : rows) {
    if (r.score) by_attempt[r.attempt].push_back(*r.score);
  }
  std::vector<LearningPoint> points;
  for (const auto& [attempt, scores] : by_attempt) {
    if (static_cast<int>(scores.size()) < kLeastStudents) continue;
    points.push_back({attempt, static_cast<int>(scores.size()), quantile(scores, 0.5),
                      {quantile(scores, 0.25), quantile(scores, 0.75)}});
  }
  return points;
}

}  // namespace cusp::ui
