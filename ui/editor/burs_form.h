/// The burs that an exercise lends to students. Thread: GUI.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/editor/editor_model.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace cusp::ui {

class NumberBox;

class BursForm : public QWidget {
  Q_OBJECT

 public:
  explicit BursForm(EditorModel& model, QWidget* parent = nullptr);

 private:
  void follow_model();
  void fill_catalogue();
  void show_uses();

  EditorModel& model_;
  QVBoxLayout* list_;
  QComboBox* shapes_;
  QComboBox* catalogue_;
  QLabel* uses_;
  QPushButton* add_;
  std::vector<NumberBox*> diameters_;  // one for each round bur, in the order of the rows
  std::vector<std::string> built_;  // names of the rows, in order
};

}  // namespace cusp::ui
