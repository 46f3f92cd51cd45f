#include "ui/drill/homing_card.h"

#include <QVBoxLayout>

#include "ui/device/homing_view.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

namespace {
constexpr int kWidth = 420;  // px at 100 %
}

HomingCard::HomingCard(QWidget* over) : Card(over), homing_(new HomingView(this)) {
  homing_->setFixedWidth(px(kWidth));
  body()->addWidget(homing_);
  hide();
}

void HomingCard::show_falcon(const FalconView& view) {
  homing_->show_falcon(view);
  show();
  adjustSize();
  const QWidget& over = *parentWidget();
  move((over.width() - width()) / 2, (over.height() - height()) / 2);
  raise();
}

}  // namespace cusp::ui
