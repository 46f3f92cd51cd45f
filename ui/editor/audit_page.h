/// What the exercise's model costs and what each part of it changes, and the leanest that marks the same: measured at the
/// press of a button, in the background, and taken with one step of undo. GUI thread.
#pragma once

#include <QWidget>
#include <memory>

#include "ui/editor/audit_job.h"
#include "ui/editor/editor_model.h"

class QGridLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace cusp::ui {

class Busy;

class AuditPage : public QWidget {
  Q_OBJECT

 public:
  /// `runner_of` makes what plays the draft, which may name a volume in that folder.
  AuditPage(EditorModel& model, std::function<AuditRunner(const std::string& folder)> runner_of, QWidget* parent = nullptr);
  ~AuditPage() override;

  QPushButton* measure_button() const { return measure_; }
  QPushButton* use_button() const { return use_; }
  const std::shared_ptr<const AuditReport>& report() const { return report_; }

 private:
  void measure();
  void stop();
  void use_leanest();
  void show_report();
  void follow_model();

  EditorModel& model_;
  std::function<AuditRunner(const std::string& folder)> runner_of_;
  AuditJob* job_;
  Busy* busy_ = nullptr;
  std::shared_ptr<const AuditReport> report_;
  Scenario measured_;  // what the report is of
  QLabel *about_, *aside_, *leanest_title_, *leanest_, *legend_;
  QPushButton *measure_, *use_;
  QWidget* table_ = nullptr;
  QVBoxLayout *table_place_, *busy_place_;
};

}  // namespace cusp::ui
