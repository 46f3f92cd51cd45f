#include "storage/summary/figures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "scenarios/grading/grade.h"

namespace cusp::storage {
namespace {

constexpr double kZ95 = 1.959963984540054;  // normal quantile of 0.975
constexpr int kLeastStudents = 3;           // fewer make no group
constexpr int kMostAttempt = 0xFFFF;        // greater attempt numbers count as this one

/// Counts of values in equal steps from the least to the greatest: a quantile is then sought among the values of one step.
class Steps {
 public:
  static constexpr std::size_t kSteps = 4096;
  /// Pre: not empty. usable() is false if the values are equal or not finite.
  explicit Steps(std::span<const double> values) : values_{values} {
    const auto [least, greatest] = std::ranges::minmax_element(values);
    low_ = *least;
    per_step_ = kSteps / (*greatest - *least);
    if (!usable()) return;
    for (const double value : values) ++counts_[step_of(value)];
  }
  bool usable() const noexcept { return std::isfinite(low_) && std::isnormal(per_step_); }
  double quantile_at(double q) const {
    const double at = q * static_cast<double>(values_.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(at));
    std::size_t before = 0, first = 0;
    while (before + counts_[first] <= below) before += counts_[first++];
    // The next greater value may stand in a later step.
    std::size_t last = first, until = before + counts_[first];
    while (until < values_.size() && until <= below + 1) until += counts_[++last];
    std::vector<double> near;
    near.reserve(until - before);
    for (const double value : values_) {
      const std::size_t step = step_of(value);
      if (step >= first && step <= last) near.push_back(value);
    }
    return interpolated(near, static_cast<double>(below - before) + (at - static_cast<double>(below)));
  }
  /// The value at a place among the values in order, between two of them if it has a fraction. Reorders `values`.
  static double interpolated(std::vector<double>& values, double at) {
    const auto below = static_cast<std::ptrdiff_t>(std::floor(at));
    std::nth_element(values.begin(), values.begin() + below, values.end());
    const double low = values[static_cast<std::size_t>(below)];
    if (below + 1 == std::ssize(values)) return low;
    const double high = *std::min_element(values.begin() + below + 1, values.end());
    return low + (at - static_cast<double>(below)) * (high - low);
  }

 private:
  std::size_t step_of(double value) const noexcept {
    return std::min(static_cast<std::size_t>((value - low_) * per_step_), kSteps - 1);
  }
  std::span<const double> values_;
  double low_ = 0, per_step_ = 0;
  std::array<std::size_t, kSteps> counts_{};
};

Interval middle_half_of(const Quartiles& q) { return {q.low, q.high}; }

Interval wilson_of(double p, double n) {
  const double z2 = kZ95 * kZ95;
  const double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = kZ95 / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4.0 * n * n));
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

PassCount sum_of(std::span<const PassCount> students) {
  PassCount sum;
  for (const PassCount& s : students) {
    sum.attempts += s.attempts;
    sum.passed += s.passed;
  }
  return sum;
}

double share_of(const PassCount& count) { return static_cast<double>(count.passed) / count.attempts; }

}  // namespace

double quantile(std::vector<double>& values, double q) {
  assert(!values.empty());
  return Steps::interpolated(values, q * static_cast<double>(values.size() - 1));
}

Quartiles quartiles(std::span<const double> values) {
  assert(!values.empty());
  if (values.size() > 2 * Steps::kSteps) {
    if (const Steps steps(values); steps.usable()) return {steps.quantile_at(0.25), steps.quantile_at(0.5), steps.quantile_at(0.75)};
  }
  std::vector<double> copy(values.begin(), values.end());
  const double low = quantile(copy, 0.25), median = quantile(copy, 0.5);
  return {low, median, quantile(copy, 0.75)};
}

Interval wilson_95(int successes, int n) { return wilson_of(static_cast<double>(successes) / n, n); }

double design_effect(std::span<const PassCount> students) {
  const PassCount sum = sum_of(students);
  const double share = share_of(sum), attempts = sum.attempts, clusters = static_cast<double>(students.size());
  double squares = 0;
  for (const PassCount& s : students) {
    const double apart = s.passed - share * s.attempts;
    squares += apart * apart;
  }
  const double variance = clusters / (clusters - 1) * squares / (attempts * attempts);
  return attempts * variance / (share * (1 - share));
}

std::optional<Interval> share_passed_95(std::span<const PassCount> students) {
  if (students.size() < 2) return std::nullopt;
  const PassCount sum = sum_of(students);
  if (sum.attempts == std::ssize(students)) return wilson_95(sum.passed, sum.attempts);  // one of each student: independent
  if (sum.passed == 0 || sum.passed == sum.attempts) return wilson_of(share_of(sum), static_cast<double>(students.size()));
  return wilson_of(share_of(sum), sum.attempts / std::max(1.0, design_effect(students)));
}

/// The last eight bytes of a UUIDv7 are random but for two bits: the product's upper bits depend on all of them.
std::size_t StudentNumbers::slot_of(const UserId& student) const noexcept {
  std::uint64_t random = 0;
  std::memcpy(&random, student.uuid.bytes.data() + 8, sizeof random);
  constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15;  // 2^64 / golden ratio (Knuth, 6.4)
  std::size_t at = (random * kGolden >> 32) & (slots_.size() - 1);
  while (slots_[at].number != kNone && slots_[at].student != student) at = (at + 1) & (slots_.size() - 1);
  return at;
}

std::uint32_t StudentNumbers::number(const UserId& student) {
  if (2 * (size_ + std::size_t{1}) > slots_.size()) grow();
  Slot& slot = slots_[slot_of(student)];
  if (slot.number == kNone) slot = {student, size_++};
  return slot.number;
}

bool StudentNumbers::knows(const UserId& student) const noexcept {
  return !slots_.empty() && slots_[slot_of(student)].number != kNone;
}

void StudentNumbers::grow() {
  std::vector<Slot> before(std::max<std::size_t>(64, 2 * slots_.size()));
  before.swap(slots_);
  for (const Slot& slot : before) {
    if (slot.number != kNone) slots_[slot_of(slot.student)] = slot;
  }
}

void FigureCount::add(const GradedAttempt& a) {
  const auto attempt = static_cast<std::size_t>(std::clamp(a.attempt, 0, kMostAttempt));
  if (counted_.attempts == 0) counted_.pass_mark = a.pass_mark;
  marks_differ_ = marks_differ_ || counted_.pass_mark != a.pass_mark;
  ++counted_.attempts;
  counted_.passed += a.passed ? 1 : 0;
  const auto last = static_cast<double>(counted_.spread.size() - 1);
  // A sum of criteria that passes (scenarios::reaches) stands on the mark's side of the bars.
  ++counted_.spread[static_cast<std::size_t>(std::clamp(std::floor((a.score + scenarios::kScoreSlack) / kSpreadPoints), 0.0, last))];
  scores_.push_back(a.score);
  times_s_.push_back(static_cast<double>(a.elapsed_us) * 1e-6);
  if (by_attempt_.size() <= attempt) by_attempt_.resize(attempt + 1);
  by_attempt_[attempt].values.push_back(a.score);
  const std::uint32_t student = students_.number(a.student);
  by_attempt_[attempt].students.push_back(student);
  if (passes_.size() <= student) passes_.resize(student + std::size_t{1});
  ++passes_[student].attempts;
  passes_[student].passed += a.passed ? 1 : 0;
}

Figures FigureCount::figures() const {
  Figures f = counted_;
  if (marks_differ_) f.pass_mark.reset();
  f.students = static_cast<int>(students_.size());
  if (scores_.empty()) return f;
  const Quartiles scores = quartiles(scores_);
  f.median_score = scores.median;
  f.middle_half = middle_half_of(scores);
  f.passed_95 = share_passed_95(passes_);
  f.median_time_s = quartiles(times_s_).median;
  f.last_attempt = static_cast<int>(by_attempt_.size()) - 1;
  f.learning = learning();
  return f;
}

std::vector<LearningPoint> FigureCount::learning() const {
  std::vector<LearningPoint> points;
  std::vector<int> counted_for(students_.size(), -1);  // by student: the last attempt number that counted the student
  for (int attempt = 0; attempt < std::ssize(by_attempt_); ++attempt) {
    const Scores& scores = by_attempt_[static_cast<std::size_t>(attempt)];
    int students = 0;
    for (const std::uint32_t student : scores.students) {
      if (counted_for[student] == attempt) continue;
      counted_for[student] = attempt;
      ++students;
    }
    if (students < kLeastStudents) continue;
    const Quartiles of_number = quartiles(scores.values);
    points.push_back({attempt, students, of_number.median, middle_half_of(of_number)});
  }
  return points;
}

}  // namespace cusp::storage
