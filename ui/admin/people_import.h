/// Students from a spreadsheet's list: preview line by line, PIN slips, accounts with PINs, cohorts. Thread: GUI.
/// people_import_work.h makes the accounts on a thread of its own, once the slips are written: no PIN is lost with the program.
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "storage/store.h"
#include "ui/admin/people_import_work.h"
#include "ui/admin/student_list_model.h"
#include "ui/admin/work_run.h"
#include "ui/modules.h"
#include "ui/widgets/at_work.h"
#include "ui/widgets/ports.h"

class QPushButton;
class QStackedWidget;

namespace cusp::ui {

class Band;

class PeopleImport : public QWidget, public AtWork {
  Q_OBJECT

 public:
  PeopleImport(Store& store, const Actor& actor, const Ports& ports, QWidget* parent = nullptr);
  /// Stops the work before its next line: it then makes nothing.
  ~PeopleImport() override;
  const StudentListModel& model() const { return *model_; }
  QString message() const;
  bool working() const override { return progress_ != nullptr; }

 public Q_SLOTS:
  void choose_file();
  /// Asks where the PIN slips go, if a line brings an account.
  void start();
  /// Before the next line, so that nothing is made; the page says so.
  void stop();

 Q_SIGNALS:
  void back_wanted();

 private:
  void leave();
  void read_file(const QString& path);
  /// `slips`: the new file of the PIN slips; empty: there are none.
  void make(const QString& slips);
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
  QPushButton *choose_ = nullptr, *start_ = nullptr;
  BackgroundTask task_;
  std::shared_ptr<WorkProgress> progress_;  // of the work that runs
};

}  // namespace cusp::ui
