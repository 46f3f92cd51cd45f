#include "ui/student/assessments.h"

#include <QBoxLayout>
#include <QDateTime>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>

#include "ui/render/opengl_allowed.h"
#include "ui/session/session_setup.h"
#include "ui/student/interrupted_card.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

using State = AssignedAssessment::State;

/// So long a missed assessment is shown: 30 days.
constexpr std::int64_t kMissedShownUs = 30 * std::int64_t{86'400'000'000};

/// This station's device, and its newest self-test.
struct Device {
  std::string device_class;
  std::optional<DeviceTest> test;
};

bool holds(const std::vector<HistoryRow>& rows, const SessionId& session) {
  return std::ranges::find(rows, session, &HistoryRow::session) != rows.end();
}

/// `here`: the student's interrupted attempts that this station can continue or hand in.
State state_of(const Assignment& a, const std::vector<HistoryRow>& attempts, const std::vector<HistoryRow>& here, std::int64_t now_us,
               const Device& device) {
  if (std::ranges::any_of(attempts, [&](const HistoryRow& row) { return holds(here, row.session); })) return State::interrupted;
  const auto in_state = [&](SessionState state) { return std::ranges::find(attempts, state, &HistoryRow::state) != attempts.end(); };
  if (in_state(SessionState::running)) return State::running;
  if (in_state(SessionState::interrupted)) return State::broken_off;
  if (a.withdrawn) return State::handed_in;
  if (a.due_utc_us && now_us >= *a.due_utc_us) return attempts.empty() ? State::missed : State::handed_in;
  if (a.attempts_allowed && static_cast<int>(attempts.size()) >= *a.attempts_allowed) return State::handed_in;
  if (a.opens_utc_us && now_us < *a.opens_utc_us) return State::later;
  if (!storage::admits(a.device_classes, device.device_class)) return State::other_device;
  return a.self_test_days && !is_recent(device.test, *a.self_test_days, now_us) ? State::self_test_due : State::open;
}

/// `here`: as of state_of().
bool can_continue(Store& store, const std::vector<HistoryRow>& attempts, const std::vector<HistoryRow>& here, const std::string& device_class) {
  return opengl_allowed() && std::ranges::any_of(attempts, [&](const HistoryRow& row) {
    if (!holds(here, row.session)) return false;
    const auto way = way_of(store, row, device_class);
    return way && *way == InterruptedWay::resume;
  });
}

QString state_text(const AssignedAssessment& a) {
  const auto day = [](std::int64_t us) { return format_day_time(local_time(us)); };
  switch (a.state) {
    case State::later: return AssessmentCard::tr("Opens %1").arg(day(*a.assignment.opens_utc_us));
    case State::open:
      return a.assignment.due_utc_us ? AssessmentCard::tr("Open until %1").arg(day(*a.assignment.due_utc_us))
                                     : AssessmentCard::tr("Open");
    case State::other_device: return AssessmentCard::tr("Needs another device");
    case State::self_test_due: return AssessmentCard::tr("Needs a newer self-test");
    case State::running: return AssessmentCard::tr("Runs in another window");
    case State::interrupted:
      return a.resumable ? AssessmentCard::tr("Interrupted: continue it below") : AssessmentCard::tr("Interrupted: see below");
    case State::broken_off: return AssessmentCard::tr("Interrupted: ask the invigilator");
    case State::handed_in: return AssessmentCard::tr("Handed in: the result is not released yet");
    case State::missed: return AssessmentCard::tr("The time is over");
  }
  return {};
}

Chip::Kind state_kind(State state) {
  switch (state) {
    case State::open:
    case State::running:
    case State::interrupted:
    case State::broken_off: return Chip::Kind::look;
    case State::other_device:
    case State::self_test_due: return Chip::Kind::bad;
    case State::handed_in: return Chip::Kind::good;
    default: return Chip::Kind::plain;
  }
}

QString attempts_text(const AssignedAssessment& a) {
  return a.assignment.attempts_allowed
             ? AssessmentCard::tr("Attempts used: %1 of %2").arg(a.attempts).arg(*a.assignment.attempts_allowed)
             : AssessmentCard::tr("%n attempt(s) so far", nullptr, a.attempts);
}

/// Sessions::admit() compares the start code before it refuses for one of these.
bool knows_code(const StorageFailure& f) {
  return f.code == StorageError::wrong_state || f.code == StorageError::other_device || f.code == StorageError::self_test_due;
}

}  // namespace

/// With the student's extra time.
QString time_limit_text(const AssignedAssessment& a) {
  const double limit_s = a.exercise.scenario.time_limit_s;
  if (limit_s <= 0) return {};
  const QString text = duration_text(extended_limit_s(limit_s, a.adjustment.extra_time_percent));
  if (a.adjustment.extra_time_percent == 0) return text;
  return AssessmentCard::tr("%1 (%2 % extra time)").arg(text).arg(a.adjustment.extra_time_percent);
}

Stored<AssignedAssessments> load_assessments(Store& store, const Actor& student, const QDateTime& now, const std::string& device_class) {
  const auto assigned = store.assignments.for_student(student.id);
  if (!assigned) return std::unexpected(assigned.error());
  auto newest = store.device_tests.newest(device_class);
  if (!newest) return std::unexpected(newest.error());
  const Device device{device_class, std::move(*newest)};
  const auto here = store.history.interrupted(student, student.id);
  if (!here) return std::unexpected(here.error());
  const std::int64_t now_us = now.toMSecsSinceEpoch() * 1000;
  AssignedAssessments out;
  for (const Assignment& a : *assigned) {
    if (a.kind != SessionKind::assessment) continue;
    const auto attempts = store.history.of_assignment(student, a.id);
    if (!attempts) return std::unexpected(attempts.error());
    const auto withdrawn = store.scenarios.withdrawn(a.version);
    if (!withdrawn) return std::unexpected(withdrawn.error());
    if ((*withdrawn || a.withdrawn) && attempts->empty()) continue;
    auto exercise = load_exercise(store, a.version);
    if (!exercise) {
      const bool over = *withdrawn || a.withdrawn || (a.due_utc_us && now_us >= *a.due_utc_us);
      out.unreadable += over ? 0 : 1;
      continue;
    }
    AssignedAssessment one{a, std::move(*exercise), static_cast<int>(attempts->size())};
    const auto adjustment = store.assignments.adjustment(a.id, student.id);
    if (!adjustment) return std::unexpected(adjustment.error());
    one.adjustment = *adjustment;
    one.state = state_of(a, *attempts, *here, now_us, device);
    if (one.state == State::interrupted) one.resumable = can_continue(store, *attempts, *here, device_class);
    const bool every_released = !attempts->empty() && std::ranges::all_of(*attempts, &HistoryRow::released);
    if (one.state == State::handed_in && every_released) continue;  // it stands among the results
    if (one.state == State::missed && now_us - *a.due_utc_us > kMissedShownUs) continue;
    out.shown.push_back(std::move(one));
  }
  std::ranges::stable_partition(out.shown, [](const AssignedAssessment& a) { return a.state != State::missed && a.state != State::handed_in; });
  return out;
}

std::optional<Message> why_no_practice(Store& store, const Actor& student, ScenarioId exercise) {
  const auto here = store.history.interrupted(student, student.id);
  if (!here) return unread_practice(here.error());
  HistoryFilter same;
  same.student = student.id;
  same.scenario = exercise;
  const auto attempts = store.history.list(student, same);
  if (!attempts) return unread_practice(attempts.error());
  const auto any_assessment = [&attempts](const auto& is) {
    return std::ranges::any_of(*attempts, [&is](const HistoryRow& row) { return row.kind == SessionKind::assessment && is(row); });
  };
  const QString what = AssessmentCard::tr("Your assessment of this exercise is not handed in yet.");
  if (any_assessment([&here](const HistoryRow& row) { return holds(*here, row.session); })) {
    return Message{what, AssessmentCard::tr("Until then the exercise cannot be practised. Continue the assessment or hand it in on the start page.")};
  }
  if (any_assessment([](const HistoryRow& row) { return row.state == SessionState::running; })) {
    return Message{what, AssessmentCard::tr("It runs in another window. Until it is handed in there, the exercise cannot be practised.")};
  }
  return std::nullopt;
}

Message unread_practice(const StorageFailure& why) {
  return {AssessmentCard::tr("This exercise cannot be practised now."),
          AssessmentCard::tr("Try again; if that does not help, ask your instructor. Your assignments or attempts could not be read: %1").arg(describe(why).line())};
}

AssessmentCard::AssessmentCard(const AssignedAssessment& a, UserId student, const std::string& device_class, QWidget* parent)
    : Card(tr("Assessment"), tr("Candidate %1").arg(QString::fromStdString(candidate_number(a.assignment.id, student))), parent) {
  setAccessibleName(tr("Assessment: %1").arg(local(a.exercise.scenario.title)));
  auto* row = new QHBoxLayout;
  row->setSpacing(px(12));
  auto* text = new QVBoxLayout;
  text->setSpacing(px(4));
  QLabel* title = make_label(local(a.exercise.scenario.title), TextRole::section, Weight::bold);
  title->setWordWrap(true);
  text->addWidget(title);
  auto* line = new QHBoxLayout;
  line->setSpacing(px(8));
  line->addWidget(new Chip(state_text(a), state_kind(a.state)));
  line->addStretch();
  text->addLayout(line);
  QStringList facts = {attempts_text(a)};
  if (const QString limit = time_limit_text(a); !limit.isEmpty()) facts += tr("time limit %1").arg(limit);
  if (a.adjustment.large_text) facts += tr("large text");
  if (!a.assignment.device_classes.empty()) facts += tr("only with %1").arg(device_names(a.assignment.device_classes));
  if (a.assignment.self_test_days) facts += self_test_age(*a.assignment.self_test_days);
  if (a.assignment.drawn_tooth) facts += drawn_tooth_text();
  text->addWidget(make_paragraph(facts.join(u" · "_qs)));
  if (a.state == State::self_test_due) text->addWidget(make_paragraph(self_test_advice(device_class)));
  if (a.state == State::open && !opengl_allowed()) text->addWidget(make_paragraph(ToothView::pictures_off()));
  row->addLayout(text, 1);
  if (a.state == State::open) {
    start_ = make_large_button(tr("Start assessment"), ButtonKind::primary, u"play"_qs);
    start_->setEnabled(opengl_allowed());
    row->addWidget(start_, 0, Qt::AlignBottom);
    connect(start_, &QPushButton::clicked, this, &AssessmentCard::start_wanted);
  }
  body()->addLayout(row);
}

AssessmentStart::AssessmentStart(Store& store, const Actor& student, const AssignedAssessment& a, const std::string& device_class,
                                 Purpose purpose, QWidget* parent)
    : QDialog(parent), store_(store), student_(student), assessment_(a), device_class_(device_class), purpose_(purpose) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(purpose == Purpose::start ? tr("Start assessment") : tr("Continue assessment"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(24), px(24), px(24), px(24));
  column->setSpacing(px(12));
  band_ = new Band;
  column->addWidget(band_);
  QLabel* title = make_label(local(a.exercise.scenario.title), TextRole::section, Weight::bold);
  title->setWordWrap(true);
  column->addWidget(title);
  const QString candidate = QString::fromStdString(candidate_number(a.assignment.id, student.id));
  column->addWidget(make_paragraph(tr("You are candidate %1. Your name is not shown to who marks.").arg(candidate)));
  if (purpose == Purpose::start) {
    add_rules(*column);
  } else {
    column->addWidget(make_paragraph(tr("Tooth and clock are as you left them.")));
  }
  code_ = new QLineEdit;
  column->addWidget(labelled(tr("Start code, from the invigilator"), code_));
  auto* row = new QHBoxLayout;
  row->addStretch();
  QPushButton* cancel = make_button(tr("Cancel"));
  QPushButton* begin = make_button(purpose == Purpose::start ? tr("Begin") : tr("Continue"), ButtonKind::primary);
  begin->setDefault(true);
  row->addWidget(cancel);
  row->addWidget(begin);
  column->addLayout(row);
  setMinimumWidth(px(420));
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(begin, &QPushButton::clicked, this, &AssessmentStart::submit);
  code_->setFocus();
}

void AssessmentStart::add_rules(QVBoxLayout& column) {
  const QString limit = time_limit_text(assessment_);
  column.addWidget(make_paragraph(limit.isEmpty() ? tr("There is no time limit.")
                                                  : tr("You have %1. The clock starts with the tooth; a device fault stops it.").arg(limit)));
  column.addWidget(make_paragraph(tr("Depth, points and advice are not shown, nor is the target on a tooth. The result comes when your examiner releases it.")));
  if (!assessment_.assignment.drawn_tooth) return;
  column.addWidget(make_paragraph(tr("Your tooth is drawn for you; other candidates have others. It stays yours if you are interrupted.")));
}

void AssessmentStart::submit() {
  NewSession wanted;
  wanted.student = student_.id;
  wanted.version = assessment_.assignment.version;
  wanted.assignment = assessment_.assignment.id;
  wanted.start_code = code_->text().trimmed().toStdString();
  wanted.header.device.device_class = device_class_;
  const auto allowed = store_.sessions.admit(student_, wanted);
  if (!allowed && !(purpose_ == Purpose::resume && knows_code(allowed.error()))) {
    const Message message = describe(allowed.error());
    band_->show_message(Band::Kind::bad, message.what, message.more);
    resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
    code_->selectAll();
    code_->setFocus();
    return;
  }
  const QString code = code_->text().trimmed();
  accept();
  Q_EMIT admitted(code);
}

HandedIn::HandedIn(const QString& candidate, QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Handed in"));
  auto* column = new QVBoxLayout(this);
  column->addStretch(1);
  auto* state = new EmptyState(u"check"_qs, tr("Handed in"),
                               tr("The preparation of candidate %1 is kept. The result is shown when your examiner releases it.").arg(candidate),
                               tr("Next candidate"), Ink::good);
  column->addWidget(state);
  QPushButton* home = make_button(tr("To the start page"), ButtonKind::quiet);
  column->addWidget(home, 0, Qt::AlignCenter);
  column->addStretch(1);
  set_kind(state->button(), "primary");
  connect(state, &EmptyState::acted, this, &HandedIn::next_wanted);
  connect(home, &QPushButton::clicked, this, &HandedIn::start_wanted);
  setFocusProxy(state->button());
}

}  // namespace cusp::ui
