#include "ui/app/accessible_parts.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QGraphicsView>
#include <QMainWindow>
#include <QScrollArea>

namespace cusp {
namespace {

QAccessibleInterface* make_part(const QString&, QObject* object) {
  if (auto* window = qobject_cast<QMainWindow*>(object)) return new QAccessibleWidget(window, QAccessible::Window);
  if (qobject_cast<QScrollArea*>(object) || qobject_cast<QGraphicsView*>(object)) {
    return new QAccessibleWidget(static_cast<QWidget*>(object), QAccessible::Client);
  }
  return nullptr;
}

}  // namespace

void install_accessible_parts() { QAccessible::installFactory(make_part); }

}  // namespace cusp
