#include "ui/app/accessible_parts.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QAccessibleWidget>
#include <QButtonGroup>
#include <QCheckBox>
#include <QGraphicsView>
#include <QMainWindow>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>

namespace cusp::ui {
namespace {

class PressedButton final : public QAccessibleWidget {
 public:
  explicit PressedButton(QAbstractButton* button) : QAccessibleWidget(button, QAccessible::Button) {}

  QAccessible::Role role() const override {
    if (menu()) return QAccessible::ButtonMenu;
    if (!button().isCheckable()) return QAccessible::Button;
    const bool one_of = button().autoExclusive() || (button().group() && button().group()->exclusive());
    return one_of ? QAccessible::RadioButton : QAccessible::CheckBox;
  }
  QAccessible::State state() const override {
    QAccessible::State state = QAccessibleWidget::state();
    state.checkable = button().isCheckable();
    state.checked = button().isChecked();
    state.pressed = button().isDown();
    state.hasPopup = menu() != nullptr;
    const auto* push = qobject_cast<QPushButton*>(&button());
    state.defaultButton = push && push->isDefault();
    return state;
  }
  QString text(QAccessible::Text kind) const override {
    if (kind == QAccessible::Accelerator) return button().shortcut().toString(QKeySequence::NativeText);
    const QString name = QAccessibleWidget::text(kind);
    return name.isEmpty() && kind == QAccessible::Name ? button().text() : name;
  }
  QStringList actionNames() const override {
    QStringList names = QAccessibleWidget::actionNames();
    if (button().isEnabled()) names.prepend(act());
    return names;
  }
  void doAction(const QString& name) override {
    if (name != act()) {
      QAccessibleWidget::doAction(name);
    } else if (button().isEnabled()) {
      button().animateClick();  // after the answer is given: a menu waits for its own
    }
  }
  QStringList keyBindingsForAction(const QString& name) const override {
    if (name != act() || button().shortcut().isEmpty()) return {};
    return {button().shortcut().toString()};
  }

 private:
  QAbstractButton& button() const { return *static_cast<QAbstractButton*>(widget()); }
  QMenu* menu() const {
    if (const auto* push = qobject_cast<QPushButton*>(&button())) return push->menu();
    const auto* tool = qobject_cast<QToolButton*>(&button());
    return tool ? tool->menu() : nullptr;
  }
  QString act() const {
    return menu() ? showMenuAction() : button().isCheckable() ? toggleAction() : pressAction();
  }
};

QAccessibleInterface* make_part(const QString&, QObject* object) {
  if (auto* window = qobject_cast<QMainWindow*>(object)) return new QAccessibleWidget(window, QAccessible::Window);
  if (qobject_cast<QScrollArea*>(object) || qobject_cast<QGraphicsView*>(object)) {
    return new QAccessibleWidget(static_cast<QWidget*>(object), QAccessible::Client);
  }
  // Own buttons too, of which Qt knows no more than that they are widgets. A check box is as good as Qt's own makes it.
  if (auto* button = qobject_cast<QAbstractButton*>(object); button && !qobject_cast<QCheckBox*>(object)) {
    return new PressedButton(button);
  }
  return nullptr;
}

}  // namespace

void install_accessible_parts() { QAccessible::installFactory(make_part); }

}  // namespace cusp::ui
