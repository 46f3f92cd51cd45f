/// The other stations whose keys are known here. Thread: GUI.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "storage/exchange/exchange.h"
#include "ui/modules.h"

namespace cusp::ui {

/// A key, what people here call its station, and the newest file under it.
struct KnownStation {
  OtherKey key{};
  QString name{};
  std::optional<FileReadIn> newest{};
};

class StationsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kKey, kRole, kSince, kNewest, kColumns };
  using QAbstractTableModel::QAbstractTableModel;

  void set_stations(std::vector<KnownStation> stations);
  const KnownStation& station(int row) const { return stations_[static_cast<std::size_t>(row)]; }
  int row_of(const Hash256& key) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<KnownStation> stations_;
};

/// "20 Nov 2026": a key is known for years.
QString date_text(std::int64_t utc_us);
/// `name`, or the end of the station's id where nobody has named it.
QString station_text(const QString& name, const Uuid& station);

}  // namespace cusp::ui
