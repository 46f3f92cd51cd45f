// How the desktop opens the records: for writing, or where the disk takes nothing more for reading.

#include <QApplication>
#include <QPointer>

#include "storage/base/clock.h"
#include "ui/admin/backup_work.h"
#include "ui/app/desktop.h"
#include "ui/app/quick_start.h"
#include "ui/render/opengl_allowed.h"
#include "ui/signin/sign_in.h"
#include "ui/text/incident_text.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kBackupLookMs = 60'000;  // between two looks at whether a backup is due

/// A disk that takes nothing more can still be read.
bool may_be_read(StorageError code) {
  return code == StorageError::read_only || out_of_space(code) || code == StorageError::io;
}

}  // namespace

Stored<std::unique_ptr<Store>> Desktop::open_records(StoreOptions options) const {
  if (reading_only_) options.database.access = DatabaseOptions::Access::read_only;
  return open_(database_, options);
}

void Desktop::start() {
  store_.reset();
  reading_only_.reset();
  auto store = open_records();
  if (!store && may_be_read(store.error().code)) {
    const StorageFailure cause = store.error();
    reading_only_ = cause;
    auto reading = open_records();
    if (reading) {
      store = std::move(reading);
    } else {
      reading_only_.reset();
    }
  }
  if (!store) {
    show_refusal(describe(store.error()));
    return;
  }
  store_ = std::move(*store);
  if (!reading_only_) backup_timer_.start(kBackupLookMs);
  show_sign_in(new SignIn(*store_));
}

void Desktop::offer_safe_start() {
  const Question question{.what = tr("Cusp ended unexpectedly last time. Start without 3D pictures?"),
                          .more = tr("Without them this station can grade, replay and administer, and nobody can drill."),
                          .act = tr("Start without 3D pictures"),
                          .stay = tr("Start as usual")};
  ports_.ask(this, question, [self = QPointer(this)](bool without) {
    if (!self) return;
    if (without) forbid_opengl();
    self->start();
  });
}

void Desktop::keep_daily_backup() {
  const auto into = settings_.backup_folder(database_);
  // What is written meanwhile would slow the recorder down.
  const bool drilling = page() != nullptr && page()->findChild<ToothView*>() != nullptr;
  if (!store_ || reading_only_ || drilling || !backup_.over() || !backup_is_due(into, store_->context().station, system_utc_us())) return;
  backup_ = back_up(records_of(*store_), into, std::nullopt, [self = QPointer(this)](const Stored<Backup>& made) {
    const auto failure = made ? std::nullopt : std::optional(describe(made.error()));
    QMetaObject::invokeMethod(
        qApp,
        [self, failure] {
          if (self) self->backup_failure_ = failure;
        },
        Qt::QueuedConnection);
  });
}

void Desktop::show_refusal(const Message& message) {
  auto* state = new EmptyState(u"warning"_qs, message.what, message.more, tr("Try again"), Ink::bad);
  connect(state, &EmptyState::acted, this, &Desktop::start);
  replace_root(make_page(state));
}

std::optional<Message> Desktop::incident() {
  const auto& met = store_->context().incident;
  return met ? std::optional(describe_incident(*met, database_)) : std::nullopt;
}

std::optional<Message> Desktop::why_reading_only() const {
  return reading_only_ ? std::optional(describe_reading_only(*reading_only_, database_)) : std::nullopt;
}

void Desktop::show_quick_start() {
  auto* page = new QuickStart;
  connect(page, &QuickStart::back_wanted, this, &Desktop::back);
  push(page);
}

}  // namespace cusp::ui
