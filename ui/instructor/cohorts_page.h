/// Cohorts: makes them, puts students in by pasted numbers, assigns exercises to them and withdraws what is assigned. Thread: GUI.
#pragma once

#include <QWidget>
#include <optional>

#include "storage/store.h"
#include "ui/instructor/assignment_form.h"
#include "ui/instructor/cohort_models.h"
#include "ui/modules.h"
#include "ui/widgets/half_filled.h"
#include "ui/widgets/ports.h"
#include "ui/widgets/rereads.h"

class QGridLayout;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QStackedWidget;

namespace cusp::ui {

class Band;
class Table;

class CohortsPage : public QWidget, public Rereads, public HalfFilled {
  Q_OBJECT

 public:
  CohortsPage(Store& store, const Actor& actor, const Ports& ports, QWidget* parent = nullptr);
  const CohortsModel& cohorts() const { return *cohorts_; }
  const CohortStudentsModel& students() const { return *students_; }
  const AssignmentsModel& assignments() const { return *assignments_; }
  AssignmentForm* form() const { return form_; }  // null for a role that assigns nothing
  QString message() const;

  bool read_again() override;
  bool half_filled() const override;
  void make_cohort(const QString& name);
  void add_numbers(const QString& text);
  /// Asks first.
  void remove_chosen_student();
  void assign();
  /// Asks first.
  void withdraw_chosen_assignment();

 Q_SIGNALS:
  /// The attempts of an assignment.
  void results_wanted(AssignmentId assignment);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* make_list();
  QWidget* make_students();
  QWidget* make_assignments();
  void read();
  void show_chosen();
  void show_assignments();
  void fit_assignment();
  /// The form's assignment for a cohort. Nullopt, and a message, if the records fail.
  std::optional<Assignment> assignment_for(const AssignmentForm::Wish& wish, CohortId cohort);
  /// The form's exercises as another desk has left them.
  void read_exercises();
  /// Of a version that another desk withdrew while the form had it.
  void show_withdrawn(const Exercise& exercise);
  /// Nullopt, and a message, where nothing is chosen.
  std::optional<Cohort> chosen();
  void show_failure(const StorageFailure& failure);
  /// Of the chosen cohort: the message goes with the choice.
  void show_unread(const StorageFailure& failure);

  Store& store_;
  Actor actor_;
  const Ports& ports_;
  CohortsModel* cohorts_;
  CohortStudentsModel* students_;
  AssignmentsModel* assignments_;
  Band* band_ = nullptr;
  QString unread_;  // the message of show_unread(); empty: the chosen cohort was read
  QStackedWidget* below_ = nullptr;  // the list, or that there is no cohort
  Table *list_ = nullptr, *table_ = nullptr, *assigned_ = nullptr;
  QLineEdit* name_ = nullptr;
  QPlainTextEdit* numbers_ = nullptr;
  QPushButton *add_ = nullptr, *remove_ = nullptr, *results_ = nullptr, *withdraw_ = nullptr;
  Card *students_card_ = nullptr, *assignments_card_ = nullptr;
  QGridLayout* columns_ = nullptr;  // list, students with what is assigned, form
  AssignmentForm* form_ = nullptr;
};

}  // namespace cusp::ui
