// Where everything stands on the stage.

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "ui/drill/cut_slider.h"
#include "ui/drill/drill_stage.h"
#include "ui/view/compass.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kScarceWidth = 560, kScarceHeight = 356;  // px at 100 %

}  // namespace

bool DrillStage::is_scarce() const { return width() < px(kScarceWidth) || height() < px(kScarceHeight); }

void DrillStage::place_all() {
  const bool scarce = is_scarce();
  const int gap = px(scarce ? kStageGap / 2 : kStageGap), w = width(), h = height();
  view_->setGeometry(rect());
  legend_->setVisible(!scarce && target_->isChecked() && look_ && !look_->empty());
  legend_->adjustSize();
  legend_->move(gap, h - legend_->height() - px(16));
  place_tools(gap);
  place_gauges(gap);
  place_compass(gap);
  place_cut(gap);
  place_mirror_hint(gap);
  place_coach(gap);
  stop_card_->fit({std::min(px(420), w - 4 * gap), h - 2 * gap});
  stop_card_->move((w - stop_card_->width()) / 2, (h - stop_card_->height()) / 2);
  if (centre_ != nullptr) {
    centre_->move((w - centre_->width()) / 2, (h - centre_->height()) / 2);
    centre_->raise();
  }
}

/// Where the row is too long its keys stand in the tooltips alone, then the handpiece's name, and at last all names.
void DrillStage::place_tools(int gap) {
  const int wheel = is_scarce() && !wanted_push_->isHidden() ? wanted_push_->width() + gap : 0;
  const int room = width() - 2 * gap - wheel;
  for (const auto& [button, cap] : caps_) button->setText(u' ' + button->accessibleName());  // as make_button: the style leaves no space
  int long_row = tools_->sizeHint().width();
  for (const auto& [button, cap] : caps_)
    if (cap->isHidden() && !button->isHidden()) long_row += cap->sizeHint().width() + px(2);
  for (const auto& [button, cap] : caps_) cap->setVisible(!button->isHidden() && long_row <= room);
  if (tools_->sizeHint().width() > room) handpiece_->setText({});
  if (tools_->sizeHint().width() > room)
    for (const auto& [button, cap] : caps_) button->setText({});
  tools_->adjustSize();
  tools_->move(wheel > 0 ? gap : (width() - tools_->width()) / 2, gap);
}

/// Depth with its button at the left; at the right push, with what the wheel asks for.
void DrillStage::place_gauges(int gap) {
  const int w = width(), h = height();
  const bool scarce = is_scarce();
  const QSize depth = depth_->sizeHint(), push = push_->sizeHint();
  const int highest = tools_->geometry().bottom() + gap;
  const int top = std::max(highest, (h - depth.height()) / 2 + px(20));
  const int held = hold_->isHidden() ? 0 : hold_->sizeHint().height() + px(6);
  const int below_depth = held + (scarce ? gap : px(60)), below_push = scarce ? gap : px(110);
  depth_->setGeometry(gap, top, depth.width(), std::min(depth.height(), h - top - below_depth));
  push_->setGeometry(w - push.width() - gap, top, push.width(), std::min(push.height(), h - top - below_push));
  hold_->setFixedWidth(depth.width());
  hold_->move(gap, depth_->geometry().bottom() + px(6));
  if (scarce) {
    wanted_push_->move(w - gap - wanted_push_->width(), tools_->geometry().center().y() - wanted_push_->height() / 2);
  } else {
    wanted_push_->move(w - gap - (push.width() + wanted_push_->width()) / 2, push_->geometry().bottom() + px(6));
  }
}

/// Below the push; where that needs the whole height, beside it, above the coach.
void DrillStage::place_compass(int gap) {
  if (is_scarce()) {
    compass_->move(push_->x() - gap - compass_->width(), push_->y());
  } else {
    compass_->move(width() - compass_->width() - px(18), height() - compass_->height() - px(14));
  }
}

/// Below the tools, between what stands at the left and at the right.
void DrillStage::place_cut(int gap) {
  const int left = depth_->geometry().right() + gap;
  const int right = (is_scarce() && !compass_->isHidden() ? compass_->x() : push_->x()) - gap;
  cut_->fit(right - left);
  cut_->move(left + (right - left - cut_->width()) / 2, tools_->geometry().bottom() + gap);
}

/// Below the tools; where that is too narrow the tooltip says it alone.
void DrillStage::place_mirror_hint(int gap) {
  mirror_hint_->adjustSize();
  const int left = depth_->geometry().right() + gap, right = push_->x() - gap;
  mirror_hint_->setVisible(mirror_->isChecked() && mirror_hint_->width() <= right - left && !is_scarce());
  mirror_hint_->move(left + (right - left - mirror_hint_->width()) / 2, tools_->geometry().bottom() + gap);
}

void DrillStage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place_all();
}

}  // namespace cusp::ui
