#include "ui/admin/people_import_work.h"

#include <QRandomGenerator>
#include <map>

namespace cusp::ui {
namespace {

QString fresh_pin() { return QStringLiteral("%1").arg(QRandomGenerator::system()->bounded(1'000'000), 6, 10, QLatin1Char('0')); }

/// The cohorts of a school by name, whatever the case of its letters; a missing one is made.
class CohortsByName {
 public:
  CohortsByName(Store& store, const Actor& actor) : store_(store), actor_(actor) {}

  Stored<void> read() {
    const auto list = store_.cohorts.list();
    if (!list) return std::unexpected(list.error());
    for (const Cohort& cohort : *list) ids_[QString::fromStdString(cohort.name).toCaseFolded()] = cohort.id;
    return {};
  }

  Stored<CohortId> named(const QString& name) {
    const auto it = ids_.find(name.toCaseFolded());
    if (it != ids_.end()) return it->second;
    const auto made = store_.cohorts.create(actor_, name.toStdString());
    if (!made) return std::unexpected(made.error());
    ids_[name.toCaseFolded()] = made->id;
    return made->id;
  }

 private:
  Store& store_;
  const Actor& actor_;
  std::map<QString, CohortId> ids_;  // [name, case folded]
};

Stored<UserId> account_of(Store& store, const Actor& actor, const ListedStudent& student, const PeopleImportAnswers& answers) {
  if (student.state != ListedStudent::State::fresh) {
    const auto found = store.accounts.find_number(student.number.toStdString());
    return found ? Stored<UserId>(found->id) : std::unexpected(found.error());
  }
  const QString pin = student.pin.isEmpty() ? fresh_pin() : student.pin;
  const auto made = store.accounts.create(actor, {student.number.toStdString(), student.name.toStdString(), Role::student, {}, pin.toStdString()});
  if (!made) return std::unexpected(made.error());
  answers.account_made({student.name, student.number, pin, student.cohort});
  return made->id;
}

Stored<void> make_line(Store& store, const Actor& actor, CohortsByName& cohorts, const ListedStudent& student, const PeopleImportAnswers& answers) {
  const auto id = account_of(store, actor, student, answers);
  if (!id) return std::unexpected(id.error());
  if (student.cohort.isEmpty()) return {};
  const auto cohort = cohorts.named(student.cohort);
  if (!cohort) return std::unexpected(cohort.error());
  if (const auto added = store.cohorts.add(actor, *cohort, *id); !added) return std::unexpected(added.error());
  return {};
}

PeopleImportEnd make_lines(const PeopleImportWork& work, const std::stop_token& stop, const PeopleImportAnswers& answers) {
  const auto own = open_beside(work.records);
  if (!own) return {own.error()};
  CohortsByName cohorts(**own, work.actor);
  if (const auto read = cohorts.read(); !read) return {read.error()};
  int done = 0;
  for (const ListedStudent& student : work.lines) {
    if (stop.stop_requested()) break;
    if (const auto made = make_line(**own, work.actor, cohorts, student, answers); !made) return {made.error(), student.line};
    answers.lines_done(++done);
  }
  return {};
}

}  // namespace

BackgroundTask make_accounts(PeopleImportWork work, std::stop_token stop, PeopleImportAnswers answers) {
  return BackgroundTask([work = std::move(work), stop = std::move(stop), answers = std::move(answers)] {
    answers.ended(make_lines(work, stop, answers));
  });
}

}  // namespace cusp::ui
