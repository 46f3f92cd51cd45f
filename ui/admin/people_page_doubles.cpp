// The people's page: who may be the same person by another account.

#include <QLabel>

#include "ui/admin/people_page.h"
#include "ui/admin/stations_model.h"
#include "ui/settings/settings.h"

namespace cusp::ui {

void PeoplePage::show_doubles() {
  QStringList lines;
  for (const PossibleDouble& one : doubles_) {
    const bool made_elsewhere = edited_ && one.other.id == edited_->id;
    if (!edited_ || (!made_elsewhere && one.account.id != edited_->id)) continue;
    const Account& same = made_elsewhere ? one.account : one.other;
    const QString who = tr("%1, %2", "name, number").arg(QString::fromStdString(same.name), QString::fromStdString(same.number));
    if (one.by_name_alone) {
      lines += tr("Perhaps the same person as %1: the names agree, and no cohort holds both.").arg(who);
      continue;
    }
    QStringList stations;
    for (const Uuid& station : one.stations)
      stations += station_text(names_ ? names_->station_name(QString::fromStdString(station.text())) : QString(), station);
    const QString by = stations.isEmpty() ? tr("another station") : stations.join(u", "_qs);
    lines += made_elsewhere ? tr("Perhaps the same person as %1. This account was made by: %2.").arg(who, by)
                            : tr("Perhaps the same person as %1. That account was made by: %2.").arg(who, by);
  }
  same_person_->setText(lines.join(u'\n'));
  same_person_->setVisible(!lines.isEmpty());
}

}  // namespace cusp::ui
