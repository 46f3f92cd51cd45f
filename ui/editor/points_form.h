/// What is graded, and for how many points: criteria with weight and bands, pass mark, what fails an attempt outright.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/editor/editor_model.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace cusp::ui {

class NumberBox;

class PointsForm : public QWidget {
  Q_OBJECT

 public:
  explicit PointsForm(EditorModel& model, QWidget* parent = nullptr);

 private:
  struct Row {
    NumberBox* weight;
    QPushButton* open;
    QWidget* bands;
    NumberBox* edges[6];
  };
  void follow_model();
  void build_rows();
  Row make_row(std::size_t index);

  EditorModel& model_;
  QLabel* sum_;
  NumberBox* pass_;
  QCheckBox *pulp_, *dry_;
  QComboBox* metric_;
  QPushButton* add_;
  QVBoxLayout* list_;
  std::vector<Row> rows_;
  std::vector<std::string> built_;  // metrics of rows_, in order
  std::string open_;                // metric whose bands are shown
};

/// Bands to begin with: those of the exercises that come with the program, depths moved to this target's; where none
/// asks for the metric, bands that take no points.
Bands first_bands(const std::string& metric, const Target& target);

}  // namespace cusp::ui
