// Appeal packs on the desktop: one attempt out to a file, and a file opened as a report.

#include <QApplication>

#include "ui/app/desktop.h"
#include "ui/report/appeal_pack.h"
#include "ui/report/pack_card.h"
#include "ui/report/report_page.h"
#include "ui/widgets/busy.h"
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
  packing_ = BackgroundTask([path, page = QPointer<ReportPage>(&report), opener = open_, database = database_, options = beside(),
                             actor = account_->actor(), session = report.data().result.session] {
    const auto written = std::make_shared<Written>(write_in_background(opener(database, options), actor, session, path));
    QMetaObject::invokeMethod(
        qApp,
        [page, path, written] {
          if (!page) return;
          if (*written) return page->show_message(Band::Kind::good, ReportPage::tr("The appeal pack is saved."), path);
          page->show_message(Band::Kind::bad, written->error().what, written->error().more);
        },
        Qt::QueuedConnection);
  });
}

void Desktop::open_pack(const QString& path) {
  auto* busy = new Busy;
  QWidget* waiting = make_page(busy);
  push(waiting);
  busy->start(tr("Opening the appeal pack"), Busy::Cancel::none);
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
  });
}

void Desktop::show_pack(const std::shared_ptr<const OpenedPack>& pack) {
  auto* report = new ReportPage(pack->report, ports_, ReportPage::TryAgain::hidden, tr("Back"));
  report->set_card(new PackCard(pack));
  connect(report, &ReportPage::back_wanted, this, &Desktop::back);
  push(report);
}

}  // namespace cusp::ui
