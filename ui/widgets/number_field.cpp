#include "ui/widgets/number_field.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolTip>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "ui/widgets/format.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr QChar kArabicDecimal(0x066B), kTrueMinus(0x2212);

bool is_direction_mark(QChar c) {
  const char16_t u = c.unicode();
  return u == 0x200E || u == 0x200F || u == 0x061C || (u >= 0x2066 && u <= 0x2069);
}

}  // namespace

std::optional<double> read_number(const QString& text) {
  QString plain;
  int decimal_signs = 0, digits = 0;
  for (const QChar c : text.trimmed()) {
    if (is_direction_mark(c)) continue;
    if (c.isDigit()) {
      plain += QChar(u'0' + c.digitValue());
      ++digits;
    } else if (c == u',' || c == u'.' || c == kArabicDecimal) {
      plain += u'.';
      ++decimal_signs;
    } else if ((c == u'-' || c == kTrueMinus || c == u'+') && plain.isEmpty()) {
      plain += c == u'+' ? u'+' : u'-';
    } else {
      return std::nullopt;
    }
  }
  if (digits == 0 || decimal_signs > 1) return std::nullopt;
  bool ok = false;
  const double value = QLocale::c().toDouble(plain, &ok);
  return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

NumberField::NumberField(QWidget* parent) : QDoubleSpinBox(parent), note_(new QWidget(this)) {
  setLocale(QLocale());  // the language may be another than when the window was made
  // A half-typed number must not reach the model; arrows and wheel report each step.
  setKeyboardTracking(false);
  setFocusPolicy(Qt::StrongFocus);
  auto* line = new QHBoxLayout(note_);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(px(4));
  auto* sign = new QLabel;
  sign->setPixmap(icon_pixmap(QStringLiteral("warning"), Ink::look, 16, devicePixelRatioF()));
  note_text_ = make_label({}, TextRole::caption, Weight::regular, "look");
  note_text_->setWordWrap(true);
  line->addWidget(sign, 0, Qt::AlignTop);
  line->addWidget(note_text_, 1);
  note_->hide();
  connect(lineEdit(), &QLineEdit::textEdited, this, [this] { clear_message(); });
  connect(this, &QDoubleSpinBox::valueChanged, this, [this] {
    clear_message();
    report_rounding();
  });
  connect(this, &QDoubleSpinBox::editingFinished, this, [this] { report_rounding(); });  // to the value before, perhaps
}

QString NumberField::message() const { return has_message_ ? note_text_->text() : QString(); }

void NumberField::show_message(const QString& text) {
  if (message() == text) return;
  if (!std::exchange(has_message_, true)) description_ = accessibleDescription();
  note_text_->setText(text);
  if (note_->parentWidget() != this) {
    note_->show();
  } else {
    QToolTip::showText(mapToGlobal(rect().bottomLeft()), text, this);
  }
  set_kind(this, "refused");
  announce(this, text);
}

void NumberField::clear_message() {
  if (!std::exchange(has_message_, false)) return;
  note_->hide();
  set_kind(this, "");
  setAccessibleDescription(description_);
}

QString NumberField::bare(const QString& text) const {
  QString out = text;
  if (!prefix().isEmpty() && out.startsWith(prefix())) out.remove(0, prefix().size());
  out = out.trimmed();
  const QString unit = suffix().trimmed();
  // "1,5 mm" that is pasted stands before the field's own unit.
  while (!unit.isEmpty() && out.endsWith(unit)) out = out.chopped(unit.size()).trimmed();
  return out;
}

std::optional<double> NumberField::number_in(const QString& text) const {
  if (!specialValueText().isEmpty() && text.trimmed() == specialValueText()) return minimum();
  return read_number(bare(text));
}

QString NumberField::shown(double value) const { return isolate(textFromValue(value) + suffix()); }

QValidator::State NumberField::validate(QString& text, int&) const {
  const auto number = number_in(text);
  // Intermediate: the field keeps every typed character and refuses the text when it is left.
  if (!number) return QValidator::Intermediate;
  // Rounding: 0.30000000000000004 is 0.3.
  const double slack = 1e-6 * std::pow(10.0, -decimals());
  return *number >= minimum() - slack && *number <= maximum() + slack ? QValidator::Acceptable : QValidator::Intermediate;
}

double NumberField::valueFromText(const QString& text) const {
  const double step = std::pow(10.0, decimals());
  const double typed = number_in(text).value_or(value());
  const double taken = std::round(typed * step) / step;
  rounded_ = std::abs(taken - typed) * step > 1e-6;
  return taken;
}

QString NumberField::textFromValue(double value) const {
  QString out = QDoubleSpinBox::textFromValue(value);
  if (const QString point = locale().decimalPoint(), zero = locale().zeroDigit(); needed_decimals_ && out.contains(point)) {
    while (out.endsWith(zero)) out.chop(zero.size());
    if (out.endsWith(point)) out.chop(point.size());
  }
  if (out.startsWith(u'-')) out[0] = kTrueMinus;
  return out;
}

void NumberField::fixup(QString& text) const {
  // QAbstractSpinBox calls this const function when it drops the text for the last value.
  const_cast<NumberField*>(this)->refuse(bare(text));
}

QString NumberField::refusal(const QString& typed) const {
  const QString range = tr("%1 to %2").arg(shown(minimum()), shown(maximum()));
  const QString stays = shown(value());
  if (typed.isEmpty()) return tr("A number is needed here: %1. It stays at %2.").arg(range, stays);
  if (!read_number(typed)) return tr("“%1” is no number. Possible: %2. It stays at %3.").arg(isolate(typed), range, stays);
  return tr("%1 is outside %2. It stays at %3.").arg(isolate(typed + suffix()), range, stays);
}

void NumberField::drop_needless_decimals() {
  needed_decimals_ = true;
  const QSignalBlocker quiet(this);
  setValue(value());  // writes the text anew
}

void NumberField::refuse(const QString& typed) { show_message(refusal(typed)); }

void NumberField::report_rounding() {
  if (std::exchange(rounded_, false)) show_message(tr("Rounded to %1.").arg(shown(value())));
}

void NumberField::show_value(double value) {
  const double before = this->value();
  // The same value leaves a half-typed number alone.
  if (textFromValue(value) != textFromValue(before)) {
    const QSignalBlocker quiet(this);
    setValue(value);
  }
  const double step = std::pow(10.0, -decimals());
  if (value < minimum() - step || value > maximum() + step) {
    show_message(tr("%1 stands in the exercise, outside %2.")
            .arg(shown(value), tr("%1 to %2").arg(shown(minimum()), shown(maximum()))));
  } else if (this->value() != before) {
    clear_message();
  }
}

void NumberField::stepBy(int steps) {
  const double before = value();
  clear_message();
  QDoubleSpinBox::stepBy(steps);  // from what was typed; where that is refused there is no step
  if (value() != before) clear_message();
}

void NumberField::wheelEvent(QWheelEvent* event) {
  // A page that is scrolled under the pointer changes no number.
  if (!hasFocus()) return event->ignore();
  QDoubleSpinBox::wheelEvent(event);
}

}  // namespace cusp::ui
