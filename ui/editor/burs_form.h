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

class BurPicture;
class NumberBox;

class BursForm : public QWidget {
  Q_OBJECT

 public:
  explicit BursForm(EditorModel& model, QWidget* parent = nullptr);

 private:
  struct Row {
    BurPicture* picture;
    QLabel *name, *shape, *size;  // no size of a round bur
    NumberBox* diameter;          // of a round bur alone
    QPushButton* remove;
  };

  void follow_model();
  Row make_row(std::size_t index);
  void show_row(const Row& row, const Bur& bur);
  void fill_catalogue();
  void show_uses();

  EditorModel& model_;
  QVBoxLayout* list_;
  QComboBox* shapes_;
  QComboBox* catalogue_;
  QLabel* uses_;
  QPushButton* add_;
  std::vector<Row> rows_;
  std::vector<Profile> built_;  // heads of the rows, in order
};

}  // namespace cusp::ui
