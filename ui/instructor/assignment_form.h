/// Assigns an exercise to a cohort: which one, as practice or assessment, from when, until when, how many attempts. Thread: GUI.
#pragma once

#include <QDateTime>
#include <optional>
#include <vector>

#include "ui/student/exercises.h"
#include "ui/widgets/parts.h"

class QCheckBox;
class QComboBox;
class QDateTimeEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace cusp::ui {

class AssignmentForm : public Card {
  Q_OBJECT

 public:
  /// What is to be assigned; the version is the page's to find.
  struct Wish {
    Exercise exercise;
    std::optional<QDateTime> opens, due;  // local time
    std::optional<int> attempts;          // none = any number
    std::vector<std::string> device_classes;  // admitted; none = every one
    bool admits_none = false;                 // no device is chosen
    SessionKind kind = SessionKind::practice;  // or assessment
    QString start_code;                        // of an assessment
    std::optional<int> self_test_days;         // of an assessment; none = not asked
    bool drawn_tooth = false;                  // of an assessment: another tooth for each candidate
  };

  /// `now`: from which usual dates are counted.
  AssignmentForm(std::vector<Exercise> exercises, const QDateTime& now, QWidget* parent = nullptr);
  /// The exercise that was chosen stays so, in the version that is there now; where it is gone, none is chosen.
  void set_exercises(std::vector<Exercise> exercises);
  bool has_exercise() const;  // one is chosen
  void choose_exercise(const ScenarioId& id);
  const Exercise* find(const ScenarioId& id) const;  // null: not in the list
  void choose_due(const QDateTime& due);
  void choose_kind(SessionKind kind);
  /// Empty = every one.
  void choose_devices(const std::vector<std::string>& device_classes);
  /// Of an assessment.
  void choose_self_test(int days);
  /// Of an assessment, where the exercise can be fitted to other teeth.
  void choose_drawn_tooth();
  /// Another code for the next assessment.
  void draw_start_code();
  Wish wish() const;  // pre: has_exercise()
  QPushButton* act() const { return act_; }
  /// A field differs from what the form began with, or from what it assigned last.
  bool changed() const { return changed_; }
  void enable_act();
  /// Until a field changes. Nothing of the form waits then.
  void disable_act();

 Q_SIGNALS:
  void assign_wanted();

 private:
  struct Moment {
    QCheckBox* on = nullptr;
    QDateTimeEdit* when = nullptr;
  };
  void fill_exercises(std::vector<Exercise> exercises);
  const Exercise& chosen_exercise() const;  // pre: has_exercise()
  QWidget* make_devices();
  QWidget* make_self_test();
  QWidget* make_teeth();
  /// Offers other teeth where the exercise can be fitted to them; says why where not.
  void offer_teeth();
  /// Each change of a field enables the button.
  void watch_fields();
  void note_change();
  Moment add_moment(class QFormLayout& form, const QString& label, const QDateTime& usual);

  std::vector<Exercise> exercises_;
  QComboBox* exercise_;
  Segments* kind_;
  QLineEdit* code_;
  QWidget* code_row_;
  QWidget* self_test_row_;
  QCheckBox* self_test_;
  QSpinBox* self_test_days_;
  QWidget* teeth_row_;
  QCheckBox* drawn_tooth_;
  QLabel* remark_;  // on other teeth for the exercise
  Moment opens_, due_;
  QSpinBox* attempts_;
  std::vector<std::pair<std::string, QCheckBox*>> devices_;  // by device class
  QPushButton* act_;
  bool changed_ = false;
};

}  // namespace cusp::ui
