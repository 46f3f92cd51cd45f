/// What is graded, and for how many points: criteria with weight and bands, pass mark, what fails an attempt outright.
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

#include "ui/editor/editor_model.h"

class QBoxLayout;
class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace cusp::ui {

class BandsForm;
class NumberBox;
class OperatorJob;

class PointsForm : public QWidget {
  Q_OBJECT

 public:
  explicit PointsForm(EditorModel& model, QWidget* parent = nullptr);

 private:
  struct Row {
    NumberBox* weight;
    QPushButton* open;
    QVBoxLayout* column;
    BandsForm* bands;  // null: not opened yet
  };
  void follow_model();
  void build_rows();
  QBoxLayout* make_measuring();
  void measure();
  void stop_measuring(const QString& why);
  void show_measuring();
  Row make_row(std::size_t index);
  void make_bands(std::size_t index);

  EditorModel& model_;
  QLabel* sum_;
  NumberBox* pass_;
  QCheckBox *pulp_, *damage_, *dry_, *own_;
  QComboBox* metric_;
  QPushButton *add_, *measure_;
  QLabel* measured_;
  OperatorJob* job_;
  Scenario measuring_;  // the exercise that they cut
  QVBoxLayout* list_;
  std::vector<Row> rows_;
  QStringList built_;  // metric and shown name of each of rows_, in order
  std::string open_;   // metric with its bands shown
};

}  // namespace cusp::ui
