#include "ui/instructor/exercise_use.h"

#include <QCoreApplication>
#include <QStringList>

#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::ExerciseUse)
};

}  // namespace

Stored<ExerciseUse> use_of(Store& store, const Actor& actor, ScenarioId exercise, std::int64_t now_utc_us) {
  const auto figures = store.history.figures(actor, {.scenario = exercise, .drilled_by = DrilledBy::students, .scripted = false});
  if (!figures) return std::unexpected(figures.error());
  const auto versions = store.scenarios.versions(exercise);
  if (!versions) return std::unexpected(versions.error());
  auto assigned = open_uses(store, *versions, now_utc_us);
  if (!assigned) return std::unexpected(assigned.error());
  return ExerciseUse{figures->students, figures->attempts, figures->median_score, std::move(*assigned)};
}

QString use_text(const ExerciseUse& use) {
  QStringList sentences;
  if (use.attempts == 0) {
    sentences << Text::tr("No student has a graded attempt yet.");
  } else {
    //: %1: "12 students", %2: "40 graded attempts", %3: points, of 100
    sentences << Text::tr("%1, %2, median %3 points.")
                     .arg(Text::tr("%n student(s)", nullptr, use.students), Text::tr("%n graded attempt(s)", nullptr, use.attempts),
                          format_points(use.median_score.value_or(0)));
  }
  QStringList cohorts;
  for (const OlderUse& one : use.assigned) {
    const QString cohort = isolate(QString::fromStdString(one.cohort));
    if (!cohorts.contains(cohort)) cohorts << cohort;
  }
  if (!cohorts.isEmpty()) sentences << Text::tr("Assigned now: %1.").arg(cohorts.join(Text::tr(", ")));
  return sentences.join(u' ');
}

}  // namespace cusp::ui
