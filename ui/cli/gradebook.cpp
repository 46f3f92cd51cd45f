#include "ui/cli/gradebook.h"

#include <QStringList>
#include <algorithm>

#include "storage/base/clock.h"
#include "ui/cli/text.h"
#include "ui/text/language.h"

namespace cusp::ui {
namespace {

/// "--kind practice --due 2026-12-11T18:00:00Z", as it is typed; what is not named is left out.
QString options_text(const std::optional<SessionKind>& kind, const std::optional<std::string>& due) {
  QStringList parts;
  if (kind) parts += QStringLiteral("--kind ") + QString::fromStdString(std::string(key_of(*kind)));
  if (due) parts += QStringLiteral("--due ") + QString::fromStdString(*due);
  return parts.join(u' ');
}
QString options_text(const Assignment& a) { return options_text(a.kind, a.due_utc_us ? iso_utc(*a.due_utc_us) : kNoDueDate); }

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
    if (wish.kind && a.kind != *wish.kind) continue;
    if (!wish.due || is_due(a, *wish.due)) out.push_back(a);
  }
  // A withdrawn one counts where it is the only one: its results stay.
  if (!std::ranges::all_of(out, &Assignment::withdrawn)) std::erase_if(out, &Assignment::withdrawn);
  return out;
}

}  // namespace

Result<AssignedGradebook, Message> gradebook_of(Store& store, const Actor& actor, const GradebookWish& wish) {
  const auto found = assignments_of(store, wish);
  if (!found) return std::unexpected(describe(found.error()));
  const QString exercise = QString::fromStdString(wish.exercise), cohort = QString::fromStdString(wish.cohort_typed);
  if (found->empty()) {
    const QString options = options_text(wish.kind, wish.due);
    //: %3: options as they are typed, such as "--kind practice --due none".
    return std::unexpected(Message{options.isEmpty() ? CliText::tr("“%1” is not assigned to “%2”.").arg(exercise, cohort)
                                                     : CliText::tr("“%1” is not assigned to “%2” with %3.").arg(exercise, cohort, options),
                                   {}});
  }
  if (found->size() > 1) {
    QStringList each;
    for (const Assignment& a : *found) each.append(options_text(a));
    //: %3: options as they are typed, such as "--kind practice --due none".
    return std::unexpected(Message{CliText::tr("“%1” is assigned to “%2” more than once: say which, by %3.")
                                       .arg(exercise, cohort, each.join(QStringLiteral(", "))),
                                   {}});
  }
  auto file = make_gradebook(store.context(), actor, found->front().id, wish.system, current_language().toStdString());
  if (!file) return std::unexpected(describe(file.error()));
  return AssignedGradebook{found->front().id, std::move(*file)};
}

}  // namespace cusp::ui
