// The desktop's way into an attempt and out of it.

#include <QApplication>
#include <QKeyEvent>
#include <algorithm>

#include "device/hid/hid_station.h"
#include "ui/app/desktop.h"
#include "ui/device/space_mouse_turner.h"
#include "ui/drill/drill_screen.h"
#include "ui/modules.h"
#include "ui/render/opengl_allowed.h"
#include "ui/text/names.h"
#include "ui/session/replay.h"
#include "ui/settings/device_settings.h"
#include "ui/student/briefing.h"
#include "ui/student/course.h"
#include "ui/student/thumbnail_cache.h"
#include "ui/text/device_text.h"
#include "ui/view/tooth_view.h"

namespace cusp::ui {

namespace {

/// Whether the assignment's rules refuse the attempt. Any other failure is one of the records: they may admit it the next moment.
bool is_refusal(const StorageFailure& why) {
  return why.code == StorageError::wrong_state || why.code == StorageError::other_device || why.code == StorageError::self_test_due ||
         why.code == StorageError::not_allowed;
}

/// The practice assignment that an attempt at this exercise counts for; none: nothing is assigned, or it does not admit one now.
Stored<std::optional<AssignmentId>> open_practice(Store& store, const Actor& student, const Exercise& exercise, const std::string& device_class) {
  if (exercise.version.is_nil()) return std::optional<AssignmentId>();
  const auto assigned = store.assignments.for_student(student.id);
  if (!assigned) return std::unexpected(assigned.error());
  for (const Assignment& a : *assigned) {
    if (a.kind != SessionKind::practice || a.version != exercise.version) continue;
    NewSession wanted;
    wanted.student = student.id;
    wanted.version = a.version;
    wanted.assignment = a.id;
    wanted.header.device.device_class = device_class;
    const auto admitted = store.sessions.admit(student, wanted);
    if (admitted) return std::optional(a.id);
    if (!is_refusal(admitted.error())) return std::unexpected(admitted.error());
  }
  return std::optional<AssignmentId>();
}

/// uncounted_text() of an exercise in the version that is drilled.
QString uncounted_text_of(Store& store, const Actor& student, const Exercise& exercise, const std::string& device_class) {
  const auto course = load_course(store, student);
  if (!course) return {};  // then drill() gives the reason
  const auto same = [&exercise](const CourseRow& row) {
    return row.exercise.scenario.id == exercise.scenario.id && row.exercise.version == exercise.version;
  };
  const auto row = std::ranges::find_if(course->rows, same);
  return row == course->rows.end() ? QString() : uncounted_text(*row, device_class);
}

}  // namespace

void Desktop::show_briefing(const Exercise& exercise) {
  const auto folder = exercise_folder(*store_, exercise, volume_folder());
  if (!folder) return show_failure(describe(folder.error()));
  const Actor student = account_->actor();
  const auto refusal = why_no_practice(*store_, student, exercise.scenario.id);
  auto* briefing = new Briefing(exercise, *pictures_, *folder, teeth_, refusal ? refusal->line() : QString());
  briefing->show_uncounted(uncounted_text_of(*store_, student, exercise, device_class()));
  connect(briefing, &Briefing::back_wanted, this, &Desktop::back);
  connect(briefing, &Briefing::start_wanted, this, &Desktop::drill);
  connect(briefing, &Briefing::reference_opened, this, &Desktop::lead_views);
  push(briefing);
}

void Desktop::look_at_briefing() {
  auto* briefing = qobject_cast<Briefing*>(page());
  if (briefing != nullptr && account_) briefing->show_uncounted(uncounted_text_of(*store_, account_->actor(), briefing->exercise(), device_class()));
}

DrillScreen* Desktop::open_drilling(const SessionPlan& plan, const DrillText& text) {
  pictures_->stop();
  auto* screen = new DrillScreen(ports_);
  screen->keep_settings_in(&settings_);
  const DeviceChoice device = DeviceSettings(settings_.file()).choice();
  screen->use_device(device);
  screen->use_teeth(teeth_);
  connect(screen, &DrillScreen::left_unmarked, this, [this](const SessionId& session) { unmarked_.push_back(session); });
  connect(screen, &DrillScreen::left, this, &Desktop::back);
  connect(screen, &DrillScreen::failed, this, [this, kind = device.kind](const SessionFailure& failure) {
    back();
    show_failure(describe_on_device(failure, kind));
  });
  push(screen);
  for (SpaceMouseTurner* turner : screen->findChildren<SpaceMouseTurner*>()) {
    connect(turner, &SpaceMouseTurner::moved, screen, &DrillScreen::count_input);
    connect(turner, &SpaceMouseTurner::mirror_asked, screen, [screen] {
      QKeyEvent mirror(QEvent::KeyPress, Qt::Key_2, Qt::NoModifier);  // so that the tool bar shows it too
      QApplication::sendEvent(screen, &mirror);
    });
  }
  SessionPlan with_pedal = plan;
  if (hid_) {
    with_pedal.pedal = hid_->pedal_source();
    screen->watch_pedal([hid = hid_] { return hid->pedal().view().connected; });
  }
  screen->begin(std::move(with_pedal), text);
  return screen;
}

void Desktop::mark_left() {
  std::erase_if(unmarked_, [this](const SessionId& session) {
    const auto marked = store_->sessions.interrupt(session, "left");
    return marked || marked.error().code == StorageError::wrong_state;  // else another one has marked it
  });
}

bool Desktop::refuse_drilling() {
  if (opengl_allowed()) return false;
  show_failure({tr("Nothing can be drilled now."), ToothView::pictures_off() + u' ' + tr("The next start tries them again.")});
  return true;
}

bool Desktop::refuse_practice(ScenarioId exercise) {
  if (!account_) return false;
  const auto why = why_no_practice(*store_, account_->actor(), exercise);
  if (why) show_failure(*why);
  return why.has_value();
}

void Desktop::drill(const Exercise& exercise) {
  if (refuse_drilling() || refuse_practice(exercise.scenario.id)) return;
  SessionPlan plan;
  QString aside = tr("Try it: nothing is kept");
  if (account_) {
    plan.database = database_;
    plan.student = account_->actor();
    const auto assignment = open_practice(*store_, account_->actor(), exercise, device_class());
    if (!assignment) return show_failure(unread_practice(assignment.error()));  // the attempt would count for nothing that is assigned
    plan.assignment = *assignment;
    const auto attempts = store_->history.attempts(account_->actor(), account_->id, exercise.scenario.id);
    if (!attempts) return show_failure(unread_practice(attempts.error()));
    const bool uncounted = !plan.assignment && !uncounted_text_of(*store_, account_->actor(), exercise, device_class()).isEmpty();
    aside = (uncounted ? tr("Practice, attempt %1, not counted") : tr("Practice, attempt %1")).arg(*attempts + 1);
  } else {
    plan.kind = SessionKind::try_it;
  }
  show_drilling(exercise, std::move(plan), aside);
}

void Desktop::ask_start_code(const AssignedAssessment& assessment, AssessmentStart::Purpose purpose, std::function<void(const QString& code)> then) {
  auto* question = new AssessmentStart(*store_, account_->actor(), assessment, device_class(), purpose, page());  // goes with who is signed in
  connect(question, &AssessmentStart::admitted, this, std::move(then));
  question->open();
}

void Desktop::sit(const AssignedAssessment& assessment) {
  if (refuse_drilling()) return;
  ask_start_code(assessment, AssessmentStart::Purpose::start, [this, assessment](const QString& code) {
    SessionPlan plan;
    plan.database = database_;
    plan.student = account_->actor();
    plan.kind = SessionKind::assessment;
    plan.guidance = Guidance::silent;
    plan.assignment = assessment.assignment.id;
    plan.start_code = code.toStdString();
    plan.drawn_tooth = assessment.assignment.drawn_tooth;
    const QString candidate = QString::fromStdString(candidate_number(assessment.assignment.id, account_->id));
    use_text(assessment.adjustment.large_text ? TextSize::large : TextSize::usual);
    show_drilling(assessment.exercise, std::move(plan), tr("Assessment, candidate %1").arg(candidate));
  });
}

void Desktop::resume_attempt(const SessionId& session) {
  if (refuse_drilling()) return;
  const auto details = store_->history.details(account_->actor(), session);
  if (!details) return show_failure(describe(details.error()));
  // The exercise as it was then: a newer version may have another target.
  const auto version = store_->scenarios.version(details->session.version);
  if (!version) return show_failure(describe(version.error()));
  auto scenario = exercise_of(details->session, *version);
  if (!scenario) return show_failure(describe(scenario.error()));
  SessionPlan plan;
  plan.database = database_;
  plan.student = account_->actor();
  plan.resumes = session;
  plan.kind = details->session.kind;
  const Exercise exercise{std::move(*scenario), version->id, version->number, version->files};
  if (plan.kind == SessionKind::assessment) return resume_assessment(*details, exercise, std::move(plan));
  if (refuse_practice(exercise.scenario.id)) return;
  use_text(details->session.header.large_text ? TextSize::large : TextSize::usual);
  show_drilling(exercise, std::move(plan), tr("Practice, attempt %1, continued").arg(details->row.attempt));
}

void Desktop::resume_assessment(const SessionDetails& attempt, const Exercise& exercise, SessionPlan plan) {
  const SessionHeader& header = attempt.session.header;
  const auto assignment = store_->assignments.find(attempt.session.assignment.value_or(AssignmentId{}));
  if (!assignment) return show_failure(describe(assignment.error()));
  AssignedAssessment assessment{*assignment, exercise};
  assessment.adjustment = {header.extra_time_percent, header.large_text};
  plan.guidance = Guidance::silent;
  ask_start_code(assessment, AssessmentStart::Purpose::resume, [this, assessment, plan](const QString& code) {
    SessionPlan with_code = plan;
    with_code.start_code = code.toStdString();
    const QString candidate = QString::fromStdString(candidate_number(assessment.assignment.id, account_->id));
    use_text(assessment.adjustment.large_text ? TextSize::large : TextSize::usual);
    show_drilling(assessment.exercise, std::move(with_code), tr("Assessment, candidate %1, continued").arg(candidate));
  });
}

void Desktop::show_drilling(const Exercise& exercise, SessionPlan plan, const QString& aside) {
  plan.scenario = exercise.scenario;
  plan.version = exercise.version;
  const auto folder = exercise_folder(*store_, exercise, volume_folder());
  if (!folder) return show_failure(describe(folder.error()));
  plan.scenario_folder = *folder;
  const DrillText text{local(exercise.scenario.title), aside};
  DrillScreen* screen = open_drilling(plan, text);
  connect(screen, &DrillScreen::finished, this, [this, exercise, resumed = !plan.resumes.is_nil()](std::shared_ptr<const SessionResult> result) {
    back();
    // What broke off may be of an older version: another attempt is drilled in the one that counts now.
    end_attempt(result, resumed && account_ ? exercise_to_drill(*store_, account_->actor(), exercise.scenario.id) : exercise);
  });
}

}  // namespace cusp::ui
