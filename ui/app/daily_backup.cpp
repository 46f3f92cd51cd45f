// The daily backup of the records, and the window that closes while it is made.

#include <QApplication>
#include <QBoxLayout>
#include <QPointer>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "ui/admin/backup_work.h"
#include "ui/admin/work_run.h"
#include "ui/app/desktop.h"
#include "ui/app/run_marker.h"
#include "ui/app/shell.h"
#include "ui/drill/drill_screen.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kBackupRetryS = 3'600;  // after one that failed: on a full disk each try copies until there is no room

/// "84 %" of the pages; their number fits no int.
QString copied_share(std::size_t done, std::size_t all) {
  return format_share(static_cast<int>(100.0 * static_cast<double>(std::min(done, all)) / static_cast<double>(all)), 100);
}

/// nullopt: nothing failed.
std::optional<Message> failure_of_daily(const Stored<BackedUp>& made, const std::filesystem::path& into) {
  if (!made) return Message{Desktop::tr("The daily backup failed."), describe_backup_failure(made.error(), into).line()};
  if (!made->not_removed) return std::nullopt;
  return Message{Desktop::tr("The daily backup is made. An old one could not be removed."),
                 Desktop::tr("%1: %2.").arg(isolate(QString::fromStdString(made->not_removed->where)), QString::fromLocal8Bit(made->not_removed->detail.c_str()))};
}

}  // namespace

bool Desktop::keep_daily_backup() {
  settings_.read_again();
  const auto into = settings_.backup_folder(database_);
  // What is written meanwhile would slow the recorder down.
  const bool drilling = findChild<DrillScreen*>() != nullptr;
  if (!store_ || reading_only_ || drilling || backing_up_ || !backup_.over()) return false;
  // A clock that was ahead at the failure puts no further try off.
  const qint64 wait_s = next_backup_.isValid() ? ports_.now().secsTo(next_backup_) : 0;
  if (wait_s > 0 && wait_s <= kBackupRetryS) return false;
  backing_up_ = std::make_shared<WorkProgress>();
  const auto then = [self = QPointer(this)](const Stored<BackedUp>& made) {
    QMetaObject::invokeMethod(
        qApp,
        [self, made] {
          if (self) self->end_daily_backup(made);
        },
        Qt::QueuedConnection);
  };
  backup_ = back_up(records_of(*store_), into, std::nullopt, then, backing_up_);
  return true;
}

void Desktop::end_daily_backup(const Stored<BackedUp>& made) {
  backing_up_.reset();
  // Each minute finds the one of today: what was shown of its making stays, but for a failure that came before it.
  if (!made || made->by == BackedUp::By::this_call || next_backup_.isValid()) {
    // Each hour may fail: whoever has read of it reads it again at the next sign-in.
    const bool unread = !backup_failure_ && account_ && account_->role == Role::administrator;
    backup_failure_ = failure_of_daily(made, settings_.backup_folder(database_));
    if (backup_failure_ && unread && shell_) shell_->show_outcome(Band::Kind::look, *backup_failure_, [] {});
  }
  next_backup_ = made ? QDateTime() : ports_.now().addSecs(kBackupRetryS);
  if (std::exchange(closes_after_backup_, false)) close();
}

bool Desktop::makes_daily_backup() const { return backing_up_ && backing_up_->all > 0; }

bool Desktop::waits_for_backup() {
  if (!backing_up_) return false;
  if (ended_by_signal() || !makes_daily_backup()) {
    backing_up_->stop = true;
    return false;
  }
  if (!std::exchange(closes_after_backup_, true)) {
    closes_anyway_ = true;  // nothing was asked, or it was answered
    backup_timer_.stop();
    account_.reset();
    show_last_backup();
  }
  return true;
}

void Desktop::show_last_backup() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  const QString what = tr("The daily backup is being made"), more = tr("Cusp closes once it is made. If you leave it out, the next start makes it.");
  auto* run = new WorkRun(page);
  QSizePolicy keeps_place = run->busy()->sizePolicy();  // the button stays where it is when the bar is shown
  keeps_place.setRetainSizeWhenHidden(true);
  run->busy()->setSizePolicy(keeps_place);
  QPushButton* leave_out = make_button(tr("Close without the backup"));
  column->addStretch(1);
  column->addWidget(new EmptyState(u"save"_qs, what, more));
  column->addWidget(run->busy(), 0, Qt::AlignHCenter);
  column->addWidget(leave_out, 0, Qt::AlignHCenter);
  column->addStretch(1);
  connect(leave_out, &QPushButton::clicked, this, [this] {
    closes_after_backup_ = false;
    if (backing_up_) backing_up_->stop = true;
    backing_up_.reset();
    close();
  });
  page->setAccessibleName(what);
  page->setFocusProxy(leave_out);
  replace_root(page);
  announce(page, what + u". "_qs + more);
  run->follow(backing_up_, tr("Copying the records"), [](std::size_t done, std::size_t all) { return tr("Copied %1").arg(copied_share(done, all)); });
}

}  // namespace cusp::ui
