// What the desktop keeps, puts out of sight and asks, before the station is locked, a page is left or the window closes.

#include <QCloseEvent>
#include <QDialog>
#include <QPointer>
#include <QStackedWidget>
#include <algorithm>
#include <utility>

#include "ui/app/desktop.h"
#include "ui/app/run_marker.h"
#include "ui/app/shell.h"
#include "ui/drill/drill_screen.h"
#include "ui/editor/audit_page.h"
#include "ui/editor/editor_page.h"
#include "ui/instructor/import_page.h"
#include "ui/report/marking_card.h"
#include "ui/report/report_page.h"
#include "ui/signin/sign_in.h"
#include "ui/widgets/at_work.h"
#include "ui/widgets/half_filled.h"

namespace cusp::ui {
namespace {

/// False if a draft cannot be written; its page shows why.
bool keep_drafts(const QWidget& desktop) {
  const auto editors = desktop.findChildren<EditorPage*>();
  return std::ranges::all_of(editors, [](EditorPage* page) { return page->keep_before_closing(); });
}

/// Files of a specimen that is no exercise yet.
bool has_open_import(const QWidget& desktop) {
  const auto pages = desktop.findChildren<ImportPage*>();
  return std::ranges::any_of(pages, [](const ImportPage* page) { return page->busy() || page->begun(); });
}

/// As ImportPage asks before it is left.
bool has_begun_import(const QWidget& desktop) {
  const auto pages = desktop.findChildren<ImportPage*>();
  return std::ranges::any_of(pages, &ImportPage::begun);
}

/// An audit that runs ends with the editor.
bool audits(const QWidget& desktop) {
  const auto pages = desktop.findChildren<AuditPage*>();
  return std::ranges::any_of(pages, [](const AuditPage* page) { return page->measuring(); });
}

/// Whether a page or one of its parts is of a kind, and `holds` of it.
template <class Kind>
bool any_part(const QWidget& page, bool (Kind::*holds)() const) {
  const auto is_one = [holds](const QWidget* part) {
    const auto* one = dynamic_cast<const Kind*>(part);
    return one != nullptr && (one->*holds)();
  };
  const auto parts = page.findChildren<QWidget*>();
  return is_one(&page) || std::ranges::any_of(parts, is_one);
}

bool has_half_filled_form(const QWidget& page) { return any_part(page, &HalfFilled::half_filled); }
bool has_comment(const QWidget& page) { return any_part(page, &MarkingCard::has_comment); }
bool has_typed_points(const QWidget& page) { return any_part(page, &MarkingCard::has_points); }
bool has_work(const QWidget& page) { return any_part(page, &AtWork::working); }

}  // namespace

void Desktop::begin_idle() {
  settings_.read_again();
  idle_.set_limit(std::chrono::minutes(settings_.idle_minutes()));
}

void Desktop::lock_idle() {
  if (!account_ || findChild<DrillScreen*>() != nullptr) return;
  lock(tr("You were signed out after %n minute(s) without input.", nullptr, settings_.idle_minutes()));
}

void Desktop::look_at_account() {
  if (!account_ || findChild<DrillScreen*>() != nullptr) return;
  const auto now = store_->accounts.find(account_->id);
  if (!now) return;
  if (now->disabled) return lock(tr("You were signed out: your account is switched off."));
  if (now->role != account_->role) lock(tr("You were signed out: your role was changed. Sign in again."));
}

void Desktop::lock(const QString& why) {
  const bool unsaved = !keep_drafts(*stack_);
  if (!unsaved) {
    for (const MarkingCard* card : stack_->findChildren<MarkingCard*>())
      if (card->has_comment()) unsaved_comments_[{account_->id, card->session()}] = {QString::fromStdString(account_->name), card->written()};
  }
  QString kept = has_open_import(*stack_)        ? tr("What you did is kept, but for the import: begin it anew.")
                 : audits(*stack_)               ? tr("What you did is kept, but for the audit: measure anew.")
                 : has_typed_points(*stack_)     ? tr("What you did is kept, but for the points that were typed: type them anew.")
                 : has_half_filled_form(*stack_) ? tr("What you did is kept, but for the form that was not saved: fill it in anew.")
                 : has_work(*stack_)             ? tr("What you did is kept, but for the outcome of work that still ran: look how it ended.")
                                                 : tr("What you did is kept.");
  if (unsaved) {
    put_behind_lock();
    kept = behind_lock_text();
  }
  sign_out();
  sign_in_->show_note({why, kept});
}

void Desktop::put_behind_lock() {
  auto* hidden = new QWidget(this);
  hidden->hide();
  while (stack_->count() > 1) {
    QWidget* page = stack_->widget(1);
    stack_->removeWidget(page);
    while (QDialog* open = page->findChild<QDialog*>()) delete open;  // a window of its own, which would stay in sight
    page->setParent(hidden);
    page->blockSignals(true);  // what ends in the background opens no page for somebody else
  }
  behind_lock_[{account_->id, account_->role}] = {QString::fromStdString(account_->name), hidden};
}

void Desktop::take_from_behind_lock() {
  const auto kept = behind_lock_.extract({account_->id, account_->role});
  if (kept.empty()) return;
  QWidget* hidden = kept.mapped().pages;
  for (QWidget* page : hidden->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
    page->blockSignals(false);
    stack_->addWidget(page);
  }
  delete hidden;
  stack_->setCurrentIndex(stack_->count() - 1);
  // A page that has had the focus knows where it was, and has no proxy any more (theme.cpp).
  QWidget* last = page()->focusWidget();
  (last ? last : page())->setFocus();
}

void Desktop::save_behind_lock() {
  std::erase_if(behind_lock_, [](const auto& one) {
    QWidget* hidden = one.second.pages;
    if (!keep_drafts(*hidden)) return false;
    delete hidden;
    return true;
  });
}

QString Desktop::behind_lock_text() const {
  QStringList owners;
  for (const auto& [account, kept] : behind_lock_) owners += kept.owner;
  return tr("Not saved yet: the work of %1. It stays here until its owner signs in again, or Cusp ends.").arg(owners.join(u", "_qs));
}

QString Desktop::waiting_comments_text() const {
  QStringList authors;
  for (const auto& [of, comment] : unsaved_comments_) authors += comment.author;
  authors.removeDuplicates();
  return authors.isEmpty() ? QString() : tr("The comment of %1 waits until its author signs in again.").arg(authors.join(u", "_qs));
}

void Desktop::give_back_comment(MarkingCard& card) {
  const auto kept = unsaved_comments_.extract({account_->id, card.session()});
  if (!kept.empty()) card.write(kept.mapped().text);
}

bool Desktop::asks_before_closing() {
  if (closes_anyway_ || ended_by_signal()) return false;
  save_behind_lock();
  const bool form = has_half_filled_form(*this);
  Question question{{}, {}, tr("Close"), true};
  if (const bool comment = has_comment(*this) || !unsaved_comments_.empty(); comment || has_typed_points(*this)) {
    question.what = comment ? tr("Close without the comment?") : tr("Close without the changed points?");
    question.more = (ReportPage::tr("What is written under Marking is not kept yet.") + u' ' + waiting_comments_text()).trimmed();
  } else if (!keep_drafts(*this)) {
    question.what = tr("Close without the last edits?");
    question.more = tr("The draft of the exercise cannot be saved. The editor shows why.");
  } else if (has_begun_import(*this)) {
    question.what = tr("Close without the import?");
    question.more = ImportPage::tr("The files stay as they are. What was read of them and what you chose here is not kept.");
  } else if (form) {
    question.what = tr("Close without saving the form?");
  } else if (has_work(*this) || packs_being_written_ > 0) {
    question.what = tr("Close before the work has ended?");
    question.more = leave_work_question().more;
  } else {
    return false;
  }
  if (form) question.more = (question.more + u' ' + leave_form_question().more).trimmed();
  if (!behind_lock_.empty()) question.more += u' ' + behind_lock_text();
  ports_.ask(this, question, [self = QPointer(this)](bool yes) {
    if (!self || !yes) return;
    self->closes_anyway_ = true;
    self->close();
  });
  return true;
}

void Desktop::leave_page(std::function<void()> then) {
  const QWidget* left = shell_ != nullptr ? shell_->page() : nullptr;
  const bool form = left != nullptr && has_half_filled_form(*left);
  if (left == nullptr || !(form || has_work(*left))) return then();
  ports_.ask(this, form ? leave_form_question() : leave_work_question(), [self = QPointer(this), then = std::move(then)](bool yes) {
    if (self && yes) then();
  });
}

void Desktop::read_page_again() {
  if (shell_ && page() == shell_) shell_->show_again();  // else back() does
}

void Desktop::closeEvent(QCloseEvent* event) {
  // A shutdown of the computer does not wait for an answer.
  for (DrillScreen* screen : ended_by_signal() ? QList<DrillScreen*>() : findChildren<DrillScreen*>()) {
    if (!screen->running() && !screen->working()) continue;
    screen->ask_leave_then([this] { close(); });
    return event->ignore();
  }
  if (asks_before_closing()) return event->ignore();
  if (closes_anyway_ || ended_by_signal()) keep_drafts(*this);  // asks_before_closing() did, if nothing was asked
  if (waits_for_backup()) return event->ignore();
  settings_.set_window(saveGeometry());
  QMainWindow::closeEvent(event);
}

}  // namespace cusp::ui
