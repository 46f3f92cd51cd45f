// What the cohorts' page assigns: the form's wish as an assignment, and what became of it.

#include <algorithm>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "ui/instructor/cohorts_page.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"

namespace cusp::ui {
namespace {

std::optional<std::int64_t> utc_us(const std::optional<QDateTime>& when) {
  return when ? std::optional(when->toMSecsSinceEpoch() * 1000) : std::nullopt;
}

/// Equal in all that the form has but the start code, which is drawn anew each time. A withdrawn one may be assigned again.
bool is_same_task(const Assignment& stored, Assignment fresh) {
  if (stored.withdrawn) return false;
  std::ranges::sort(fresh.device_classes);  // as Assignments::create() stores them
  return stored.version == fresh.version && stored.kind == fresh.kind && stored.opens_utc_us == fresh.opens_utc_us &&
         stored.due_utc_us == fresh.due_utc_us && stored.attempts_allowed == fresh.attempts_allowed &&
         stored.device_classes == fresh.device_classes && stored.self_test_days == fresh.self_test_days &&
         stored.drawn_tooth == fresh.drawn_tooth;
}

}  // namespace

std::optional<Assignment> CohortsPage::assignment_for(const AssignmentForm::Wish& wish, CohortId cohort) {
  Assignment fresh;
  fresh.cohort = cohort;
  fresh.version = wish.exercise.version;
  if (fresh.version.is_nil()) {
    const Scenario& scenario = wish.exercise.scenario;
    const auto version = store_.scenarios.ensure(scenario, canonical_json(scenario), content_hash(scenario).bytes);
    if (!version) {
      show_failure(version.error());
      return std::nullopt;
    }
    fresh.version = version->id;
  }
  fresh.opens_utc_us = utc_us(wish.opens);
  fresh.due_utc_us = utc_us(wish.due);
  fresh.attempts_allowed = wish.attempts;
  fresh.device_classes = wish.device_classes;
  fresh.self_test_days = wish.self_test_days;
  fresh.drawn_tooth = wish.drawn_tooth;
  fresh.kind = wish.kind;
  return fresh;
}

void CohortsPage::read_exercises() {
  if (form_ == nullptr) return;
  auto list = load_exercises(store_);
  if (!list) return show_failure(list.error());
  form_->set_exercises(std::move(list->exercises));
}

void CohortsPage::show_withdrawn(const Exercise& exercise) {
  read_exercises();
  const QString title = local(exercise.scenario.title);
  const Exercise* now = form_->find(exercise.scenario.id);
  band_->show_message(Band::Kind::bad, tr("Version %1 of %2 was withdrawn meanwhile: nothing is assigned.").arg(number_of(exercise)).arg(title),
                      now != nullptr ? tr("The form has version %1 now. Press Assign to assign that.").arg(number_of(*now))
                                     : tr("The form no longer has this exercise. Choose another one."));
}

void CohortsPage::assign() {
  const auto cohort = chosen();
  if (!cohort || form_ == nullptr) return;
  if (!form_->has_exercise()) {
    band_->show_message(Band::Kind::bad, tr("No exercise is chosen."), tr("Choose one in the form."));
    return;
  }
  const AssignmentForm::Wish wish = form_->wish();
  if (wish.opens && wish.due && *wish.opens >= *wish.due) {
    band_->show_message(Band::Kind::bad, tr("It would be due before it opens."), tr("Choose a later day for Due."));
    return;
  }
  if (wish.due && *wish.due <= ports_.now()) {
    band_->show_message(Band::Kind::bad, tr("Its time would be over already."), tr("Choose a later day for Due."));
    return;
  }
  if (wish.admits_none) {
    band_->show_message(Band::Kind::bad, tr("No device is admitted."), tr("Check one device at least."));
    return;
  }
  const auto fresh = assignment_for(wish, cohort->id);
  if (!fresh) return;
  const auto withdrawn = store_.scenarios.withdrawn(fresh->version);
  if (!withdrawn) return show_failure(withdrawn.error());
  if (*withdrawn) return show_withdrawn(wish.exercise);  // an earlier assignment of it reaches no student either
  const auto there = store_.assignments.for_cohort(cohort->id);
  if (!there) return show_failure(there.error());
  const QString title = local(wish.exercise.scenario.title), name = QString::fromStdString(cohort->name);
  if (std::ranges::any_of(*there, [&](const Assignment& one) { return is_same_task(one, *fresh); })) {
    band_->show_message(Band::Kind::look, tr("%1 is assigned to %2 already.").arg(title, name),
                        tr("An open assignment has the same kind, days, attempts and devices. Change one of them to assign it again."));
    return;
  }
  if (const auto made = store_.assignments.create(actor_, *fresh, wish.start_code.toStdString()); !made) {
    return made.error().where == "version_withdrawn" ? show_withdrawn(wish.exercise) : show_failure(made.error());
  }
  show_assignments();
  const bool assessment = wish.kind == SessionKind::assessment;
  if (assessment) form_->draw_start_code();
  form_->disable_act();
  band_->show_message(Band::Kind::good, tr("%1 is assigned to %2.").arg(title, name),
                      assessment ? tr("The start code is %1.").arg(wish.start_code) : tr("It stands on the start page of its students."));
}

}  // namespace cusp::ui
