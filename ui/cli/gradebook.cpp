#include "ui/cli/gradebook.h"

#include <QStringList>
#include <algorithm>

#include "storage/base/clock.h"
#include "ui/cli/text.h"
#include "ui/text/language.h"

namespace cusp::ui {
namespace {

QString due_text(const Assignment& a) { return QString::fromStdString(a.due_utc_us ? iso_utc(*a.due_utc_us) : kNoDueDate); }

bool is_due(const Assignment& a, const std::string& typed) {
  if (typed == kNoDueDate) return !a.due_utc_us;
  const auto span = utc_span_of(typed);
  return span && a.due_utc_us && *a.due_utc_us >= span->begin_utc_us && *a.due_utc_us < span->end_utc_us;
}

}  // namespace

Stored<bool> is_called(Store& store, const ScenarioId& exercise, const std::string& typed) {
  if (exercise.text() == typed) return true;
  const auto versions = store.scenarios.versions(exercise);
  if (!versions) return std::unexpected(versions.error());
  return std::ranges::any_of(*versions, [&](const ScenarioVersion& v) { return !v.key.empty() && v.key == typed; });
}

namespace {

Stored<std::vector<Assignment>> assignments_of(Store& store, const GradebookWish& wish) {
  const auto all = store.assignments.for_cohort(wish.cohort);
  if (!all) return all;
  std::vector<Assignment> out;
  for (const Assignment& a : *all) {
    const auto version = store.scenarios.version(a.version);
    if (!version) return std::unexpected(version.error());
    const auto called = is_called(store, version->scenario, wish.exercise);
    if (!called) return std::unexpected(called.error());
    if (!*called || (wish.version && version->number != *wish.version)) continue;
    if (!wish.due || is_due(a, *wish.due)) out.push_back(a);
  }
  return out;
}

}  // namespace

Result<GradebookFile, Message> gradebook_of(Store& store, const Actor& actor, const GradebookWish& wish) {
  const auto found = assignments_of(store, wish);
  if (!found) return std::unexpected(describe(found.error()));
  const QString exercise = QString::fromStdString(wish.exercise), cohort = QString::fromStdString(wish.cohort_typed);
  if (found->empty()) {
    const QString due = QString::fromStdString(wish.due.value_or(std::string()));
    return std::unexpected(Message{wish.due ? CliText::tr("“%1” is not assigned to “%2”, due %3.").arg(exercise, cohort, due)
                                            : CliText::tr("“%1” is not assigned to “%2”.").arg(exercise, cohort),
                                   {}});
  }
  if (found->size() > 1) {
    QStringList dates;
    for (const Assignment& a : *found) dates.append(due_text(a));
    return std::unexpected(Message{CliText::tr("“%1” is assigned to “%2” more than once: say which with --due. Due: %3.")
                                       .arg(exercise, cohort, dates.join(QStringLiteral(", "))),
                                   {}});
  }
  auto file = export_gradebook(store.context(), actor, found->front().id, wish.system, {.language = current_language().toStdString()});
  if (!file) return std::unexpected(describe(file.error()));
  return std::move(*file);
}

}  // namespace cusp::ui
