#include "ui/admin/backups_table.h"

#include <QLocale>
#include <QStandardItemModel>
#include <map>

#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

constexpr int kNumbers[] = {2, 3}, kFolder = 4;  // columns

}  // namespace

QString dates_note(const std::vector<Backup>& newest_first) {
  std::map<Uuid, std::int64_t> dates;  // [station] of the one above
  for (const Backup& one : newest_first) {
    const auto [above, first] = dates.try_emplace(one.station, one.made_utc_us);
    if (!first && above->second < one.made_utc_us) return BackupsTable::tr("A clock was wrong, so that the dates are not in order: the newest backup stands first.");
    above->second = one.made_utc_us;
  }
  return {};
}

BackupsTable::BackupsTable(QWidget* parent) : Table(parent), list_(new QStandardItemModel(this)) {
  setAccessibleName(tr("Backups"));
  list_->setHorizontalHeaderLabels({tr("Made"), tr("Kind"), tr("Sessions"), tr("Size"), tr("Folder")});
  for (const int column : kNumbers) list_->horizontalHeaderItem(column)->setTextAlignment(Qt::AlignTrailing | Qt::AlignVCenter);
  setModel(list_);
  set_stretch_column(kFolder);
}

void BackupsTable::show_backups(std::vector<Backup> backups) {
  backups_ = std::move(backups);
  list_->removeRows(0, list_->rowCount());
  for (const Backup& backup : backups_) {
    QList<QStandardItem*> cells;
    const QString kind = backup.kind == BackupKind::daily ? tr("Daily") : tr("By hand");
    for (const QString& text :
         {format_day_time(local_time(backup.made_utc_us)), kind, QLocale().toString(static_cast<qulonglong>(backup.sessions)),
          QLocale().formattedDataSize(static_cast<qint64>(backup.bytes), 1), QString::fromStdString(backup.folder.filename().string())}) {
      auto* cell = new QStandardItem(text);
      cell->setEditable(false);
      cells += cell;
    }
    for (const int column : kNumbers) cells[column]->setTextAlignment(Qt::AlignTrailing | Qt::AlignVCenter);
    list_->appendRow(cells);
  }
  for (int column = 0; column < kFolder; ++column) resizeColumnToContents(column);
}

std::optional<Backup> BackupsTable::chosen() const {
  const int row = chosen_row();
  return row >= 0 && row < static_cast<int>(backups_.size()) ? std::optional(backups_[static_cast<std::size_t>(row)]) : std::nullopt;
}

}  // namespace cusp::ui
