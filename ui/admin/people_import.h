/// Students from a spreadsheet's list: preview line by line, accounts with PINs, cohorts, PIN slips. Thread: GUI.
/// people_import_work.h makes them on a thread of its own.
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "storage/store.h"
#include "ui/admin/people_import_work.h"
#include "ui/admin/student_list_model.h"
#include "ui/admin/work_run.h"
#include "ui/modules.h"
#include "ui/widgets/ports.h"

class QPushButton;
class QStackedWidget;

namespace cusp::ui {

class Band;

class PeopleImport : public QWidget {
  Q_OBJECT

 public:
  PeopleImport(Store& store, const Actor& actor, const Ports& ports, QWidget* parent = nullptr);
  /// Stops the work before its next line: it then makes nothing.
  ~PeopleImport() override;
  const StudentListModel& model() const { return *model_; }
  const std::vector<PinSlip>& slips() const { return slips_; }
  QString message() const;
  bool working() const { return progress_ != nullptr; }
  /// Accounts are being made, or their PINs stand nowhere else yet.
  bool unsaved() const { return working() || !(slips_.empty() || slips_saved_); }

 public Q_SLOTS:
  void choose_file();
  void start();
  /// Before the next line, so that nothing is made; the page says so.
  void stop();
  void save_slips();

 Q_SIGNALS:
  void back_wanted();

 private:
  void leave();
  void read_file(const QString& path);
  void end(const PeopleImportEnd& end);
  void show_end(const PeopleImportEnd& end);
  void fit_buttons();
  /// The lines that make an account or join a cohort.
  std::vector<ListedStudent> to_do() const;
  void show_failure(const StorageFailure& failure);

  Store& store_;
  Actor actor_;
  const Ports& ports_;
  StudentListModel* model_;
  QStackedWidget* shown_ = nullptr;  // why there are none, and the table
  Band* band_ = nullptr;
  WorkRun* run_ = nullptr;
  QPushButton *choose_ = nullptr, *start_ = nullptr, *save_ = nullptr;
  BackgroundTask task_;
  std::shared_ptr<WorkProgress> progress_;  // of the work that runs
  std::vector<PinSlip> slips_;  // of every start since they were saved; PINs stand nowhere else
  bool slips_saved_ = false;
};

}  // namespace cusp::ui
