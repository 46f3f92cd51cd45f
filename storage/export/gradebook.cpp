#include "storage/export/gradebook.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "scenarios/grading/grade.h"
#include "storage/repositories/accounts.h"
#include "storage/repositories/assignments.h"
#include "storage/repositories/audit_log.h"
#include "storage/repositories/scenarios.h"

namespace cusp::storage {
namespace {

struct Result {
  std::string number, name;
  double score = 0;
  std::optional<double> pass_mark{};
  bool passed = false;
};

bool reaches_mark(const Result& r) { return r.pass_mark && scenarios::reaches(r.score, *r.pass_mark); }

struct Results {
  std::map<std::string, Result> best;  // by number
  std::size_t withheld = 0;
  std::vector<std::string> ungraded{};
  double most = 100;
};

Results results_of(const std::vector<HistoryRow>& rows) {
  Results out;
  std::set<std::string> waiting, ungraded;
  for (const HistoryRow& row : rows) {
    if (row.student_number == erased_number(row.student)) continue;
    if (!row.score) {
      ungraded.insert(row.student_number);
      continue;
    }
    if (!row.released) {
      waiting.insert(row.student_number);
      continue;
    }
    out.most = row.score_max.value_or(out.most);
    const Result result{row.student_number, row.student_name, *row.score, row.pass_mark, row.passed.value_or(false)};
    const auto [at, fresh] = out.best.try_emplace(row.student_number, result);
    if (!fresh && result.score > at->second.score) at->second = result;
  }
  for (const std::string& number : waiting) out.withheld += out.best.contains(number) ? 0 : 1;
  for (const std::string& number : ungraded) {
    if (!out.best.contains(number) && !waiting.contains(number)) out.ungraded.push_back(number);
  }
  return out;
}

double hundredths(double points) { return std::round(points * 100) / 100; }

/// Rounded to hundredths of a point, but never up to the pass mark: the gradebook would count 69.996 of 70 as passed.
std::string points_text(const Result& r) {
  const double rounded = hundredths(r.score);
  const bool lifted = r.pass_mark && rounded >= *r.pass_mark && !reaches_mark(r);
  return csv_number(lifted ? std::floor(r.score * 100) / 100 : rounded);
}

std::string for_moodle(const Results& results, const std::string& title) {
  std::string out = "ID number," + csv_text(title) + "\r\n";
  for (const auto& [number, r] : results.best) out += csv_text(number) + ',' + points_text(r) + "\r\n";
  return out;
}

std::string for_canvas(const Results& results, const std::string& title) {
  std::string out = "Student,ID,SIS User ID,SIS Login ID,Section," + csv_text(title) + "\r\n";
  out += "Points Possible,,,,," + csv_number(hundredths(results.most)) + "\r\n";
  for (const auto& [number, r] : results.best) {
    out += csv_text(r.name) + ",," + csv_text(number) + ',' + csv_text(number) + ",," + points_text(r) + "\r\n";
  }
  return out;
}

}  // namespace

Stored<GradebookFile> make_gradebook(StorageContext& context, const Actor& actor, AssignmentId assignment, Gradebook system,
                                     const std::string& language) {
  if (auto allowed = require(actor, Action::export_results); !allowed) return std::unexpected(allowed.error());
  const auto assigned = Assignments(context).find(assignment);
  if (!assigned) return std::unexpected(assigned.error());
  const auto version = Scenarios(context).version(assigned->version);
  if (!version) return std::unexpected(version.error());
  const auto rows = History(context).of_assignment(actor, assignment);
  if (!rows) return std::unexpected(rows.error());
  const Results results = results_of(*rows);
  const std::string title = title_in(version->title, language);
  const auto failed = std::ranges::count_if(results.best, [](const auto& one) { return !one.second.passed && reaches_mark(one.second); });
  return GradebookFile{.text = system == Gradebook::moodle ? for_moodle(results, title) : for_canvas(results, title),
                       .students = results.best.size(),
                       .withheld = results.withheld,
                       .ungraded = results.ungraded,
                       .failed = static_cast<std::size_t>(failed)};
}

Stored<void> log_gradebook(StorageContext& context, const Actor& actor, AssignmentId assignment, const GradebookFile& file) {
  if (auto allowed = require(actor, Action::export_results); !allowed) return allowed;
  if (context.db.read_only()) return {};
  return AuditLog(context).add_if_allowed(
      {.actor = actor.id, .action = "gradebook_exported", .subject = assignment.uuid, .detail = std::to_string(file.students)}, Action::export_results);
}

}  // namespace cusp::storage
