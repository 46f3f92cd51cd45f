#include "storage/summary/figures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

namespace cusp::storage {
namespace {

constexpr double kZ95 = 1.959963984540054;  // normal quantile of 0.975
constexpr int kLeastStudents = 3;           // fewer make no group

Interval middle_half_of(std::vector<double>& values) { return {quantile(values, 0.25), quantile(values, 0.75)}; }

}  // namespace

double quantile(std::vector<double>& values, double q) {
  assert(!values.empty());
  const double at = q * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(std::floor(at));
  std::nth_element(values.begin(), values.begin() + below, values.end());
  const double low = values[static_cast<std::size_t>(below)];
  if (below + 1 == std::ssize(values)) return low;
  const double high = *std::min_element(values.begin() + below + 1, values.end());
  return low + (at - static_cast<double>(below)) * (high - low);
}

Interval wilson_95(int successes, int n) {
  const double p = static_cast<double>(successes) / n, z2 = kZ95 * kZ95;
  const double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = kZ95 / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4.0 * n * n));
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

/// The last bytes of a UUIDv7 are random.
std::size_t FigureCount::HashOfId::operator()(const UserId& id) const noexcept {
  std::size_t hash = 0;
  std::memcpy(&hash, id.uuid.bytes.data() + 8, sizeof hash);
  return hash;
}

void FigureCount::add(const GradedAttempt& attempt) {
  const auto student = students_.try_emplace(attempt.student, static_cast<std::uint32_t>(students_.size())).first->second;
  if (counted_.attempts == 0) counted_.pass_mark = attempt.pass_mark;
  marks_differ_ = marks_differ_ || counted_.pass_mark != attempt.pass_mark;
  ++counted_.attempts;
  counted_.passed += attempt.passed ? 1 : 0;
  counted_.last_attempt = std::max(counted_.last_attempt, attempt.attempt);
  const auto last = static_cast<double>(counted_.spread.size() - 1);
  ++counted_.spread[static_cast<std::size_t>(std::clamp(std::floor(attempt.score / kSpreadPoints), 0.0, last))];
  scores_.push_back(attempt.score);
  times_s_.push_back(static_cast<double>(attempt.elapsed_us) * 1e-6);
  Scores& of_number = by_attempt_[attempt.attempt];
  of_number.values.push_back(attempt.score);
  of_number.students.push_back(student);
}

Figures FigureCount::figures() {
  Figures f = counted_;
  if (marks_differ_) f.pass_mark.reset();
  f.students = static_cast<int>(students_.size());
  if (scores_.empty()) return f;
  f.median_score = quantile(scores_, 0.5);
  f.middle_half = middle_half_of(scores_);
  f.passed_95 = wilson_95(f.passed, f.attempts);
  f.median_time_s = quantile(times_s_, 0.5);
  f.learning = learning();
  return f;
}

std::vector<LearningPoint> FigureCount::learning() {
  std::vector<LearningPoint> points;
  std::vector<int> counted_for(students_.size(), -1);  // by student: the last attempt number that counted the student
  for (auto& [attempt, scores] : by_attempt_) {
    int students = 0;
    for (const std::uint32_t student : scores.students) {
      if (counted_for[student] == attempt) continue;
      counted_for[student] = attempt;
      ++students;
    }
    if (students < kLeastStudents) continue;
    points.push_back({attempt, students, quantile(scores.values, 0.5), middle_half_of(scores.values)});
  }
  return points;
}

}  // namespace cusp::storage
