// EditorPage and the records: saving the draft, conflicts with another window, publishing.

#include <QApplication>
#include <QBoxLayout>
#include <QDateTime>
#include <QPointer>
#include <QPushButton>
#include <QTabWidget>
#include <utility>

#include "scenarios/checks/checks.h"
#include "scenarios/format/read.h"
#include "ui/editor/editor_page.h"
#include "ui/editor/editor_page_parts.h"
#include "ui/editor/editor_records.h"
#include "ui/editor/publish_sheet.h"
#include "ui/editor/texts_form.h"
#include "ui/modules.h"
#include "ui/session/records_task.h"
#include "ui/text/language.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {

Band* EditorPage::make_clash() {
  clash_ = new Band;
  QPushButton* copy = make_button(tr("Keep mine as a copy"), ButtonKind::primary);
  see_theirs_ = make_button(tr("See theirs"));
  QPushButton* replace = make_button(tr("Replace theirs"), ButtonKind::erase);
  for (QPushButton* button : {copy, see_theirs_, replace}) clash_->ways_out()->addWidget(button);
  connect(copy, &QPushButton::clicked, this, &EditorPage::keep_copy);
  connect(see_theirs_, &QPushButton::clicked, this, &EditorPage::see_theirs);
  connect(replace, &QPushButton::clicked, this, &EditorPage::ask_to_replace_theirs);
  return clash_;
}

void EditorPage::show_failure(const StorageFailure& failure) {
  const Message message = describe(failure);
  band_->show_message(Band::Kind::bad, message.what, message.more);
}

bool EditorPage::keep() {
  autosave_.stop();
  if (publishing()) {
    autosave_.start();  // the draft of now goes with what is published
    return false;
  }
  const auto kept = keep_draft(store_, actor_, *model_, kept_);
  if (!kept) {
    show_failure(kept.error());
    return false;
  }
  if (*kept == DraftSave::changed_elsewhere) {
    show_clash();
    return false;
  }
  clash_->clear();
  return true;
}

void EditorPage::show_clash() {
  if (!clash_->isHidden()) return;  // the question stays until it is answered
  const auto theirs = store_.scenarios.draft(actor_, model_->scenario().id);
  if (!theirs) return show_failure(theirs.error());
  band_->clear();
  see_theirs_->setVisible(theirs->has_value());
  if (*theirs) {
    const QDateTime when = local_time((*theirs)->saved_utc_us);
    clash_->show_message(Band::Kind::look, tr("Another window saved this draft: %1.").arg(format_day_time(when)),
                         tr("Yours is not saved. Nothing is replaced until you choose."));
  } else {
    clash_->show_message(Band::Kind::look, tr("Another window published or discarded this draft."),
                         tr("Yours is not saved. Nothing is replaced until you choose."));
  }
}

void EditorPage::see_theirs() {
  const auto theirs = store_.scenarios.draft(actor_, model_->scenario().id);
  if (!theirs) return show_failure(theirs.error());
  clash_->clear();
  if (!*theirs) return show_clash();  // discarded meanwhile
  const auto read = read_scenario((*theirs)->json);
  if (!read || !model_->take(*read)) {
    band_->show_message(Band::Kind::bad, tr("The other window’s draft cannot be read."), tr("Yours stands as it was."));
    return;
  }
  kept_ = (*theirs)->json;
  band_->show_message(Band::Kind::info, tr("This is the other window’s draft."), tr("Undo brings yours back."));
}

void EditorPage::keep_copy() {
  const auto copy = keep_as_copy(store_, actor_, *model_, title_of_copy(model_->scenario().title));
  if (!copy) return show_failure(copy.error());
  autosave_.stop();
  Q_EMIT copied(*copy);
}

void EditorPage::ask_to_replace_theirs() {
  ports_.ask(this, {tr("Replace the other window’s draft?"), tr("What was changed there is lost."), tr("Replace theirs"), true},
             [self = QPointer(this)](bool yes) {
               if (!self || !yes) return;
               const auto theirs = self->store_.scenarios.draft(self->actor_, self->model_->scenario().id);
               if (!theirs) return self->show_failure(theirs.error());
               self->kept_ = *theirs ? std::optional((*theirs)->json) : std::nullopt;
               self->clash_->clear();
               self->keep();
             });
}

bool EditorPage::keep_before_closing() {
  take_typed();
  autosave_.stop();
  // While a version is being published, the draft in the records is that version's: only what was edited since is written.
  const auto kept = keep_draft(store_, actor_, *model_, kept_);
  if (kept && *kept == DraftSave::kept) return true;
  if (!kept) {
    show_failure(kept.error());
    return false;
  }
  // A closing window asks no question: both drafts stay.
  const auto copy = keep_as_copy(store_, actor_, *model_, title_of_copy(model_->scenario().title));
  if (!copy) show_failure(copy.error());
  return copy.has_value();
}

void EditorPage::leave() {
  take_typed();
  leaves_ = publishing();
  if (leaves_) return;
  with_briefing(tr("Leave without the briefing?"), tr("Leave"), &EditorPage::keep_and_leave);
}

bool EditorPage::half_filled() const {
  const auto* texts = findChild<TextsForm*>();
  return texts != nullptr && texts->half_filled();
}

/// Asks first if a briefing stands in its field that the exercise cannot hold.
void EditorPage::with_briefing(const QString& question, const QString& verb, void (EditorPage::*act)()) {
  if (!half_filled()) return (this->*act)();
  ports_.ask(this, {question, tr("The exercise keeps the briefing as it was. Under Texts stands why."), verb, true},
             [self = QPointer(this), act](bool yes) {
               if (!self) return;
               if (yes) return (self->*act)();
               self->tabs_->setCurrentIndex(kWordsTab);
             });
}

void EditorPage::keep_and_leave() {
  if (keep()) Q_EMIT back_wanted();
}

void EditorPage::publish_version() {
  if (publish_wait_->running() || !model_->publishable()) return;
  with_briefing(tr("Publish without the briefing?"), tr("Publish"), &EditorPage::begin_proof);
}

/// Of an exercise that scripted operators drill: seconds, and many of them on a slow machine.
void EditorPage::begin_proof() {
  proving_ = true;
  publish_wait_->start(tr("Checking…"));
  QTimer::singleShot(Busy::kDelayMs, this, [this] { stop_proof_->setVisible(proving_); });
  publish_task_ = BackgroundTask([self = QPointer(this), proof = ++proof_, checked = model_->scenario(), specimen = model_->specimen()] {
    const auto found = std::make_shared<std::vector<Finding>>(check_attempts(checked, specimen));
    QMetaObject::invokeMethod(
        qApp,
        [self, proof, checked, found] {
          if (self && proof == self->proof_) self->show_proved(checked, std::move(*found));
        },
        Qt::QueuedConnection);
  });
}

/// The thread ends its check; nobody waits for it.
void EditorPage::stop_proof() {
  if (!proving_) return;
  ++proof_;
  proving_ = false;
  publish_task_ = {};
  publish_wait_->finish();
  stop_proof_->hide();
  publish_->setFocus();
}

void EditorPage::show_proved(const Scenario& checked, std::vector<Finding> found) {
  proving_ = false;
  publish_wait_->finish();
  stop_proof_->hide();
  if (!(model_->scenario() == checked)) return publish_version();  // edited meanwhile
  if (model_->prove(std::move(found))) open_sheet();
}

void EditorPage::open_sheet() {
  auto facts = publish_facts(store_, *model_, ports_.now().toMSecsSinceEpoch() * 1000);
  if (!facts) return show_failure(facts.error());
  const int number = facts->number;
  auto* sheet = new PublishSheet(std::move(*facts), local(model_->scenario().title), ports_, this);
  connect(sheet, &PublishSheet::publish_wanted, this, [this, number] { publish_now(number); });
  connect(sheet, &PublishSheet::try_out_wanted, this, &EditorPage::try_out);
  activate_after(*sheet, this);
  sheet->open();
}

/// `number`: of the version that the sheet named.
void EditorPage::publish_now(int number) {
  if (publishing()) return;
  const auto next = next_version(store_, *model_);
  if (!next) return show_failure(next.error());
  if (*next != number) return open_sheet();  // another desk published meanwhile: the sheet names what that replaces
  // If the program dies meanwhile, the draft is as it was published.
  if (const auto kept = keep_draft(store_, actor_, *model_, kept_); !kept) return show_failure(kept.error());
  auto what = publication_of(*model_, kept_);
  if (!what) return show_failure(what.error());
  autosave_.stop();
  publish_wait_->start(tr("Publishing…"));
  publish_task_ = with_own_store(store_, [self = QPointer(this), actor = actor_, what = std::move(*what)](OwnStore own) {
    const auto done = std::make_shared<Stored<Published>>(own ? publish(**own, actor, what) : Stored<Published>(std::unexpected(own.error())));
    QMetaObject::invokeMethod(
        qApp,
        [self, done] {
          if (self) self->show_published(*done);
        },
        Qt::QueuedConnection);
  });
}

void EditorPage::show_published(const Stored<Published>& done) {
  publish_wait_->finish();
  const bool leaves = std::exchange(leaves_, false);
  if (!done) return show_failure(done.error());
  kept_.reset();
  model_->now_published(done->scenario);
  autosave_.stop();
  if (!model_->unchanged()) autosave_.start();  // edited meanwhile
  clash_->clear();
  band_->show_message(Band::Kind::good, tr("Version %1 is published.").arg(done->version.number),
                      tr("Students find it among their exercises. Earlier results keep the version they were made with."));
  Q_EMIT published(done->version);
  if (leaves) leave();
}

}  // namespace cusp::ui
