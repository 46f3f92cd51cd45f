#include "ui/editor/form_parts.h"

#include <QBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>

#include "ui/editor/editor_model.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {

NumberBox::NumberBox(EditorModel& model, const QString& name, const QString& unit, double least, double most,
                     double step, int decimals, std::function<bool(double)> take) {
  setDecimals(decimals);
  setRange(least, most);
  setSingleStep(step);
  setAlignment(Qt::AlignRight);
  setFixedWidth(px(112));
  setAccessibleName(name);
  if (!unit.isEmpty()) setSuffix(QChar(0x00A0) + unit_text(unit));
  connect(this, &QDoubleSpinBox::valueChanged, this, [this, take](double value) {
    if (take(value)) {
      shown_ = this->value();  // take() may have rounded it
      return;
    }
    const QString wanted = isolate(textFromValue(value) + suffix());
    show_value(shown_);
    show_message(tr("%1 does not fit the rest of the exercise. It stays at %2.")
            .arg(wanted, isolate(textFromValue(shown_) + suffix())));
  });
  connect(this, &QDoubleSpinBox::editingFinished, this, [&model] { model.end_gesture(); });
}

void NumberBox::show_value(double value) {
  shown_ = value;
  NumberField::show_value(value);
}

bool NumberBox::event(QEvent* event) {
  // Ctrl+Z undoes an edit of the exercise, not a digit of this box.
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo) ||
        key->keyCombination() == (Qt::CTRL | Qt::Key_Y)) {
      event->ignore();
      return true;
    }
  }
  return NumberField::event(event);
}

QLabel* add_row(QBoxLayout* column, const QString& text, QWidget* field) {
  auto* row = new QHBoxLayout;
  row->setSpacing(px(8));
  QLabel* label = make_label(text);
  label->setWordWrap(true);
  label->setBuddy(field);
  row->addWidget(label, 1);
  row->addWidget(field);
  column->addLayout(row);
  if (auto* number = qobject_cast<NumberField*>(field)) column->addWidget(number->note());
  return label;
}

QPushButton* make_wrapping_link(const QString& text) {
  auto* link = new QPushButton;
  set_kind(link, "link");
  link->setCheckable(true);
  link->setAccessibleName(text);
  // Qt's button draws one line; the label in it wraps, and the layout gives the button the label's height.
  auto* inside = new QVBoxLayout(link);
  inside->setContentsMargins(0, px(4), 0, px(4));
  QLabel* label = make_label(text, TextRole::body, Weight::regular, "accent");
  label->setWordWrap(true);
  label->setAttribute(Qt::WA_TransparentForMouseEvents);
  inside->addWidget(label);
  link->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
  return link;
}

namespace {

void collect_stops(const QLayout& layout, std::vector<QWidget*>& out) {
  for (int i = 0; i < layout.count(); ++i) {
    QLayoutItem* item = layout.itemAt(i);
    QWidget* widget = item->widget();
    if (widget != nullptr && (widget->focusPolicy() & Qt::TabFocus)) out.push_back(widget);
    const QLayout* inside = widget != nullptr ? widget->layout() : item->layout();
    if (inside != nullptr) collect_stops(*inside, out);
  }
}

}  // namespace

void tab_by_layout(QWidget& form) {
  std::vector<QWidget*> stops;
  collect_stops(*form.layout(), stops);
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) QWidget::setTabOrder(stops[i], stops[i + 1]);
}

void add_section(QBoxLayout* column, const QString& title, QLabel** aside) {
  auto* row = new QHBoxLayout;
  row->addWidget(make_label(title, TextRole::section, Weight::bold), 1);
  if (aside) {
    *aside = make_label({}, TextRole::caption, Weight::regular, "text2");
    row->addWidget(*aside);
  }
  column->addLayout(row);
}

}  // namespace cusp::ui
