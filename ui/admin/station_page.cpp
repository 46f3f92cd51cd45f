#include "ui/admin/station_page.h"

#include <QBoxLayout>
#include <QDateTime>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <utility>

#include "storage/summary/records_size.h"
#include "ui/admin/backups_table.h"
#include "ui/admin/recordings_card.h"
#include "ui/admin/on_window.h"
#include "ui/text/failure_text.h"
#include "ui/text/incident_text.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/format.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr std::size_t kFindingsShown = 5;
constexpr int kStackBelow = 900;  // px at 100 %, of the page

QString size_text(std::uint64_t bytes) { return QLocale().formattedDataSize(static_cast<qint64>(bytes), 1); }

}  // namespace

StationPage::StationPage(Store& store, const Actor& actor, Settings& settings, const Ports& ports, QWidget* parent)
    : QWidget(parent), database_(store.database().file()), records_(records_of(store)), station_(store.context().station), actor_(actor),
      settings_(settings), ports_(ports), run_(new WorkRun(this)) {
  read_size(store);
  if (const auto& key = store.context().key) key_ = fingerprint(key->id());
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* body = nullptr;
  outer->addWidget(make_scroll_page(&body));
  body->setSpacing(px(12));
  body->addWidget(new PageHead(tr("Station")));
  band_ = new Band;
  body->addWidget(band_);
  body->addWidget(run_->busy());
  columns_ = new QBoxLayout(QBoxLayout::LeftToRight);
  columns_->setSpacing(px(16));
  columns_->addWidget(make_backups());
  auto* beside = new QWidget;
  auto* aside = new QVBoxLayout(beside);
  aside->setContentsMargins(0, 0, 0, 0);
  aside->setSpacing(px(16));
  aside->addWidget(make_records());
  recordings_ = new RecordingsCard(records_, actor_, ports_);
  connect(recordings_, &RecordingsCard::reported, band_, &Band::show_message);
  aside->addWidget(recordings_);
  aside->addWidget(make_idle());
  aside->addStretch();
  columns_->addWidget(beside);
  body->addLayout(columns_, 1);
  show_backups();
  setFocusProxy(back_up_);
}

void StationPage::read_size(Store& store) {
  const auto size = records_size(store.database());
  page_bytes_ = size ? size->page_bytes : 0;
  holds_ = size ? tr("%n session(s), %1", nullptr, static_cast<int>(size->sessions)).arg(size_text(size->bytes))
                : tr("How much the records hold could not be read.");
}

void StationPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool narrow = width() < px(kStackBelow);
  columns_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  columns_->setStretch(0, narrow ? 0 : 3);
  columns_->setStretch(1, narrow ? 0 : 2);
}

QString StationPage::message() const { return band_->isVisibleTo(this) ? band_->text() : QString(); }

QWidget* StationPage::make_records() {
  auto* card = new Card(tr("Records"));
  card->body()->addWidget(make_paragraph(QString::fromStdString(database_.string())));
  QLabel* holds = make_label(holds_);
  holds->setWordWrap(true);
  card->body()->addWidget(holds);
  if (!key_.isEmpty()) {
    auto* key = make_label(tr("Key %1").arg(key_));
    key->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    key->setToolTip(tr("Signs this station’s records and appeal packs"));
    card->body()->addWidget(key);
  }
  card->body()->addWidget(make_paragraph(tr("Verification proves that nobody but the program has changed a result, an account or the log.")));
  verify_ = make_button(tr("Verify now"), ButtonKind::standard, u"shield"_qs);
  card->body()->addWidget(verify_, 0, Qt::AlignLeading);
  connect(verify_, &QPushButton::clicked, this, &StationPage::verify);
  return card;
}

QWidget* StationPage::make_idle() {
  auto* card = new Card(tr("Signing out"));
  idle_ = new NumberField;
  idle_->setRange(0, Settings::kMostIdleMinutes);
  idle_->setDecimals(0);
  idle_->setSpecialValueText(tr("never"));
  idle_->setSuffix(tr(" min"));
  idle_->show_value(settings_.idle_minutes());
  card->body()->addWidget(labelled(tr("After so many minutes without input"), idle_));
  card->body()->addWidget(make_paragraph(tr("Nobody is signed out while drilling. It holds from the next sign-in.")));
  connect(idle_, &QDoubleSpinBox::valueChanged, this, [this](double minutes) {
    if (settings_.set_idle_minutes(static_cast<int>(minutes))) return;
    band_->show_message(Band::Kind::bad, tr("The minutes hold until Cusp is closed."),
                        tr("%1 cannot be written, so the next start does not know them.").arg(settings_.file()));
  });
  return card;
}

QWidget* StationPage::make_backups() {
  auto* card = new Card(tr("Backups"), QStringLiteral(" "));
  newest_ = make_label({});
  card->body()->addWidget(newest_);
  folder_ = make_paragraph({});
  card->body()->addWidget(folder_);
  auto* row = new QHBoxLayout;
  back_up_ = make_button(tr("Back up now"), ButtonKind::primary, u"save"_qs);
  choose_ = make_button(tr("Choose a folder"));
  row->addWidget(back_up_);
  row->addWidget(choose_);
  row->addStretch();
  card->body()->addLayout(row);
  table_ = new BackupsTable;
  card->body()->addWidget(table_, 1);
  card->body()->addWidget(make_paragraph(tr("To go back, restore a backup to a new database with \"cusp restore FOLDER NEW.db\". Nothing is overwritten.")));
  connect(back_up_, &QPushButton::clicked, this, &StationPage::back_up);
  connect(choose_, &QPushButton::clicked, this, &StationPage::choose_folder);
  return card;
}

void StationPage::show_backups() {
  const auto into = settings_.backup_folder(database_);
  folder_->setText(tr("One a day. The newest %1 of these, and as many of your own, are kept in %2").arg(kBackupsKept).arg(QString::fromStdString(into.string())));
  newest_->setText(tr("The folder is being read."));
  table_->show_backups({});
  finding_ = find_backups(into, station_, ++asked_, on_window<FoundBackups>(this, &StationPage::show_found));
}

void StationPage::show_found(const FoundBackups& found) {
  if (found.asked != asked_) return;
  const auto& all = found.all;
  table_->show_backups(all.value_or(std::vector<Backup>{}));
  if (!all || all->empty()) {
    newest_->setText(all ? tr("There is no backup yet.")
                         : tr("The folder cannot be read: %1.").arg(QString::fromLocal8Bit(all.error().detail.c_str())));
    return;
  }
  newest_->setText((tr("The newest one is of %1.").arg(format_day_time(local_time(all->front().made_utc_us))) + u' ' + dates_note(*all)).trimmed());
}

std::shared_ptr<WorkProgress> StationPage::begin(const QString& what, WorkRun::Counted counted) {
  band_->clear();  // it speaks of the work before
  auto progress = run_->start(what, std::move(counted));
  for (QPushButton* button : {back_up_, choose_, verify_}) button->setEnabled(false);
  return progress;
}

void StationPage::end() {
  for (QPushButton* button : {back_up_, choose_, verify_}) button->setEnabled(true);
  run_->finish();
}

void StationPage::back_up() {
  if (working()) return;
  auto progress = begin(tr("Copying the records"), [page = page_bytes_](std::size_t done, std::size_t all) {
    return page == 0 ? QString() : tr("Copied %1 of %2").arg(size_text(done * page), size_text(all * page));
  });
  task_ = ui::back_up(records_, settings_.backup_folder(database_), actor_, on_window<Stored<BackedUp>>(this, &StationPage::show_backed_up),
                      std::move(progress));
}

void StationPage::show_backed_up(const Stored<BackedUp>& made) {
  end();
  show_backups();
  if (!made && made.error().code == StorageError::stopped) {
    return band_->show_message(Band::Kind::look, tr("The backup was stopped."), tr("No backup was made, and the records are unchanged."));
  }
  if (!made) {
    const Message message = describe_backup_failure(made.error(), settings_.backup_folder(database_));
    band_->show_message(Band::Kind::bad, tr("No backup was made."), message.what + u' ' + message.more);
    return;
  }
  if (made->not_removed) {
    const StorageFailure& old = *made->not_removed;
    band_->show_message(Band::Kind::look, tr("The backup is made and checked. An old one could not be removed."),
                        tr("%1: %2.").arg(isolate(QString::fromStdString(old.where)), QString::fromLocal8Bit(old.detail.c_str())));
    return;
  }
  const Backup* backup = &made->backup;
  band_->show_message(Band::Kind::good, tr("The backup is made and checked."),
                      tr("%n session(s), %1.", nullptr, static_cast<int>(backup->sessions)).arg(size_text(backup->bytes)));
}

void StationPage::choose_folder() {
  FileWish wish;
  wish.title = tr("Choose a folder for backups");
  wish.what = FileWish::What::folder;
  wish.saving = false;
  ports_.pick_file(this, wish, [this](const QString& path) {
    const bool kept = settings_.set_backup_folder(path);
    show_backups();
    if (!kept) band_->show_message(Band::Kind::bad, tr("The folder holds until Cusp is closed."), tr("%1 cannot be written, so the next start does not know the folder.").arg(settings_.file()));
  });
}

void StationPage::verify() {
  if (working()) return;
  auto progress = begin(tr("Verifying every record"), [](std::size_t done, std::size_t all) {
    return tr("Verified %1 of %2 attempts").arg(count_text(done), count_text(all));
  });
  task_ = verify_records(records_, on_window<Stored<StoreVerification>>(this, &StationPage::show_verified), std::move(progress));
}

void StationPage::show_verified(const Stored<StoreVerification>& proof) {
  end();
  if (!proof) {
    const Message message = describe(proof.error());
    band_->show_message(Band::Kind::bad, message.what, message.more);
    return;
  }
  if (!proof->findings.empty()) return show_findings(*proof);
  if (proof->stopped) {
    band_->show_message(Band::Kind::look, tr("The verification was stopped."),
                        tr("Attempts verified and whole: %1. The others were not verified.").arg(count_text(proof->sessions)));
    return;
  }
  band_->show_message(Band::Kind::good, tr("%n session(s) and the audit log are whole.", nullptr, static_cast<int>(proof->sessions)), {});
}

/// A stopped verification has them, too.
void StationPage::show_findings(const StoreVerification& proof) {
  QStringList more;
  for (std::size_t i = 0; i < proof.findings.size() && i < kFindingsShown; ++i) more += finding_text(proof.findings[i]);
  if (proof.stopped) more += tr("You stopped it; the other attempts were not verified.");
  band_->show_message(Band::Kind::bad, tr("%n finding(s): something was changed from outside.", nullptr, static_cast<int>(proof.findings.size())),
                      more.join(u' '));
}

}  // namespace cusp::ui
