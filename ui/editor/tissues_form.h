/// How each tissue of the exercise feels and how fast it goes, where its figure comes from, and what handpiece is used.
#pragma once

#include <QWidget>
#include <vector>

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
  Row make_row(std::size_t index);

  EditorModel& model_;
  QVBoxLayout* list_;
  std::vector<Row> rows_;
  std::vector<Tissue> built_;  // of rows_, in order
  QComboBox* handpiece_;
  QCheckBox *vibration_, *sound_, *heat_, *friction_;
};

/// Where a figure comes from, in words: set here, the usual one with its source, or the usual one that nobody verified.
QString figure_note(double value, double usual, const std::string& source, bool verified);

}  // namespace cusp::ui
