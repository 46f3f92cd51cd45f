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
  auto* chevron = new QLabel;
  chevron->setPixmap(icon_pixmap(u"chevron_down"_qs, Ink::text2, 16, button->devicePixelRatioF()));
  chevron->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* inside = new QHBoxLayout(button);
  inside->setContentsMargins(0, 0, px(8), 0);
  inside->addStretch();
  inside->addWidget(chevron);
  // theme.qss leaves the sign its place at that side, so that the text stands in the middle of the rest.
  button->setProperty("menu", button->isRightToLeft() ? u"left"_qs : u"right"_qs);
  return button;
}

}  // namespace cusp::ui
