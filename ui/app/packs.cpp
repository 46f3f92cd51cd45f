// Appeal packs on the desktop: one attempt out to a file, and a file opened as a report.

#include <QApplication>
#include <QPointer>
#include <utility>

#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/report/appeal_pack.h"
#include "ui/report/pack_card.h"
#include "ui/report/report_page.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

using Written = Result<void, Message>;

Written write_in_background(const Stored<std::unique_ptr<Store>>& store, const Actor& actor, const SessionId& session, const QString& path) {
  if (!store) return std::unexpected(describe(store.error()));
  return write_appeal_pack(**store, actor, session, path.toStdString());
}

}  // namespace

/// A store belongs to one thread: the background opens its own on the same file.
StoreOptions Desktop::beside() const {
  StoreOptions options;
  options.database.access = reading_only_ ? DatabaseOptions::Access::read_only : DatabaseOptions::Access::existing;
  options.mark_interrupted = false;
  return options;
}

void Desktop::offer_pack(ReportPage& report) {
  const auto recorded = store_->traces.inputs(report.data().result.session, 0);
  report.offer_pack(!recorded && recorded.error().where == "thinned" ? describe(recorded.error()).line() : QString());
  connect(&report, &ReportPage::pack_wanted, this, [this, &report] {
    FileWish wish;
    wish.title = tr("Save the appeal pack");
    wish.name = as_file_name(report.data().student + u' ' + report.data().when.toString(u"yyyy-MM-dd HH-mm"_qs)) + QString::fromUtf8(kPackSuffix);
    wish.filter = tr("Appeal pack (*.cusppack)");
    wish.what = FileWish::What::new_file;
    ports_.pick_file(&report, wish, [this, page = QPointer<ReportPage>(&report)](const QString& path) {
      if (page && account_) write_pack(*page, path);
    });
  });
}

void Desktop::write_pack(ReportPage& report, const QString& path) {
  report.show_message(Band::Kind::info, tr("The appeal pack is being made."), {});
  ++packs_being_written_;
  packing_ = BackgroundTask([self = QPointer(this), path, page = QPointer<ReportPage>(&report), opener = open_, database = database_,
                             options = beside(), actor = account_->actor(), session = report.data().result.session] {
    const auto written = std::make_shared<Written>(write_in_background(opener(database, options), actor, session, path));
    QMetaObject::invokeMethod(
        qApp,
        [self, page, path, owner = actor.id, written] {
          if (!self) return;
          --self->packs_being_written_;
          const Band::Kind kind = *written ? Band::Kind::good : Band::Kind::bad;
          const Message outcome = *written ? Message{ReportPage::tr("The appeal pack is saved."), path} : written->error();
          // A page that was left may not be deleted yet.
          if (page && page.data() == self->page()) return page->show_message(kind, outcome.what, outcome.more);
          self->report_pack({owner, kind, *written ? outcome : Message{tr("No appeal pack was saved as %1.").arg(path), outcome.line()}});
        },
        Qt::QueuedConnection);
  });
}

void Desktop::report_pack(PackOutcome outcome) {
  const bool here = account_ && account_->id == outcome.owner;
  auto* report = here ? qobject_cast<ReportPage*>(page()) : nullptr;
  if (report != nullptr) return report->show_message(outcome.kind, outcome.message.what, outcome.message.more);
  const int number = packs_reported_++;
  pack_outcomes_.emplace(number, std::move(outcome));
  if (here && shell_) show_pack_outcome(number);
}

void Desktop::show_pack_outcome(int number) {
  const PackOutcome& outcome = pack_outcomes_.at(number);
  shell_->show_outcome(outcome.kind, outcome.message, [this, number] { pack_outcomes_.erase(number); });
}

void Desktop::show_pack_outcomes() {
  for (const auto& [number, outcome] : pack_outcomes_)
    if (outcome.owner == account_->id) show_pack_outcome(number);
}

void Desktop::open_pack(const QString& path) {
  QWidget* waiting = push_waiting(tr("Opening the appeal pack"), Busy::Cancel::offered);
  packing_ = BackgroundTask([this, path, waiting = QPointer<QWidget>(waiting), opener = open_, database = database_, options = beside()] {
    const auto store = opener(database, options);
    using Opened = Result<OpenedPack, Message>;
    auto opened = std::make_shared<Opened>(store ? open_appeal_pack(path.toStdString(), store->get()) : Opened(std::unexpected(describe(store.error()))));
    QMetaObject::invokeMethod(
        qApp,
        [this, opened, waiting] {
          if (!waiting || page() != waiting) return;
          back();
          if (!*opened) return show_failure(opened->error());
          if (!(*opened)->readable) return show_failure({PackCard::tr("This pack was changed after it was made."), PackCard::tr("Its records cannot be read any more.")});
          show_pack(std::make_shared<const OpenedPack>(std::move(**opened)));
        },
        Qt::QueuedConnection);
  }, BackgroundTask::Holds::nothing);
}

void Desktop::show_pack(const std::shared_ptr<const OpenedPack>& pack) {
  auto* report = new ReportPage(pack->report, ports_, ReportPage::TryAgain::hidden, tr("Back"));
  report->set_card(new PackCard(pack));
  connect(report, &ReportPage::back_wanted, this, &Desktop::back);
  push(report);
}

}  // namespace cusp::ui
