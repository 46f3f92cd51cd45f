// The desktop's way to a report: from an attempt that has just ended, or from the records.

#include <QApplication>
#include <QPointer>
#include <QThreadPool>
#include <QTimer>

#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/drill/drill_screen.h"
#include "ui/instructor/assessment_page.h"
#include "ui/report/marking_card.h"
#include "ui/report/report_page.h"
#include "ui/session/records_task.h"
#include "ui/session/replay.h"
#include "ui/student/course.h"
#include "ui/student/self_assessment_page.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

/// A result with its report, or the message of a failure.
struct Opened {
  std::shared_ptr<const SessionResult> result;
  ReportData report;
  Message message;
};

/// Of may_read_result(): any other failure is one of the records.
bool is_withheld(const StorageFailure& why) { return why.code == StorageError::not_allowed; }

Opened open_in_background(const OwnStore& store, const SessionId& session, const Actor& reader, Keep keep) {
  if (!store) return {nullptr, {}, describe(store.error())};
  auto result = open_result(**store, session, keep);
  if (!result) return {nullptr, {}, describe(result.error())};
  auto shared = std::make_shared<const SessionResult>(std::move(*result));
  return {shared, gather_report(*shared, store->get(), &reader), {}};
}

}  // namespace

void Desktop::open_report(const SessionId& session) {
  const auto state = store_->sessions.state(session);
  if (state && *state == SessionState::running) return show_failure(describe(StorageFailure{StorageError::wrong_state, "session", session.text()}));
  const auto readable = store_->history.may_read_result(account_->actor(), session);
  if (readable) {
    const bool grades_it = !reading_only_ && store_->history.lacks_grade(account_->actor(), session).value_or(false);
    return grades_it ? open_result_page(session, Keep::grade, NotKept::opens) : open_result_page(session, Keep::nothing);
  }
  if (!is_withheld(readable.error())) return show_failure(describe(readable.error()));
  if (state && *state == SessionState::interrupted && !reading_only_) return shell_->show_page(u"start"_qs);
  show_handed_in(session);
}

void Desktop::grade_interrupted(const SessionId& session) {
  const auto kept = store_->sessions.find(session);
  if (!kept) return show_failure(describe(kept.error()));
  const Question question =
      kept->kind == SessionKind::assessment
          ? Question{DrillScreen::tr("Hand in?"), DrillScreen::tr("The tooth is kept as it is now; nothing can be changed afterwards."), DrillScreen::tr("Hand in")}
          : Question{tr("Grade this attempt as it stands?"), tr("It is then over and cannot be continued."), tr("Grade")};
  ports_.ask(page(), question, [this, session](bool yes) {
    if (yes) open_result_page(session, Keep::grade);
  });
}

QWidget* Desktop::push_waiting(const QString& doing, Busy::Cancel cancel) {
  auto* busy = new Busy;
  QWidget* waiting = make_page(busy);
  connect(busy, &Busy::shown, busy, &Busy::focus_cancel);
  connect(busy, &Busy::cancelled, this, &Desktop::back);
  push(waiting);
  busy->start(doing, cancel);
  return waiting;
}

void Desktop::open_result_page(const SessionId& session, Keep keep, NotKept not_kept) {
  QWidget* waiting = keep == Keep::grade ? push_waiting(tr("Measuring the tooth"), Busy::Cancel::none)
                                         : push_waiting(tr("Opening the report"), Busy::Cancel::offered);
  QThreadPool::globalInstance()->start([this, session, keep, not_kept, reader = account_->actor(), waiting = QPointer<QWidget>(waiting), opener = open_, database = database_, options = beside()] {
    const OwnStore store = opener(database, options);
    auto opened = std::make_shared<Opened>(open_in_background(store, session, reader, keep));
    if (!opened->result && not_kept == NotKept::opens) *opened = open_in_background(store, session, reader, Keep::nothing);
    QMetaObject::invokeMethod(
        qApp,
        [this, opened, waiting] {
          // Whoever signed out meanwhile has taken the page with them.
          if (!waiting || page() != waiting) return;
          if (!opened->result) {
            show_failure(opened->message);
            return drop(waiting);
          }
          const std::optional<Exercise> exercise = exercise_to_drill(*store_, account_->actor(), opened->result->scenario.id);
          if (awaits_own_assessment(*opened->result)) {
            end_attempt(opened->result, exercise);
            return drop(waiting);
          }
          if (const auto readable = store_->history.may_read_result(account_->actor(), opened->result->session); !readable) {
            is_withheld(readable.error()) ? show_handed_in(opened->result->session) : show_failure(describe(readable.error()));
            return drop(waiting);
          }
          show_report(opened->result, std::move(opened->report), exercise);
          drop(waiting);
        },
        Qt::QueuedConnection);
  });
}

void Desktop::show_assignment(AssignmentId assignment) {
  auto* page = new AssessmentPage(*store_, account_->actor(), assignment, ports_);
  connect(page, &AssessmentPage::back_wanted, this, &Desktop::back);
  connect(page, &AssessmentPage::report_wanted, this, &Desktop::open_report);
  push(page);
}

void Desktop::show_handed_in(const SessionId& session) {
  const auto kept = store_->sessions.find(session);
  const QString candidate = kept && kept->assignment
                                ? QString::fromStdString(candidate_number(*kept->assignment, kept->student))
                                : QString();
  if (kept && kept->header.large_text) use_text(TextSize::large);
  auto* page = new HandedIn(candidate);
  connect(page, &HandedIn::start_wanted, this, &Desktop::back);
  connect(page, &HandedIn::next_wanted, this, &Desktop::sign_out);
  push(page);
}

void Desktop::gather(const std::shared_ptr<const SessionResult>& result, QWidget* shown, std::function<void(ReportData gathered)> then) {
  gathering_ = with_own_store(*store_, [this, number = ++gathered_, result, reader = account_->actor(), shown = QPointer(shown), then = std::move(then)](OwnStore own) {
    auto gathered = std::make_shared<ReportData>(gather_report(*result, own ? own->get() : nullptr, &reader));
    if (!own) gathered->unread = own.error();
    QMetaObject::invokeMethod(
        qApp,
        [this, number, shown, then, gathered] {
          if (shown && number == gathered_) then(std::move(*gathered));
        },
        Qt::QueuedConnection);
  }, BackgroundTask::Holds::nothing);
}

bool Desktop::awaits_own_assessment(const SessionResult& result) {
  if (!account_ || !store_ || reading_only_ || result.session.is_nil() || !result.scenario.self_assessment) return false;
  const auto session = store_->sessions.find(result.session);
  if (!session || session->student != account_->id) return false;
  // A released assessment takes none (Statements::assess_own).
  if (session->kind == SessionKind::assessment && store_->history.may_read_result(account_->actor(), result.session)) return false;
  const auto given = store_->statements.self_assessment(account_->actor(), result.session);
  return given && !*given;
}

void Desktop::end_attempt(const std::shared_ptr<const SessionResult>& result, const std::optional<Exercise>& exercise) {
  if (!awaits_own_assessment(*result)) return show_result(result, exercise);
  const auto session = store_->sessions.find(result->session);
  if (session && session->header.large_text) use_text(TextSize::large);
  const bool readable = store_->history.may_read_result(account_->actor(), result->session).has_value();
  auto* page = new SelfAssessmentPage(result->scenario, readable ? SelfAssessmentPage::Then::result : SelfAssessmentPage::Then::handed_in,
                                      tissue_names_of(*result));
  const auto go_on = [this, page, result, exercise] {
    show_result(result, exercise);
    drop(page);
  };
  const auto keep = [this, page, result, go_on](const SelfAssessment& own) {
    const auto stated = store_->statements.assess_own(account_->actor(), result->session, own);
    if (!stated) return page->show_failure(describe(stated.error()));
    go_on();
  };
  connect(page, &SelfAssessmentPage::passed_over, this, go_on);
  connect(page, &SelfAssessmentPage::decided, this, [this, page, keep](const SelfAssessment& own) {
    if (!own.skipped() || !page->half_filled()) return keep(own);
    const Question question{tr("Skip the own assessment?"), tr("Your ratings are then not kept, and you cannot rate this attempt later."), tr("Skip"), true};
    ports_.ask(page, question, [keep, shown = QPointer(page)](bool yes) {
      if (shown && yes) keep({});
    });
  });
  push(page);
}

void Desktop::show_result(std::shared_ptr<const SessionResult> result, std::optional<Exercise> exercise) {
  const bool kept = account_ && store_ && !result->session.is_nil();
  if (!kept) return show_report(result, gather_report(*result, nullptr, nullptr), exercise);
  if (const auto readable = store_->history.may_read_result(account_->actor(), result->session); !readable) {
    return is_withheld(readable.error()) ? show_handed_in(result->session) : show_failure(describe(readable.error()));
  }
  QWidget* waiting = push_waiting(tr("Opening the report"), Busy::Cancel::offered);
  gather(result, waiting, [this, waiting, result, exercise](ReportData gathered) {
    if (page() != waiting) return;
    show_report(result, std::move(gathered), exercise);
    drop(waiting);
  });
}

void Desktop::show_report(const std::shared_ptr<const SessionResult>& result, ReportData gathered, const std::optional<Exercise>& exercise) {
  const bool signed_in = account_.has_value();
  const Actor reader = signed_in ? account_->actor() : Actor{};
  bool own = !signed_in;
  if (signed_in && store_ && !result->session.is_nil()) {
    const auto details = store_->history.details(reader, result->session);
    own = details && details->row.student == reader.id;
    if (own && details->session.header.large_text) use_text(TextSize::large);
  }
  const QString back_name = !signed_in ? tr("Sign in") : tr("Back");
  auto again = own && exercise && !reading_only_ ? ReportPage::TryAgain::offered : ReportPage::TryAgain::hidden;
  const bool assessed = gathered.kind == SessionKind::assessment;
  if (again == ReportPage::TryAgain::offered && assessed && why_no_practice(*store_, reader, exercise->scenario.id)) again = ReportPage::TryAgain::refused;
  auto* report = new ReportPage(std::move(gathered), ports_, again, back_name);
  connect(report, &ReportPage::back_wanted, this, &Desktop::back);
  if (exercise) {
    connect(report, &ReportPage::try_again_wanted, this, [this, exercise = *exercise] {
      back();
      drill(exercise);
    });
  }
  if (signed_in && !reading_only_ && may(reader.role, Action::comment) && report->data().counts) {
    // In the next turn of the event loop: report and card together hold the window for 0.1 s.
    QTimer::singleShot(0, report, [this, report, result] {
      if (account_) add_marking(*report, result);
    });
  }
  const bool packs = signed_in && !reading_only_ && may(reader.role, Action::export_results) && report->data().counts;
  if (packs) offer_pack(*report);
  push(report);
}

void Desktop::add_marking(ReportPage& report, const std::shared_ptr<const SessionResult>& result) {
  auto* marking = new MarkingCard(*store_, account_->actor(), report.data(), ports_);
  give_back_comment(*marking);
  report.set_card(marking);
  const auto choose = [&report, marking] { marking->set_criterion(report.chosen_criterion()); };
  choose();
  connect(&report, &ReportPage::criterion_chosen, marking, choose);
  connect(marking, &MarkingCard::stated, &report, [this, &report, marking, result] {
    gather(result, &report, [&report, marking](ReportData fresh) {
      marking->show_data(fresh);
      report.show_data(std::move(fresh));
    });
  });
}

}  // namespace cusp::ui
