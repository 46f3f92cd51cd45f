#include "ui/admin/way_back.h"

#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "storage/store.h"
#include "ui/admin/backups_table.h"
#include "ui/admin/on_window.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

/// Several stations may share a folder. False where nothing names this one.
bool is_of_another(const Backup& backup, const std::optional<Uuid>& station) { return station && backup.station != *station; }

}  // namespace

WayBack::WayBack(std::filesystem::path database, std::filesystem::path backups, const Message& why, const Ports& ports, QWidget* parent)
    : QWidget(parent), database_(std::move(database)), station_(station_beside(database_)), ports_(ports) {
  setAccessibleName(tr("Go back to a backup"));
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* body = nullptr;
  outer->addWidget(make_scroll_page(&body));
  body->setSpacing(px(12));
  body->addWidget(new PageHead(why.what));
  body->addWidget(make_paragraph(why.more));
  body->addWidget(make_paragraph(tr("A backup can take the place of the records. The files that stand there now are moved to a folder beside them; nothing is deleted or overwritten. "
                           "Attempts after the backup stay in that folder alone.")));
  band_ = new Band;
  body->addWidget(band_);
  busy_ = new Busy;
  busy_->hide();
  body->addWidget(busy_);
  found_ = make_paragraph({});
  auto* card = new Card(tr("Backups"));
  card->body()->addWidget(found_);
  table_ = new BackupsTable;
  card->body()->addWidget(table_, 1);
  body->addWidget(card, 1);
  auto* row = new QHBoxLayout;
  go_back_ = make_button(tr("Go back to this backup"), ButtonKind::primary);
  choose_ = make_button(tr("Look in another folder"));
  again_ = make_button(tr("Try the records again"));
  for (QPushButton* button : {go_back_, choose_, again_}) row->addWidget(button);
  row->addStretch();
  body->addLayout(row);
  connect(go_back_, &QPushButton::clicked, this, &WayBack::go_back);
  connect(choose_, &QPushButton::clicked, this, &WayBack::choose_folder);
  connect(again_, &QPushButton::clicked, this, &WayBack::try_again);
  look_into(backups);
  setFocusProxy(choose_);
}

QString WayBack::message() const { return band_->isVisibleTo(this) ? band_->text() : QString(); }

void WayBack::look_into(const std::filesystem::path& folder) {
  folder_ = folder;
  found_->setText(tr("%1 is being read.").arg(QString::fromStdString(folder.string())));
  table_->show_backups({});
  go_back_->setEnabled(false);
  finding_ = find_backups(folder, std::nullopt, ++asked_, on_window<FoundBackups>(this, &WayBack::show_found));
}

void WayBack::show_found(const FoundBackups& found) {
  if (found.asked != asked_) return;
  auto all = found.all;
  const QString name = QString::fromStdString(folder_.string());
  if (!all) {
    found_->setText(tr("%1 cannot be read: %2.").arg(name, QString::fromLocal8Bit(all.error().detail.c_str())));
  } else if (all->empty()) {
    found_->setText(tr("There is no backup in %1.").arg(name));
  } else {
    const auto others = std::ranges::stable_partition(*all, [this](const Backup& one) { return !is_of_another(one, station_); });
    found_->setText(tr("%n backup(s) in %1.", nullptr, static_cast<int>(all->size())).arg(name));
    if (!others.empty()) found_->setText(found_->text() + u' ' + tr("Those of other stations stand last."));
    if (const QString note = dates_note(*all); !note.isEmpty()) found_->setText(found_->text() + u' ' + note);
  }
  table_->show_backups(all ? std::move(*all) : std::vector<Backup>{});
  table_->choose_row(0);
  go_back_->setEnabled(table_->chosen().has_value());
  if (go_back_->isEnabled() && choose_->hasFocus()) go_back_->setFocus();  // the next act
}

void WayBack::choose_folder() {
  FileWish wish;
  wish.title = tr("Choose a folder with backups");
  wish.what = FileWish::What::folder;
  wish.saving = false;
  ports_.pick_file(this, wish, [this](const QString& path) { look_into(path.toStdString()); });
}

void WayBack::go_back() {
  const auto backup = table_->chosen();
  if (!backup || busy_->isVisible()) return;
  const Question question{.what = tr("Go back to the backup of %1?").arg(format_day_time(local_time(backup->made_utc_us))),
                          .more = (is_of_another(*backup, station_) ? tr("It is of another station, whose records take the place of these.") + u' ' : QString()) +
                                  tr("It holds %n session(s). No other Cusp may run with these records.", nullptr, static_cast<int>(backup->sessions)),
                          .act = tr("Go back")};
  ports_.ask(this, question, [this, chosen = *backup](bool yes) {
    if (yes) begin(chosen);
  });
}

void WayBack::begin(const Backup& backup) {
  enable(false);
  band_->clear();
  busy_->start(tr("Checking and copying the backup"), Busy::Cancel::none);
  task_ = ui::go_back(database_, backup, on_window<Stored<WentBack>>(this, &WayBack::show_went_back));
}

void WayBack::show_went_back(const Stored<WentBack>& done) {
  busy_->finish();
  enable(true);
  if (!done) {
    const Message message = describe(done.error());
    band_->show_message(Band::Kind::bad, tr("The backup was not put in place."), message.what + u' ' + message.more);
    return;
  }
  Q_EMIT went_back({tr("The records are those of %1.").arg(format_day_time(local_time(done->backup.made_utc_us))),
                    tr("What stood there before is kept in %1.").arg(QString::fromStdString(done->aside.string()))});
}

void WayBack::enable(bool on) {
  for (QPushButton* button : {go_back_, choose_, again_}) button->setEnabled(on);
  table_->setEnabled(on);
}

}  // namespace cusp::ui
