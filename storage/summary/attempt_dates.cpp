#include "storage/summary/attempt_dates.h"

#include <map>

namespace cusp::storage {
namespace {

/// Many attempts share an assignment: each is read once.
class AssignmentDates {
 public:
  explicit AssignmentDates(Database& db)
      : statement_{db.prepare("SELECT c.name, a.opens_at, a.due_at FROM assignments a JOIN cohorts c ON c.id = a.cohort WHERE a.id = ?1")} {}
  Stored<AttemptDates> of(AssignmentId assignment) {
    if (const auto known = read_.find(assignment); known != read_.end()) return known->second;
    statement_.bind(assignment);
    const auto found = statement_.step();
    if (!found) return std::unexpected(found.error());
    AttemptDates dates;
    if (*found) {
      const Row row = statement_.row();
      dates.cohort = row.text(0);
      dates.opens_utc_us = row.maybe_integer(1);
      dates.due_utc_us = row.maybe_integer(2);
    }
    read_.emplace(assignment, dates);
    return dates;
  }

 private:
  Statement statement_;
  std::map<AssignmentId, AttemptDates> read_;
};

}  // namespace

Stored<std::vector<AttemptDates>> dates_of(Database& db, const std::vector<HistoryRow>& rows) {
  // An interrupted attempt that is graded as it stands has no event "finished": its first grade ends it.
  Statement finished = db.prepare(
      "SELECT coalesce(max(iif(kind = 'finished', at, NULL)), min(iif(kind = 'graded', at, NULL))) FROM session_events WHERE session = ?1");
  AssignmentDates assignments(db);
  std::vector<AttemptDates> out;
  out.reserve(rows.size());
  for (const HistoryRow& row : rows) {
    auto dates = row.assignment ? assignments.of(*row.assignment) : Stored<AttemptDates>{};
    if (!dates) return std::unexpected(dates.error());
    finished.bind(row.session);
    const auto found = finished.step();
    if (!found) return std::unexpected(found.error());
    if (*found) dates->finished_utc_us = finished.row().maybe_integer(0);
    out.push_back(std::move(*dates));
  }
  return out;
}

}  // namespace cusp::storage
