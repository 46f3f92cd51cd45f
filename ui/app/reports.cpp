// The desktop's way to a report: from an attempt that has just ended, or from the records.

#include <QApplication>
#include <QThreadPool>

#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/instructor/assessment_page.h"
#include "ui/report/marking_card.h"
#include "ui/report/report_page.h"
#include "ui/session/replay.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

/// A result, or the message of a failure.
struct Opened {
  std::optional<SessionResult> result;
  Message message;
};

Opened open_in_background(const Stored<std::unique_ptr<Store>>& store, const SessionId& session, Keep keep) {
  if (!store) return {std::nullopt, describe(store.error())};
  auto result = open_result(**store, session, keep);
  if (!result) return {std::nullopt, describe(result.error())};
  return {std::move(*result), {}};
}

}  // namespace

void Desktop::open_report(const SessionId& session) { open_result_page(session, Keep::nothing); }
void Desktop::grade_interrupted(const SessionId& session) { open_result_page(session, Keep::grade); }

void Desktop::open_result_page(const SessionId& session, Keep keep) {
  if (keep == Keep::nothing && !store_->history.may_read_result(account_->actor(), session)) return show_handed_in(session);
  auto* busy = new Busy;
  QWidget* waiting = make_page(busy);
  push(waiting);
  busy->start(keep == Keep::grade ? tr("Measuring the tooth") : tr("Opening the report"), Busy::Cancel::none);
  QThreadPool::globalInstance()->start([this, session, keep, waiting = QPointer<QWidget>(waiting), opener = open_, database = database_, options = beside()] {
    auto opened = std::make_shared<Opened>(open_in_background(opener(database, options), session, keep));
    QMetaObject::invokeMethod(
        qApp,
        [this, opened, waiting] {
          // Whoever signed out meanwhile has taken the page with them.
          if (!waiting || page() != waiting) return;
          back();
          if (!opened->result) {
            show_failure(opened->message);
            return;
          }
          std::optional<Exercise> exercise;
          if (const auto list = load_exercises(*store_)) {
            if (const Exercise* found = list->find(opened->result->scenario.id)) exercise = *found;
          }
          show_result(std::make_shared<SessionResult>(std::move(*opened->result)), exercise);
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
  auto* page = new HandedIn(candidate);
  connect(page, &HandedIn::start_wanted, this, &Desktop::back);
  connect(page, &HandedIn::next_wanted, this, &Desktop::sign_out);
  push(page);
}

void Desktop::show_result(std::shared_ptr<const SessionResult> result, std::optional<Exercise> exercise) {
  const bool signed_in = account_.has_value();
  const Actor reader = signed_in ? account_->actor() : Actor{};
  bool own = !signed_in;
  if (signed_in && store_ && !result->session.is_nil()) {
    if (!store_->history.may_read_result(reader, result->session)) return show_handed_in(result->session);
    const auto details = store_->history.details(reader, result->session);
    own = details && details->row.student == reader.id;
  }
  ReportData gathered = gather_report(*result, store_.get(), signed_in ? &reader : nullptr);
  const QString back_name = !signed_in ? tr("Sign in") : tr("Back");
  const auto again = own && exercise && !reading_only_ ? ReportPage::TryAgain::offered : ReportPage::TryAgain::hidden;
  auto* report = new ReportPage(std::move(gathered), ports_, again, back_name);
  connect(report, &ReportPage::back_wanted, this, &Desktop::back);
  if (exercise) {
    connect(report, &ReportPage::try_again_wanted, this, [this, exercise = *exercise] {
      back();
      drill(exercise);
    });
  }
  if (signed_in && !reading_only_ && may(reader.role, Action::comment) && report->data().counts) add_marking(*report, result);
  const bool packs = signed_in && !reading_only_ && may(reader.role, Action::export_results) && report->data().counts;
  if (packs) offer_pack(*report);
  push(report);
}

void Desktop::add_marking(ReportPage& report, const std::shared_ptr<const SessionResult>& result) {
  auto* marking = new MarkingCard(*store_, account_->actor(), report.data(), ports_);
  report.set_card(marking);
  const auto choose = [&report, marking] { marking->set_criterion(report.chosen_criterion()); };
  choose();
  connect(&report, &ReportPage::criterion_chosen, marking, choose);
  connect(marking, &MarkingCard::stated, &report, [this, &report, marking, result] {
    const Actor reader = account_->actor();
    ReportData fresh = gather_report(*result, store_.get(), &reader);
    marking->show_data(fresh);
    report.show_data(std::move(fresh));
  });
}

}  // namespace cusp::ui
