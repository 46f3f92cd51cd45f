// What the desktop keeps, and what it asks, before the station is locked or the window closes.

#include <QCloseEvent>
#include <QPointer>
#include <algorithm>

#include "ui/admin/people_import.h"
#include "ui/app/desktop.h"
#include "ui/app/run_marker.h"
#include "ui/drill/drill_screen.h"
#include "ui/editor/audit_page.h"
#include "ui/editor/editor_page.h"
#include "ui/instructor/import_page.h"
#include "ui/report/marking_card.h"
#include "ui/report/report_page.h"
#include "ui/signin/sign_in.h"

namespace cusp::ui {
namespace {

bool has_unsaved_slips(const QWidget& desktop) {
  const auto imports = desktop.findChildren<PeopleImport*>();
  return std::ranges::any_of(imports, [](const PeopleImport* page) { return page->unsaved(); });
}

bool has_unsaved_comment(const QWidget& desktop) {
  const auto cards = desktop.findChildren<MarkingCard*>();
  return std::ranges::any_of(cards, [](const MarkingCard* card) { return card->unsaved(); });
}

/// False if a draft cannot be written; its page shows why.
bool keep_drafts(const QWidget& desktop) {
  const auto editors = desktop.findChildren<EditorPage*>();
  return std::ranges::all_of(editors, [](EditorPage* page) { return page->keep_before_closing(); });
}

/// Files of a specimen that is no exercise yet.
bool has_open_import(const QWidget& desktop) {
  const auto pages = desktop.findChildren<ImportPage*>();
  return std::ranges::any_of(pages, [](const ImportPage* page) { return page->busy() || page->meshes() || page->volume(); });
}

/// An audit that runs ends with the editor.
bool audits(const QWidget& desktop) {
  const auto pages = desktop.findChildren<AuditPage*>();
  return std::ranges::any_of(pages, [](const AuditPage* page) { return page->measuring(); });
}

}  // namespace

void Desktop::lock_idle() {
  // A device moves without mouse and keys; PINs that are not saved and a draft that cannot be stand nowhere else.
  if (!account_ || findChild<DrillScreen*>() != nullptr || has_unsaved_slips(*this) || !keep_drafts(*this)) return begin_idle();
  for (const MarkingCard* card : findChildren<MarkingCard*>())
    if (card->unsaved()) unsaved_comments_[{account_->id, card->session()}] = card->written();
  const int minutes = settings_.idle_minutes();
  const QString kept = has_open_import(*this) ? tr("What you did is kept, but for the import: begin it anew.")
                       : audits(*this)        ? tr("What you did is kept, but for the audit: measure anew.")
                                              : tr("What you did is kept.");
  sign_out();
  sign_in_->show_note({tr("You were signed out after %n minute(s) without input.", nullptr, minutes), kept});
}

void Desktop::give_back_comment(MarkingCard& card) {
  const auto kept = unsaved_comments_.extract({account_->id, card.session()});
  if (!kept.empty()) card.write(kept.mapped());
}

bool Desktop::asks_before_closing() {
  if (closes_anyway_ || ended_by_signal()) return false;
  Question question{{}, {}, tr("Close"), true};
  if (has_unsaved_slips(*this)) {
    question.what = tr("Close without the PIN slips?");
    question.more = PeopleImport::tr("The PINs stand nowhere else. Each student would need a new one.");
  } else if (has_unsaved_comment(*this)) {
    question.what = tr("Close without the comment?");
    question.more = ReportPage::tr("What is written under Marking is not kept yet.");
  } else if (!keep_drafts(*this)) {
    question.what = tr("Close without the last edits?");
    question.more = tr("The draft of the exercise cannot be saved. The editor shows why.");
  } else {
    return false;
  }
  ports_.ask(this, question, [self = QPointer(this)](bool yes) {
    if (!self || !yes) return;
    self->closes_anyway_ = true;
    self->close();
  });
  return true;
}

void Desktop::closeEvent(QCloseEvent* event) {
  // A shutdown of the computer does not wait for an answer.
  for (DrillScreen* screen : ended_by_signal() ? QList<DrillScreen*>() : findChildren<DrillScreen*>()) {
    if (!screen->running()) continue;
    screen->ask_leave();
    if (screen->running()) return event->ignore();
  }
  if (asks_before_closing()) return event->ignore();
  if (closes_anyway_ || ended_by_signal()) keep_drafts(*this);  // asks_before_closing() did, if nothing was asked
  settings_.set_window(saveGeometry());
  QMainWindow::closeEvent(event);
}

}  // namespace cusp::ui
