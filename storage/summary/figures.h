/// Figures over many graded attempts: counts, medians, the spread of scores and learning by attempt number. Plain numbers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/ids.h"

namespace cusp::storage {

struct Interval {
  double low = 0, high = 0;
};

/// Quantile by linear interpolation between order statistics (Hyndman and Fan, type 7). Reorders `values`. Linear time.
/// Pre: not empty, 0 <= q <= 1.
double quantile(std::vector<double>& values, double q);

/// The quantiles at 0.25, 0.5 and 0.75, of the same type.
struct Quartiles {
  double low = 0, median = 0, high = 0;
};
/// Linear time: of a million values 5 ms. Pre: not empty, no NaN.
Quartiles quartiles(std::span<const double> values);

/// 95 % interval of a share (Wilson's score interval), in [0, 1]. Pre: 0 <= successes <= n, n > 0.
Interval wilson_95(int successes, int n);

/// The attempts of one student.
struct PassCount {
  int attempts = 0, passed = 0;
};

/// How much more the attempts of several students vary than as many independent ones. Source: Rao and Scott 1992, "A simple method for the
/// analysis of clustered binary data". Pre: two students or more; some of the attempts passed, and not all.
double design_effect(std::span<const PassCount> students);

/// 95 % interval of the share that passed: Wilson's, of the attempts divided by their design effect. If all or none passed, a student's
/// attempts count as one. None of a single student: these attempts say nothing of others.
std::optional<Interval> share_passed_95(std::span<const PassCount> students);

/// One graded attempt, as far as figures need it.
struct GradedAttempt {
  UserId student{};
  int attempt = 1;  // the student's attempts at this scenario, counted from 1
  double score = 0;
  std::optional<double> pass_mark{};
  bool passed = false;
  std::uint64_t elapsed_us = 0;
};

/// The scores of one attempt number: median and middle half.
struct LearningPoint {
  int attempt = 1, students = 0;
  double median = 0;
  Interval middle_half{};
};

inline constexpr double kSpreadPoints = 5;  // width of a bar of Figures::spread

struct Figures {
  int attempts = 0, students = 0;  // graded attempts, by how many students
  std::optional<double> median_score{};
  Interval middle_half{};  // of the scores
  int passed = 0;
  std::optional<Interval> passed_95{};  // share_passed_95()
  std::optional<double> median_time_s{};
  std::array<int, 20> spread{};       // attempts with [0, 5), [5, 10) ... [95, 100] points
  std::optional<double> pass_mark{};  // none: the attempts have no pass mark, or more than one
  int last_attempt = 0;               // highest attempt number
  std::vector<LearningPoint> learning{};  // attempt numbers that at least three students have reached
};

/// Numbers students 0, 1, 2 ... in the order in which they come: a table of slots, probed one after the other.
class StudentNumbers {
 public:
  /// Its number; a new student takes the next one.
  std::uint32_t number(const UserId& student);
  bool knows(const UserId& student) const noexcept;
  std::uint32_t size() const noexcept { return size_; }

 private:
  struct Slot {
    UserId student;
    std::uint32_t number = kNone;
  };
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::size_t slot_of(const UserId& student) const noexcept;
  void grow();
  std::vector<Slot> slots_;  // none, or a power of two of which at most half are taken
  std::uint32_t size_ = 0;
};

/// Takes attempts one by one, in any order. Thread: one.
class FigureCount {
 public:
  void add(const GradedAttempt& attempt);
  Figures figures() const;

 private:
  struct Scores {
    std::vector<double> values;
    std::vector<std::uint32_t> students;
  };
  std::vector<LearningPoint> learning() const;

  Figures counted_;
  std::vector<double> scores_, times_s_;
  StudentNumbers students_;
  std::vector<PassCount> passes_;   // by number of the student
  std::vector<Scores> by_attempt_;  // by attempt number
  bool marks_differ_ = false;
};

}  // namespace cusp::storage
