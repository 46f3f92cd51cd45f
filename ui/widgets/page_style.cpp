#include "ui/widgets/page_style.h"

#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>
#include <QSlider>
#include <QTabBar>

namespace cusp::ui {
namespace {

/// Whether `widget` stands on a page that is higher than its scroll area.
bool on_a_page_that_scrolls(const QWidget& widget) {
  for (const QWidget* above = widget.parentWidget(); above != nullptr; above = above->parentWidget()) {
    const auto* area = qobject_cast<const QAbstractScrollArea*>(above);
    if (area != nullptr && area->verticalScrollBar()->minimum() < area->verticalScrollBar()->maximum()) return true;
    if (above->isWindow()) break;
  }
  return false;
}

}  // namespace

void PageStyle::polish(QWidget* widget) {
  CuspStyle::polish(widget);
  const bool takes_wheel = qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QComboBox*>(widget) ||
                           qobject_cast<QSlider*>(widget) || qobject_cast<QTabBar*>(widget);
  if (!takes_wheel) return;
  if (widget->focusPolicy() == Qt::WheelFocus) widget->setFocusPolicy(Qt::StrongFocus);
  widget->installEventFilter(this);
}

bool PageStyle::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Wheel) return CuspStyle::eventFilter(watched, event);
  const auto* field = static_cast<QWidget*>(watched);
  if (field->hasFocus() && !on_a_page_that_scrolls(*field)) return CuspStyle::eventFilter(watched, event);
  event->ignore();  // the parent scrolls
  return true;
}

}  // namespace cusp::ui
