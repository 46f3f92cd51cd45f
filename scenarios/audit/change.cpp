// How far two models' grades lie apart.
#include <algorithm>
#include <cmath>
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

/// Alike in most goes: passed or not, and each critical event.
struct Mostly {
  std::size_t passed = 0, goes = 0;
  std::map<std::string, std::size_t> critical;
  void add(const Grade& grade) {
    ++goes;
    passed += grade.passed ? 1 : 0;
    for (const std::string& key : std::set<std::string>(grade.critical.begin(), grade.critical.end())) ++critical[key];
  }
  std::set<std::string> events() const {
    std::set<std::string> out;
    for (const auto& [key, n] : critical)
      if (2 * n > goes) out.insert(key);
    return out;
  }
  bool operator==(const Mostly& other) const {
    return (2 * passed > goes) == (2 * other.passed > other.goes) && events() == other.events();
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
  for (std::size_t i = 0; i < from.goes.size() && i < to.goes.size(); ++i) {
    const Grade& a = from.goes[i].grade;
    const Grade& b = to.goes[i].grade;
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
  out.measures_alike = out.measures_alike && from.goes.size() == to.goes.size();
  return out;
}

namespace {

/// The goes of the hands that are named, or of all others.
ModelResult goes_of(const ModelResult& all, const std::vector<std::string>& hands, bool named) {
  ModelResult out;
  for (const ModelGo& go : all.goes) {
    if ((std::ranges::find(hands, go.hand.hand) != hands.end()) == named) out.goes.push_back(go);
  }
  return out;
}

}  // namespace

std::vector<std::string> hands_beyond(const ModelResult& from, const ModelResult& to, double tolerance_points) {
  std::vector<std::string> out;
  for (const ModelGo& go : from.goes) {
    const std::vector<std::string> one = {go.hand.hand};
    if (std::ranges::find(out, one.front()) != out.end()) continue;
    if (!change_between(goes_of(from, one, true), goes_of(to, one, true)).within(tolerance_points)) out.push_back(one.front());
  }
  return out;
}

int goes_to_decide(const ModelResult& from, const ModelResult& to, const std::string& hand, double tolerance_points) {
  const std::vector<std::string> one = {hand};
  const GradeChange had = mean_change_between(goes_of(from, one, true), goes_of(to, one, true));
  if (had.decided(tolerance_points) || !had.passes_alike || !had.measures_alike) return 0;
  const double ratio = had.standard_error / (0.25 * tolerance_points);
  return static_cast<int>(std::ceil(ratio * ratio * had.goes_a_hand - 1e-9));
}

GradeChange joined(const GradeChange& means, const ModelResult& from, const ModelResult& to, const std::vector<std::string>& hands) {
  const GradeChange rest = change_between(goes_of(from, hands, false), goes_of(to, hands, false));
  GradeChange out = means;
  if (std::abs(rest.score) > std::abs(out.score) + out.standard_error) {
    out.score = rest.score;
    out.standard_error = 0;
    out.goes_a_hand = 1;
  }
  for (const auto& [id, points] : rest.points) keep_larger(out.points[id], points);
  for (const auto& [id, value] : rest.values) keep_larger(out.values[id], value);
  out.passes_alike = out.passes_alike && rest.passes_alike;
  out.measures_alike = out.measures_alike && rest.measures_alike;
  return out;
}

GradeChange mean_change_between(const ModelResult& from, const ModelResult& to) {
  GradeChange out;
  out.measures_alike = from.goes.size() == to.goes.size();
  std::set<std::string> hands;
  for (const ModelGo& go : from.goes) hands.insert(go.hand.hand);
  for (const std::string& hand : hands) {
    Sum score;
    std::map<std::string, Sum> points, values;
    Mostly before, after;
    for (std::size_t i = 0; i < from.goes.size() && i < to.goes.size(); ++i) {
      if (from.goes[i].hand.hand != hand) continue;
      const Grade &a = from.goes[i].grade, &b = to.goes[i].grade;
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
    // The hand that comes nearest to the tolerance's edge is the one that is told.
    if (std::abs(score.mean()) + score.standard_error() >= std::abs(out.score) + out.standard_error) {
      out.score = score.mean();
      out.standard_error = score.standard_error();
      out.goes_a_hand = static_cast<int>(score.n);
    }
    for (const auto& [id, sum] : points) keep_larger(out.points[id], sum.mean());
    for (const auto& [id, sum] : values) keep_larger(out.values[id], sum.mean());
    out.passes_alike = out.passes_alike && before == after;
  }
  return out;
}

}  // namespace cusp::scenarios
