/// Lists the choices of the exercise's model, then measures what each part of the exercise costs and changes, and finds the leanest exercise with the same grades. AuditJob measures;
/// taking the leanest is one step of undo. Thread: GUI.
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "ui/editor/audit_job.h"
#include "ui/editor/editor_model.h"

class QGridLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace cusp::ui {

class Busy;

/// "35 %, about 2 min left": by what the share took so far. Without the rest while too little has run to name it.
QString share_and_rest(double share, double elapsed_s);

class AuditPage : public QWidget {
  Q_OBJECT

 public:
  /// `runner_of` makes the runner that plays the draft; the draft may name a volume in that folder.
  AuditPage(EditorModel& model, std::function<AuditRunner(const std::string& folder)> runner_of, QWidget* parent = nullptr);
  ~AuditPage() override;

  const std::shared_ptr<const AuditReport>& report() const { return report_; }
  /// An audit runs; it ends with this page.
  bool measuring() const { return job_->running(); }

 private:
  void follow_job();
  void measure();
  void stop();
  void use_leanest();
  void show_report();
  void follow_model();
  void list_choices();
  void show_table();
  /// One line of the table: what was left out, what that says, and its three figures as text.
  struct Line {
    QString name, verdict;
    const char* ink = "text2";  // of the verdict
    QString us, mb, score;
  };
  void add_line(QGridLayout& grid, const Line& line);
  void add_results(QGridLayout& grid);

  EditorModel& model_;
  std::function<AuditRunner(const std::string& folder)> runner_of_;
  AuditJob* job_;
  Busy* busy_ = nullptr;
  std::shared_ptr<const AuditReport> report_;
  std::vector<Choice> listed_;  // in the table while there is no report
  std::map<std::uint8_t, std::string> listed_names_;  // of the tissues in it
  QElapsedTimer since_;  // the audit began
  QLabel *about_, *aside_, *leanest_title_, *leanest_, *legend_;
  QPushButton *measure_, *use_;
  QWidget* table_ = nullptr;
  QVBoxLayout *table_place_, *busy_place_;
};

}  // namespace cusp::ui
