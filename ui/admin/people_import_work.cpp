#include "ui/admin/people_import_work.h"

#include <QRandomGenerator>
#include <utility>

#include "storage/repositories/student_lines.h"

namespace cusp::ui {
namespace {

QString fresh_pin() { return QStringLiteral("%1").arg(QRandomGenerator::system()->bounded(1'000'000), 6, 10, QLatin1Char('0')); }

PeopleImportEnd make_all(const PeopleImportWork& work, const WorkWatch& watch) {
  const auto own = open_beside(work.records);
  if (!own) return {.failure = own.error()};
  std::vector<StudentLine> lines;
  PeopleImportEnd out;
  for (const ListedStudent& student : work.lines) {
    const bool fresh = student.state == ListedStudent::State::fresh;
    const QString pin = !fresh ? QString() : student.pin.isEmpty() ? fresh_pin() : student.pin;
    lines.push_back({.account = {student.number.toStdString(), student.name.toStdString(), Role::student, {}, pin.toStdString()},
                     .cohort = student.cohort.toStdString(),
                     .has_account = !fresh});
    if (fresh) out.slips.push_back({student.name, student.number, pin, student.cohort});
  }
  const StudentLinesEnd end = add_students((*own)->context(), work.actor, lines, watch);
  if (end.failure) return {.failure = end.failure, .line = end.line < work.lines.size() ? work.lines[end.line].line : 0};
  return out;
}

}  // namespace

BackgroundTask make_accounts(PeopleImportWork work, std::shared_ptr<WorkProgress> progress, std::function<void(PeopleImportEnd)> ended) {
  return BackgroundTask([work = std::move(work), watch = watch_of(std::move(progress)), ended = std::move(ended)] { ended(make_all(work, watch)); });
}

}  // namespace cusp::ui
