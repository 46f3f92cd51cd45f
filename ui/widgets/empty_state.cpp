#include "ui/widgets/empty_state.h"

#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/widgets/parts.h"

namespace cusp::ui {

EmptyState::EmptyState(const QString& icon_name, const QString& title, const QString& why, const QString& act, Ink ink,
                       QWidget* parent)
    : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(16), px(24), px(16), px(24));
  column->setSpacing(px(8));
  column->addStretch();
  auto* sign = new QLabel;
  sign->setPixmap(icon_pixmap(icon_name, ink, 28, devicePixelRatioF()));
  sign->setAlignment(Qt::AlignCenter);
  column->addWidget(sign);
  QLabel* head = make_label(title, TextRole::section, Weight::bold);
  head->setAlignment(Qt::AlignCenter);
  head->setWordWrap(true);
  column->addWidget(head);
  QLabel* text = make_label(why, TextRole::body, Weight::regular, "text2");
  text->setAlignment(Qt::AlignCenter);
  text->setWordWrap(true);
  column->addWidget(text);
  if (!act.isEmpty()) {
    button_ = make_button(act);
    column->addSpacing(px(8));
    column->addWidget(button_, 0, Qt::AlignHCenter);
    connect(button_, &QPushButton::clicked, this, &EmptyState::acted);
  }
  column->addStretch();
}

}  // namespace cusp::ui
