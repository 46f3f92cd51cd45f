/// The target in numbers: everything that its handles change, tolerance zone and time limit. Thread: GUI.
#pragma once

#include <QWidget>
#include <array>
#include <functional>

#include "ui/editor/editor_model.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace cusp::ui {

class NumberBox;
class Segments;

class ShapeForm : public QWidget {
  Q_OBJECT

 public:
  explicit ShapeForm(EditorModel& model, QWidget* parent = nullptr);

 private:
  struct Range {
    double least, most;
  };
  NumberBox* length(const QString& name, Range mm, std::function<bool(double)> take);
  void make_size(QVBoxLayout* column);
  void make_tapers(QVBoxLayout* column);
  void make_points(QVBoxLayout* column);
  void make_tolerances(QVBoxLayout* column);
  void follow_model();
  void show_point();

  EditorModel& model_;
  QLabel *title_, *top_label_, *faces_;
  struct Taper {
    NumberBox* box;
    QLabel* label;
  };
  std::array<Taper, 4> tapers_{};  // of the sides -x, +x, -y, +y
  NumberBox *depth_, *width_, *length_, *box_width_, *top_, *corner_, *x_, *y_, *floor_, *side_, *time_;
  QWidget *drawn_, *slot_rows_, *box_rows_, *point_buttons_;
  QComboBox* point_;
  QPushButton *add_, *remove_, *branch_;
  Segments* strictness_;
};

/// "Channel", "Fissure outline", "Box".
QString shape_name(const std::string& shape);
/// The same of a target; "Composed shape" of a tree.
QString target_name(const Region& target);

}  // namespace cusp::ui
