/// The station's records: where they lie and how large they are, backups, and verification. Thread: GUI; copies and proofs run in
/// the background on stores of their own.
#pragma once

#include <QWidget>
#include <memory>

#include "storage/backup/backup.h"
#include "storage/store.h"
#include "ui/admin/backup_work.h"
#include "ui/modules.h"
#include "ui/settings/settings.h"
#include "ui/widgets/at_work.h"
#include "ui/widgets/ports.h"

class QBoxLayout;
class QLabel;
class QPushButton;

namespace cusp::ui {

class BackupsTable;
class Band;
class Busy;
class NumberField;
class RecordingsCard;

class StationPage : public QWidget, public AtWork {
  Q_OBJECT

 public:
  /// Settings and ports outlive the page.
  StationPage(Store& store, const Actor& actor, Settings& settings, const Ports& ports, QWidget* parent = nullptr);
  QString message() const;
  bool working() const override { return working_; }
  RecordingsCard& recordings() { return *recordings_; }

 public Q_SLOTS:
  void back_up();
  void choose_folder();
  void verify();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* make_records();
  QWidget* make_backups();
  QWidget* make_idle();
  void show_backups();
  void show_backed_up(const Stored<BackedUp>& made);
  void show_verified(const Stored<StoreVerification>& proof);
  void begin(const QString& what);
  void end();

  std::filesystem::path database_;
  RecordsBeside records_;
  Uuid station_;
  Actor actor_;
  Settings& settings_;
  const Ports& ports_;
  std::uint64_t sessions_ = 0, bytes_ = 0;
  QString key_;  // fingerprint of the station's key; empty: opened for reading
  bool working_ = false;
  BackgroundTask task_;
  QBoxLayout* columns_ = nullptr;
  Band* band_;
  Busy* busy_ = nullptr;
  NumberField* idle_ = nullptr;
  RecordingsCard* recordings_ = nullptr;
  QLabel *folder_ = nullptr, *newest_ = nullptr;
  QPushButton *back_up_ = nullptr, *choose_ = nullptr, *verify_ = nullptr;
  BackupsTable* table_ = nullptr;
};

}  // namespace cusp::ui
