#include "ui/drill/homing_card.h"

#include <QVBoxLayout>
#include <algorithm>

#include "ui/device/homing_view.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

namespace {
constexpr int kWidth = 420, kBeside = 64;  // px at 100 %
}

HomingCard::HomingCard(QWidget* over) : Card(over), homing_(new HomingView(this)) {
  body()->addWidget(homing_);
  hide();
}

bool HomingCard::show_falcon(const FalconView& view) {
  if (view.session.phase == falcon::Phase::ready) {
    hide();
    return false;
  }
  const QWidget& over = *parentWidget();
  homing_->setFixedWidth(std::min(px(kWidth), over.width() - px(kBeside)));
  homing_->show_falcon(view);
  show();
  adjustSize();
  move((over.width() - width()) / 2, (over.height() - height()) / 2);
  raise();
  return true;
}

}  // namespace cusp::ui
