// How far two models' grades lie apart.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "scenarios/audit/audit.h"

namespace cusp::scenarios {
namespace {

void keep_larger(double& most, double one) noexcept {
  if (std::abs(one) > std::abs(most)) most = one;
}

const CriterionGrade* criterion(const Grade& grade, const std::string& id) {
  for (const CriterionGrade& c : grade.criteria)
    if (c.id == id) return &c;
  return nullptr;
}

/// Majority over attempts: passed or not, and each critical event.
struct Mostly {
  std::size_t passed = 0, attempts = 0;
  std::map<std::string, std::size_t> critical;
  void add(const Grade& grade) {
    ++attempts;
    passed += grade.passed ? 1 : 0;
    for (const std::string& key : std::set<std::string>(grade.critical.begin(), grade.critical.end())) ++critical[key];
  }
  std::set<std::string> events() const {
    std::set<std::string> out;
    for (const auto& [key, n] : critical)
      if (2 * n > attempts) out.insert(key);
    return out;
  }
  bool operator==(const Mostly& other) const {
    return (2 * passed > attempts) == (2 * other.passed > other.attempts) && events() == other.events();
  }
};

struct Sum {
  double all = 0, squares = 0;
  std::size_t n = 0;
  void add(double v) noexcept {
    all += v;
    squares += v * v;
    ++n;
  }
  double mean() const noexcept { return n > 0 ? all / static_cast<double>(n) : 0.0; }
  double standard_error() const noexcept {
    if (n < 2) return 0.0;
    const double count = static_cast<double>(n);
    return std::sqrt(std::max(0.0, squares - all * all / count) / (count - 1.0) / count);
  }
};

}  // namespace

GradeChange change_between(const ModelResult& from, const ModelResult& to) {
  GradeChange out;
  for (std::size_t i = 0; i < from.attempts.size() && i < to.attempts.size(); ++i) {
    const Grade& a = from.attempts[i].grade;
    const Grade& b = to.attempts[i].grade;
    keep_larger(out.score, b.score - a.score);
    out.passes_alike = out.passes_alike && a.passed == b.passed && a.critical == b.critical;
    for (const CriterionGrade& before : a.criteria) {
      const CriterionGrade* after = criterion(b, before.id);
      if (!after || after->measure.measured != before.measure.measured) {
        out.measures_alike = false;
        continue;
      }
      keep_larger(out.points[before.id], after->points - before.points);
      if (before.measure.measured) keep_larger(out.values[before.id], after->measure.value - before.measure.value);
    }
  }
  out.measures_alike = out.measures_alike && from.attempts.size() == to.attempts.size();
  return out;
}

namespace {

enum class Pick : std::uint8_t { named, others };

/// The attempts of the named operators, or of all others.
ModelResult attempts_of(const ModelResult& all, const std::vector<std::string>& names, Pick pick) {
  ModelResult out;
  for (const ModelAttempt& attempt : all.attempts) {
    if ((std::ranges::find(names, attempt.by.name) != names.end()) == (pick == Pick::named)) out.attempts.push_back(attempt);
  }
  return out;
}

}  // namespace

std::vector<std::string> operators_beyond(const ModelResult& from, const ModelResult& to, double tolerance_points) {
  std::vector<std::string> out;
  for (const ModelAttempt& attempt : from.attempts) {
    const std::vector<std::string> one = {attempt.by.name};
    if (std::ranges::find(out, one.front()) != out.end()) continue;
    if (!change_between(attempts_of(from, one, Pick::named), attempts_of(to, one, Pick::named)).within(tolerance_points)) out.push_back(one.front());
  }
  return out;
}

int attempts_to_decide(const ModelResult& from, const ModelResult& to, const std::string& name, double tolerance_points) {
  const std::vector<std::string> one = {name};
  const GradeChange had = mean_change_between(attempts_of(from, one, Pick::named), attempts_of(to, one, Pick::named));
  if (had.decided(tolerance_points) || !had.passes_alike || !had.measures_alike) return 0;
  const double ratio = had.standard_error / (0.25 * tolerance_points);
  // A tolerance of 0, or far below the error, asks for more attempts than an int holds.
  constexpr double kMost = std::numeric_limits<int>::max();
  return static_cast<int>(std::min(std::ceil(ratio * ratio * had.attempts_per_operator - 1e-9), kMost));
}

GradeChange joined(const GradeChange& means, const ModelResult& from, const ModelResult& to, const std::vector<std::string>& operators) {
  const GradeChange rest = change_between(attempts_of(from, operators, Pick::others), attempts_of(to, operators, Pick::others));
  GradeChange out = means;
  if (std::abs(rest.score) > std::abs(out.score) + out.standard_error) {
    out.score = rest.score;
    out.standard_error = 0;
    out.attempts_per_operator = 1;
  }
  for (const auto& [id, points] : rest.points) keep_larger(out.points[id], points);
  for (const auto& [id, value] : rest.values) keep_larger(out.values[id], value);
  out.passes_alike = out.passes_alike && rest.passes_alike;
  out.measures_alike = out.measures_alike && rest.measures_alike;
  return out;
}

GradeChange mean_change_between(const ModelResult& from, const ModelResult& to) {
  GradeChange out;
  out.measures_alike = from.attempts.size() == to.attempts.size();
  std::set<std::string> names;
  for (const ModelAttempt& attempt : from.attempts) names.insert(attempt.by.name);
  for (const std::string& name : names) {
    Sum score;
    std::map<std::string, Sum> points, values;
    Mostly before, after;
    for (std::size_t i = 0; i < from.attempts.size() && i < to.attempts.size(); ++i) {
      if (from.attempts[i].by.name != name) continue;
      const Grade &a = from.attempts[i].grade, &b = to.attempts[i].grade;
      score.add(b.score - a.score);
      before.add(a);
      after.add(b);
      for (const CriterionGrade& was : a.criteria) {
        const CriterionGrade* is = criterion(b, was.id);
        if (!is || is->measure.measured != was.measure.measured) {
          out.measures_alike = false;
          continue;
        }
        points[was.id].add(is->points - was.points);
        if (was.measure.measured) values[was.id].add(is->measure.value - was.measure.value);
      }
    }
    // Reported is the operator that comes nearest to the tolerance's edge.
    if (std::abs(score.mean()) + score.standard_error() >= std::abs(out.score) + out.standard_error) {
      out.score = score.mean();
      out.standard_error = score.standard_error();
      out.attempts_per_operator = static_cast<int>(score.n);
    }
    for (const auto& [id, sum] : points) keep_larger(out.points[id], sum.mean());
    for (const auto& [id, sum] : values) keep_larger(out.values[id], sum.mean());
    out.passes_alike = out.passes_alike && before == after;
  }
  return out;
}

}  // namespace cusp::scenarios
