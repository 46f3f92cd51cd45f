#include "ui/admin/people_import_work.h"

#include <QRandomGenerator>
#include <system_error>
#include <utility>

#include "storage/repositories/student_lines.h"

namespace cusp::ui {
namespace {

PeopleImportEnd make_all(const PeopleImportWork& work, const WorkWatch& watch) {
  const auto own = open_beside(work.records);
  if (!own) return {.failure = own.error()};
  std::vector<StudentLine> lines;
  PeopleImportEnd out{.slips = work.slips};
  for (const ListedStudent& student : work.lines) {
    const bool fresh = student.state == ListedStudent::State::fresh;
    lines.push_back({.account = {student.number.toStdString(), student.name.toStdString(), Role::student, {}, fresh ? student.pin.toStdString() : std::string()},
                     .cohort = student.cohort.toStdString(),
                     .has_account = !fresh});
    out.made += fresh ? 1 : 0;
  }
  const StudentLinesEnd end = add_students((*own)->context(), work.actor, lines, watch);
  if (end.failure) return {.failure = end.failure, .line = end.line < work.lines.size() ? work.lines[end.line].line : 0};
  return out;
}

PeopleImportEnd make_all_or_none(const PeopleImportWork& work, const WorkWatch& watch) {
  PeopleImportEnd end = make_all(work, watch);
  std::error_code unremoved;  // then they name accounts that nobody has
  if (end.failure && !work.slips.empty()) std::filesystem::remove(work.slips, unremoved);
  return end;
}

}  // namespace

void give_pins(std::vector<ListedStudent>& lines) {
  for (ListedStudent& line : lines) {
    if (line.state != ListedStudent::State::fresh || !line.pin.isEmpty()) continue;
    line.pin = QStringLiteral("%1").arg(QRandomGenerator::system()->bounded(1'000'000), 6, 10, QLatin1Char('0'));
  }
}

BackgroundTask make_accounts(PeopleImportWork work, std::shared_ptr<WorkProgress> progress, std::function<void(PeopleImportEnd)> ended) {
  return BackgroundTask([work = std::move(work), watch = watch_of(std::move(progress)), ended = std::move(ended)] { ended(make_all_or_none(work, watch)); });
}

}  // namespace cusp::ui
