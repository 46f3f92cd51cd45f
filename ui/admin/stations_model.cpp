#include "ui/admin/stations_model.h"

#include "ui/text/exchange_text.h"
#include "ui/text/incident_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

constexpr int kIdShown = 8;  // signs at the end of an id, which are random; it begins with a time

Chip::Kind chip_of(KeyRole role) {
  if (role == KeyRole::revoked) return Chip::Kind::bad;
  return role == KeyRole::former ? Chip::Kind::look : Chip::Kind::good;
}

}  // namespace

QString date_text(std::int64_t utc_us) { return QLocale().toString(local_time(utc_us).date(), date_pattern()); }

QString station_text(const QString& name, const Uuid& station) {
  return name.isEmpty() ? StationsModel::tr("Station %1").arg(QString::fromStdString(station.text()).right(kIdShown)) : name;
}

void StationsModel::set_stations(std::vector<KnownStation> stations) {
  beginResetModel();
  stations_ = std::move(stations);
  endResetModel();
}

int StationsModel::row_of(const Hash256& key) const {
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    if (stations_[i].key.key == key) return static_cast<int>(i);
  }
  return -1;
}

int StationsModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(stations_.size()); }
int StationsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant StationsModel::data(const QModelIndex& index, int role) const {
  const KnownStation& known = station(index.row());
  const bool read = known.key.role == KeyRole::station || known.key.role == KeyRole::office;
  if (role == BoldRole) return index.column() == kName;
  if (role == QuietRole) return !read;
  if (role == ChipRole && index.column() == kRole) return static_cast<int>(chip_of(known.key.role));
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kName: return station_text(known.name, known.key.station);
    case kKey: return fingerprint(known.key.key);
    case kRole: return key_role_name(known.key.role);
    case kSince: return date_text(known.key.changed_utc_us);
    case kNewest:
      if (!known.newest) return tr("none yet");
      return tr("file %1, %2").arg(known.newest->number).arg(date_text(known.newest->at_utc_us));
    default: return {};
  }
}

QVariant StationsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kName: return tr("Name");
    case kKey: return tr("Fingerprint");
    case kRole: return tr("Known as");
    case kSince: return tr("Since");
    case kNewest: return tr("Last file read in");
    default: return {};
  }
}

}  // namespace cusp::ui
