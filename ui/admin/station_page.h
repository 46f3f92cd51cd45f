/// The station's records: where they lie and how large they are, backups, and verification. Thread: GUI; copies and proofs run in
/// the background on stores of their own.
#pragma once

#include <QWidget>
#include <memory>

#include "storage/backup/backup.h"
#include "storage/store.h"
#include "ui/admin/backup_work.h"
#include "ui/admin/work_run.h"
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
class NumberField;
class RecordingsCard;

class StationPage : public QWidget, public AtWork {
  Q_OBJECT

 public:
  /// Settings and ports outlive the page.
  StationPage(Store& store, const Actor& actor, Settings& settings, const Ports& ports, QWidget* parent = nullptr);
  QString message() const;
  bool working() const override { return run_->running(); }
  RecordingsCard& recordings() { return *recordings_; }

 public Q_SLOTS:
  void back_up();
  void choose_folder();
  void verify();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void read_size(Store& store);
  QWidget* make_records();
  QWidget* make_backups();
  QWidget* make_idle();
  /// Reads the folder in the background: a network drive may not answer, and another folder can be chosen meanwhile.
  void show_backups();
  void show_found(const FoundBackups& found);
  void show_backed_up(const Stored<BackedUp>& made);
  void show_verified(const Stored<StoreVerification>& proof);
  void show_findings(const StoreVerification& proof);
  std::shared_ptr<WorkProgress> begin(const QString& what, WorkRun::Counted counted);
  void end();

  std::filesystem::path database_;
  RecordsBeside records_;
  Uuid station_;
  Actor actor_;
  Settings& settings_;
  const Ports& ports_;
  std::uint64_t page_bytes_ = 0;  // of the records; 0: it could not be read
  QString holds_;                 // how many sessions, and their size; or that these could not be read
  QString key_;  // fingerprint of the station's key; empty: opened for reading
  BackgroundTask task_, finding_;
  int asked_ = 0;  // calls of show_backups()
  QBoxLayout* columns_ = nullptr;
  Band* band_;
  WorkRun* run_;
  NumberField* idle_ = nullptr;
  RecordingsCard* recordings_ = nullptr;
  QLabel *folder_ = nullptr, *newest_ = nullptr;
  QPushButton *back_up_ = nullptr, *choose_ = nullptr, *verify_ = nullptr;
  BackupsTable* table_ = nullptr;
};

}  // namespace cusp::ui
