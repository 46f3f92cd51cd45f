/// Students from a spreadsheet's list: preview line by line, accounts with PINs, cohorts, PIN slips. Thread: GUI.
/// Each turn of the event loop makes one account, because a PIN's hash takes a tenth of a second.
#pragma once

#include <QWidget>
#include <map>
#include <vector>

#include "storage/store.h"
#include "ui/admin/pin_slips.h"
#include "ui/admin/student_list_model.h"
#include "ui/modules.h"
#include "ui/widgets/ports.h"

class QPushButton;

namespace cusp::ui {

class Band;
class Busy;

class PeopleImport : public QWidget {
  Q_OBJECT

 public:
  PeopleImport(Store& store, const Actor& actor, const Ports& ports, QWidget* parent = nullptr);
  const StudentListModel& model() const { return *model_; }
  const std::vector<PinSlip>& slips() const { return slips_; }
  QString message() const;
  bool working() const { return next_ < order_.size(); }

 public Q_SLOTS:
  void choose_file();
  void start();
  void save_slips();

 Q_SIGNALS:
  void back_wanted();

 private:
  void leave();
  void read_file(const QString& path);
  void step();
  enum class Ending : std::uint8_t { whole, stopped, failed };
  void end(Ending ending, const QString& what);
  /// True if the account stands and is in its cohort.
  bool make(const ListedStudent& student);
  Stored<CohortId> cohort_named(const QString& name);
  void fit_buttons();
  void show_failure(const StorageFailure& failure);

  Store& store_;
  Actor actor_;
  const Ports& ports_;
  StudentListModel* model_;
  Band* band_ = nullptr;
  Busy* busy_ = nullptr;
  QPushButton *choose_ = nullptr, *start_ = nullptr, *save_ = nullptr;
  std::vector<ListedStudent> order_;  // to be made; next_ comes next
  std::size_t next_ = 0;
  std::map<QString, CohortId> cohorts_;  // [name, case folded]
  std::vector<PinSlip> slips_;           // of this import; PINs stand nowhere else
  bool slips_saved_ = false;
};

}  // namespace cusp::ui
