/// A student's assessments: which are assigned, in what state, and the question before one begins. Thread: GUI.
#pragma once

#include <QDialog>
#include <vector>

#include "ui/student/exercises.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/parts.h"

class QLineEdit;
class QPushButton;

namespace cusp::ui {

struct AssignedAssessment {
  enum class State : std::uint8_t {
    later,      // opens at a later moment
    open,       // may begin now
    other_device,  // may begin now, but not with this station's device
    self_test_due,  // may begin now, when this station's device has passed a newer self-test
    running,    // an attempt runs in another window
    interrupted,  // an attempt was interrupted, and this station can continue it or hand it in
    broken_off,   // an attempt was interrupted, and this station can do neither
    handed_in,  // no attempt is left, or after one the time is over or the assignment withdrawn; its result is withheld
    missed,     // the time is over without an attempt
  };
  Assignment assignment;
  Exercise exercise;  // in the assigned version
  int attempts = 0;
  Adjustment adjustment{};
  State state = State::open;
  bool resumable = true;  // of interrupted: false if this station can only hand it in, or draws no tooth
};

struct AssignedAssessments {
  std::vector<AssignedAssessment> shown;  // by due date, those that are over last
  int unreadable = 0;                     // not over, but this program cannot read their version
};

/// Assessments of the student's cohorts. Without those whose every result is released, those missed more than 30 days ago, and those of
/// a withdrawn version that the student has not begun. `device_class`: of this station's device.
Stored<AssignedAssessments> load_assessments(Store& store, const Actor& student, const QDateTime& now, const std::string& device_class);

/// Why the student may not practise an exercise: the own assessment of it runs, or is interrupted and not handed in on this station.
/// nullopt: practice may start.
std::optional<Message> why_no_practice(Store& store, const Actor& student, ScenarioId exercise);
/// The same where the records cannot be read: nobody knows what an attempt would count for.
Message unread_practice(const StorageFailure& why);

/// One assessment on the start page.
class AssessmentCard : public Card {
  Q_OBJECT

 public:
  /// `device_class`: of this station's device.
  AssessmentCard(const AssignedAssessment& assessment, UserId student, const std::string& device_class, QWidget* parent = nullptr);
  /// Null unless it may begin now. Disabled after forbid_opengl(), and the card gives the reason.
  QPushButton* start_button() const { return start_; }

 Q_SIGNALS:
  void start_wanted();

 private:
  QPushButton* start_ = nullptr;
};

/// Asks for the invigilator's start code; accepted once the records admit it.
class AssessmentStart : public QDialog {
  Q_OBJECT

 public:
  /// Dates, attempts and devices of the assignment bind a start alone.
  enum class Purpose : std::uint8_t { start, resume };
  /// `device_class`: of this station's device.
  AssessmentStart(Store& store, const Actor& student, const AssignedAssessment& assessment, const std::string& device_class, Purpose purpose,
                  QWidget* parent);

 Q_SIGNALS:
  void admitted(const QString& start_code);

 private:
  void add_rules(class QVBoxLayout& column);
  void submit();
  Store& store_;
  Actor student_;
  AssignedAssessment assessment_;
  std::string device_class_;
  Purpose purpose_;
  class Band* band_;
  QLineEdit* code_;
};

/// What follows a finished assessment: nothing of the result.
class HandedIn : public QWidget {
  Q_OBJECT

 public:
  explicit HandedIn(const QString& candidate, QWidget* parent = nullptr);

 Q_SIGNALS:
  void next_wanted();   // the next candidate: this one is signed out
  void start_wanted();  // the start page
};

/// "30 min", or an empty text without a limit.
QString time_limit_text(const AssignedAssessment& assessment);

}  // namespace cusp::ui
