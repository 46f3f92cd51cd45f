/// The audit log, newest first: filters by kind, person and date, verification and CSV in the background. Thread: GUI.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "storage/store.h"
#include "ui/admin/log_model.h"
#include "ui/admin/backup_work.h"
#include "ui/modules.h"
#include "ui/widgets/at_work.h"
#include "ui/widgets/ports.h"

class QComboBox;
class QDateEdit;
class QPushButton;
class QStackedWidget;
class QTimer;

namespace cusp::ui {

class Band;
class Busy;
class ExportRun;
class Table;

class LogPage : public QWidget, public AtWork {
  Q_OBJECT

 public:
  /// Ports outlive the page.
  LogPage(Store& store, const Actor& actor, const Ports& ports, QWidget* parent = nullptr);

  AuditFilter filter() const;
  const LogModel& model() const { return *model_; }
  Table* table() const { return table_; }
  QComboBox* kind() const { return kind_; }
  QComboBox* person() const { return person_; }
  QComboBox* period() const { return period_; }
  QDateEdit* first_day() const { return first_day_; }
  QDateEdit* last_day() const { return last_day_; }
  QString message() const;
  bool verifying() const { return progress_ != nullptr; }
  bool exporting() const;
  bool working() const override { return exporting(); }
  bool shows_none() const;

 public Q_SLOTS:
  void read();
  void show_all();
  void verify();
  void cancel_verification();
  void export_csv();
  void cancel_export();

 private:
  QWidget* make_filters();
  QWidget* make_table();
  void fill_people();
  /// The names of what entries concern. Returns the accounts; none if they cannot be read, which the band then says.
  std::vector<Account> read_names();
  void show_progress();
  void show_verified(const Stored<Verification>& proof);
  QString entry_line(std::int64_t number);
  /// The newest entry below a number; empty: there is none. nullopt: it failed, which the band then shows.
  std::optional<std::vector<AuditEntry>> newest_before(std::int64_t number);
  QWidget* make_export_progress();
  void export_to(const QString& path, const AuditFilter& shown);
  void show_failure(const StorageFailure& failure);

  Store& store_;
  Actor actor_;
  const Ports& ports_;
  LogModel* model_;
  LogNames names_;
  std::int64_t entries_ = 0;                // of the whole log when it was last verified
  std::shared_ptr<LogProgress> progress_;  // while a verification runs
  BackgroundTask task_;
  QTimer* look_;
  ExportRun* export_ = nullptr;
  Table* table_ = nullptr;
  QStackedWidget* below_ = nullptr;
  Band* band_ = nullptr;
  Band* unread_ = nullptr;  // shows after a page of the table that could not be read
  Busy* busy_ = nullptr;
  QComboBox *kind_ = nullptr, *person_ = nullptr, *period_ = nullptr;
  QWidget* days_ = nullptr;
  QDateEdit *first_day_ = nullptr, *last_day_ = nullptr;
  QPushButton* verify_ = nullptr;
};

}  // namespace cusp::ui
