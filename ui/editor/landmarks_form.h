/// Landmarks of a tooth from a file: proposes them for a tooth's number, lists them, and changes the chosen one by numbers. Each change
/// is an edit at once. Thread: GUI.
#pragma once

#include <QWidget>
#include <array>

#include "ui/editor/editor_model.h"
#include "ui/text/failure_text.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;
class QVBoxLayout;

namespace cusp::ui {

class Band;
class Busy;
class LandmarkJob;
class NumberBox;

class LandmarksForm : public QWidget {
  Q_OBJECT

 public:
  explicit LandmarksForm(EditorModel& model, QWidget* parent = nullptr);

 private:
  void make_proposing(QVBoxLayout& column);
  void make_list(QVBoxLayout& column);
  void make_buttons(QVBoxLayout& column);
  void make_numbers(QVBoxLayout& column);
  void follow_job();
  void propose();
  void stop();
  void take(const SpecimenLandmarks& proposed);
  void show_failure(const Message& message);
  void follow_model();
  void show_list();
  void show_chosen();

  EditorModel& model_;
  LandmarkJob* job_;
  Busy* busy_ = nullptr;
  Band* band_ = nullptr;
  QLabel* counts_ = nullptr;
  QComboBox *tooth_ = nullptr, *point_ = nullptr;
  QPushButton *propose_ = nullptr, *accept_ = nullptr, *accept_all_ = nullptr, *remove_ = nullptr;
  QVBoxLayout* busy_place_ = nullptr;
  int shown_fdi_ = 0;  // that the box took from the exercise last
  QWidget* marked_ = nullptr;  // what is shown of landmarks that are there
  QTreeWidget* list_ = nullptr;
  std::array<NumberBox*, 3> numbers_{};  // x, y, z
};

}  // namespace cusp::ui
