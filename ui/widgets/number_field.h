/// A number that is typed. In every language a comma and a full stop are decimal signs; group separators are no part of a
/// number. What cannot be taken leaves the value as it is, and a note at the field gives the reason and the range.
/// Thread: GUI.
#pragma once

#include <QDoubleSpinBox>
#include <optional>

class QLabel;

namespace cusp::ui {

class NumberField : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit NumberField(QWidget* parent = nullptr);

  /// Hidden until there is something to say. Whoever lays out the field puts it below; labelled() and add_row() do. A note
  /// that was put nowhere is a tool tip.
  QWidget* note() const { return note_; }
  /// The note's sentence; empty while there is none.
  QString said() const;
  /// Shows a value without a signal. The note goes when the value is another one. A value outside the range is shown as
  /// the nearest in it, and the note names it.
  void show_value(double value);
  /// Puts a sentence into the note: why a value was not taken, or which was taken instead.
  void show_note(const QString& sentence);
  void clear_note();

  QValidator::State validate(QString& text, int& cursor) const override;
  double valueFromText(const QString& text) const override;
  /// Called by the base class when the typed text is none that can be taken: it stays refused.
  void fixup(QString& text) const override;
  void stepBy(int steps) override;

 protected:
  void wheelEvent(QWheelEvent* event) override;

 private:
  /// The number that stands in `text`; nullopt where it is none.
  std::optional<double> number_in(const QString& text) const;
  QString bare(const QString& text) const;
  QString shown(double value) const;
  QString refusal(const QString& typed) const;
  void refuse(const QString& typed);
  void show_rounding();

  QWidget* note_;
  QLabel* note_text_;
  QString description_;  // what the screen reader was told before the note
  bool saying_ = false;
  mutable bool rounded_ = false;  // of the text that was read last: it has more decimals than the field
};

/// One number with at most one decimal sign, comma, full stop or the Arabic one, in any script's digits, with a sign before
/// it; nullopt for everything else: exponents, group separators, two signs.
std::optional<double> read_number(const QString& text);

}  // namespace cusp::ui
