// What the newest attempts say of each criterion.
#include <algorithm>
#include <map>

#include "scenarios/grading/maxima.h"
#include "storage/summary/history.h"
#include "storage/summary/pages.h"

namespace cusp::storage {
namespace {

class CriterionCount {
 public:
  /// `whole`: what the criteria of its grade have together.
  void add(const CriterionGrade& of_one, double whole) {
    CriterionFigures& c = by_id_[of_one.id];
    c.id = of_one.id;
    ++c.attempts;
    c.full += Grade{}.score_max * (of_one.points_max - of_one.points) / whole < kLeastShownLoss ? 1 : 0;
    c.mean_share += of_one.points / of_one.points_max;
  }
  std::vector<CriterionFigures> figures() const {
    std::vector<CriterionFigures> out;
    for (const auto& [id, c] : by_id_) {
      out.push_back(c);
      out.back().mean_share /= c.attempts;
    }
    std::ranges::stable_sort(out, {}, &CriterionFigures::mean_share);
    return out;
  }

 private:
  std::map<std::string, CriterionFigures> by_id_;
};

/// Points of evaluator 2 are of weights with any sum: a loss counts as it shows in the report, of 100.
void add_all(const std::vector<CriterionGrade>& criteria, CriterionCount& count) {
  double whole = 0;
  for (const CriterionGrade& c : criteria) whole += std::max(0.0, c.points_max);
  for (const CriterionGrade& c : criteria) {
    if (c.points_max > 0) count.add(c, whole);
  }
}

/// The newest grade of one session after another, with what examiners changed.
class NewestGrades {
 public:
  explicit NewestGrades(Database& db) : db_{db} {}
  Stored<void> add(SessionId session, CriterionCount& count) {
    newest_.bind(session);
    const auto there = newest_.step();
    if (!there) return std::unexpected(there.error());
    if (!*there) return {};
    const Row row = newest_.row();
    if (row.flag(1) || row.is_null(0)) return add_counted(session, count);
    if (const auto criteria = criteria_from(row.bytes(0))) add_all(*criteria, count);
    return {};
  }

 private:
  /// Of a grade that an examiner changed, or of a schema before 13.
  Stored<void> add_counted(SessionId session, CriterionCount& count) {
    const auto grades = grades_of(db_, session);
    if (!grades) return std::unexpected(grades.error());
    const auto statements = statements_of(db_, session);
    if (!statements) return std::unexpected(statements.error());
    if (const auto counts = effective_grade(*grades, *statements)) add_all(counts->grade.criteria, count);
    return {};
  }

  Database& db_;
  Statement newest_ = db_.prepare(
      "SELECT c.packed, EXISTS (SELECT 1 FROM statements t INDEXED BY statements_of_session WHERE t.session = ?1 "
      "AND t.kind = 'override_points') FROM grades g LEFT JOIN graded_criteria c ON c.session = g.session AND c.row = g.row "
      "WHERE g.session = ?1 ORDER BY g.row DESC LIMIT 1");
};

}  // namespace

Stored<std::vector<CriterionFigures>> History::by_criterion(const Actor& actor, const HistoryFilter& filter) {
  auto narrowed = readable(actor, filter);
  if (!narrowed) return std::unexpected(narrowed.error());
  narrowed->released_alone = narrowed->released_alone || !may(actor.role, Action::see_all_results);
  const Snapshot snapshot(c_.db);
  const auto keys = keys_of_page(c_.db, *narrowed, std::nullopt, kMostByCriterion);
  if (!keys) return std::unexpected(keys.error());
  CriterionCount count;
  NewestGrades newest(c_.db);
  for (const HistoryKey& key : *keys) {
    if (auto done = newest.add(key.session, count); !done) return std::unexpected(done.error());
  }
  return count.figures();
}

}  // namespace cusp::storage
