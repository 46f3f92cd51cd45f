#include "ui/widgets/menu_button.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>

#include "ui/widgets/icon.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

QPushButton* put_menu(QPushButton* button, QMenu* menu) {
  button->setMenu(menu);
  // Qt's button puts its text in the middle, whatever stands beside it: labels in a row take sign, text and chevron instead.
  auto* inside = new QHBoxLayout(button);
  inside->setContentsMargins(px(12), 0, px(8), 0);
  inside->setSpacing(px(6));
  const auto add = [inside](QLabel* label) {
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    inside->addWidget(label);
    return label;
  };
  const QSize size(px(18), px(18));
  if (!button->icon().isNull()) add(new QLabel)->setPixmap(button->icon().pixmap(size, button->devicePixelRatioF()));
  add(make_label(button->text().trimmed()));
  add(new QLabel)->setPixmap(icon_pixmap(u"chevron_down"_qs, Ink::text2, 16, button->devicePixelRatioF()));
  const QKeySequence key = button->shortcut();  // a new text takes the shortcut away
  button->setIcon({});
  button->setText({});
  button->setShortcut(key);
  button->setMinimumWidth(inside->sizeHint().width());
  return button;
}

}  // namespace cusp::ui
