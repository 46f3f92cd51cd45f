/// A field for a number. Comma and full stop are decimal signs in every language; group separators are refused. A refused text
/// leaves the value, and a note below the field gives reason and range. Thread: GUI.
#pragma once

#include <QDoubleSpinBox>
#include <optional>

class QLabel;

namespace cusp::ui {

class NumberField : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit NumberField(QWidget* parent = nullptr);

  /// Widget of the message, hidden without one. add_field() and add_row() lay it out below the field; without a layout the
  /// message is a tool tip.
  QWidget* note() const { return note_; }
  /// Empty while none is shown.
  QString message() const;
  /// Sets the value without a signal; another value clears the message. A value outside the range becomes the nearest in it,
  /// and the message names it.
  void show_value(double value);
  /// Reason why a value was refused, or the value that was taken instead.
  void show_message(const QString& message);
  void clear_message();
  /// From now on a value has no more decimals than it needs: "12" and "12.5" of a field with two.
  void drop_needless_decimals();

  QValidator::State validate(QString& text, int& cursor) const override;
  double valueFromText(const QString& text) const override;
  /// With the minus of format_number().
  QString textFromValue(double value) const override;
  /// The base class calls this for a text that it cannot take; the text stays refused.
  void fixup(QString& text) const override;
  void stepBy(int steps) override;

 protected:
  void wheelEvent(QWheelEvent* event) override;

 private:
  /// nullopt if `text` is no number.
  std::optional<double> number_in(const QString& text) const;
  QString bare(const QString& text) const;
  QString shown(double value) const;
  QString refusal(const QString& typed) const;
  void refuse(const QString& typed);
  void report_rounding();

  QWidget* note_;
  QLabel* note_text_;
  QString description_;  // accessible description before the message
  bool has_message_ = false;
  bool needed_decimals_ = false;  // alone
  mutable bool rounded_ = false;  // the text that was read last has more decimals than the field
};

/// Reads one number in any script's digits, with at most one decimal sign (comma, full stop, Arabic) and one sign before it.
/// nullopt for everything else: exponents, group separators.
std::optional<double> read_number(const QString& text);

}  // namespace cusp::ui
