/// Parts of the editor's forms: a number with its unit, a labelled row. Thread: GUI.
#pragma once

#include <functional>

#include "ui/widgets/number_field.h"

class QBoxLayout;
class QLabel;
class QPushButton;

namespace cusp::ui {

class EditorModel;

/// A number of the exercise: each step changes it, and leaving the field ends the step of undo.
class NumberBox : public NumberField {
  Q_OBJECT

 public:
  /// `unit` may be empty. If `take` returns false, the box shows the old value and a message.
  NumberBox(EditorModel& model, const QString& name, const QString& unit, double least, double most, double step,
            int decimals, std::function<bool(double)> take);
  /// Shows the exercise's value without a signal.
  void show_value(double value);

 protected:
  bool event(QEvent* event) override;

 private:
  double shown_ = 0;
};

/// Label at the left, field at the right, the message of a NumberField below. The label is the field's buddy.
QLabel* add_row(QBoxLayout* column, const QString& label, QWidget* field);
/// A checkable link of any length: its text takes as many lines as the width needs. `text` is its accessible name too.
QPushButton* make_wrapping_link(const QString& text);
/// Tab goes through the form in the order of its layout: rows that were made later would come last.
void tab_by_layout(QWidget& form);
/// A section's title with quiet text at the right.
void add_section(QBoxLayout* column, const QString& title, QLabel** aside = nullptr);

}  // namespace cusp::ui
