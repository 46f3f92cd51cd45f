/// What the editor's forms are made of: a number with its unit, a row with its label.
#pragma once

#include <functional>

#include "ui/widgets/number_field.h"

class QBoxLayout;
class QLabel;

namespace cusp::ui {

class EditorModel;

/// A number that changes the exercise as it is turned; leaving it ends the step of undo.
class NumberBox : public NumberField {
  Q_OBJECT

 public:
  /// `unit` may be empty. `take` is false where the value was refused: then the box shows what there is, and says so.
  NumberBox(EditorModel& model, const QString& name, const QString& unit, double least, double most, double step,
            int decimals, std::function<bool(double)> take);
  /// Shows the exercise's value without changing anything.
  void show_value(double value);

 protected:
  bool event(QEvent* event) override;

 private:
  double shown_ = 0;
};

/// Label at the left, field at the right, a number's note below; the label is the field's buddy.
QLabel* add_row(QBoxLayout* column, const QString& label, QWidget* field);
/// A section's title with quiet text at the right.
void add_section(QBoxLayout* column, const QString& title, QLabel** aside = nullptr);

}  // namespace cusp::ui
