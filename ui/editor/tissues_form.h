/// Stiffness and removal speed of each tissue with the source of the figure, and the handpiece with its tilt and turn. Thread: GUI.
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

#include "scenarios/tissues/tissue_facts.h"
#include "ui/editor/editor_model.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QVBoxLayout;

namespace cusp::ui {

class NumberBox;

class TissuesForm : public QWidget {
  Q_OBJECT

 public:
  explicit TissuesForm(EditorModel& model, QWidget* parent = nullptr);

 private:
  struct Row {
    NumberBox *stiffness, *speed;
    QLabel *stiffness_note, *speed_note;
  };
  void follow_model();
  Row make_row(std::size_t index, const QString& name);

  EditorModel& model_;
  QVBoxLayout* list_;
  std::vector<Row> rows_;
  QStringList built_;  // names of rows_, in order
  QComboBox* handpiece_;
  NumberBox *tilt_, *turn_;
  QCheckBox *vibration_, *sound_, *heat_, *friction_;
};

/// Source of a figure: set here, usual with its source, or usual and not verified.
QString figure_note(double value, const Sourced<double>& usual);

}  // namespace cusp::ui
