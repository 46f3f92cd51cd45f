// The coach's message: its text, sign and place, and the tag at the bur.

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>
#include <cmath>

#include "ui/drill/drill_stage.h"
#include "ui/drill/hand_ghost.h"
#include "ui/widgets/format.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

void DrillStage::make_coach() {
  coach_card_ = make_card(this);
  auto* row = new QHBoxLayout(coach_card_);  // place_coach() sets its margins
  coach_sign_ = new QLabel(coach_card_);
  coach_sign_->setObjectName(QStringLiteral("coach_sign"));
  coach_sign_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  row->addWidget(coach_sign_);
  coach_ = make_label({}, TextRole::live, Weight::bold);
  coach_->setAccessibleName(tr("Coach"));
  row->addWidget(coach_, 1);
  sign_coach(CoachTone::good);
  coach_card_->hide();
  bur_tag_ = make_label({}, TextRole::body, Weight::bold);
  bur_tag_->setParent(this);
  set_kind(bur_tag_, "pin");
  bur_tag_->setAutoFillBackground(true);
  bur_tag_->setAttribute(Qt::WA_TransparentForMouseEvents);
  bur_tag_->hide();
}

void DrillStage::follow_bur(Vec3 pivot_mm, const std::optional<Vec3>& hand_mm) {
  hand_ghost_->follow(hand_mm, {.at_mm = pivot_mm, .radius_mm = bur_radius_mm()});
  const CoachTone tone = tone_of(shown_, leeway_);
  const auto at = tone == CoachTone::good ? std::nullopt : view_->project(pivot_mm);
  bur_tag_->setVisible(at.has_value());
  if (!at) return;
  // Beside the bur, where neither handpiece nor cavity lies under it.
  const QPoint place = at->toPoint() + QPoint(px(28), -bur_tag_->height() / 2);
  bur_tag_->move(std::clamp(place.x(), 0, std::max(0, width() - bur_tag_->width())),
                 std::clamp(place.y(), 0, std::max(0, height() - bur_tag_->height())));
}

QString DrillStage::coach_text(const CoachLine& line) const {
  const QString mm = format({line.mm, {}, QStringLiteral("mm"), 1});
  switch (line.what) {
    case Coach::begin:
      return by_mouse_ ? tr("Hold the left button on the target to drill")
                       : tr("Touch the target and hold the button to drill");
    case Coach::pulp_open: return tr("The pulp is open");
    case Coach::over_pulp: return tr("Only %1 left over the pulp").arg(mm);
    case Coach::too_deep: return tr("%1 too deep here").arg(mm);
    case Coach::outside: return tr("Back inside the line: %1 outside").arg(mm);
    case Coach::deeper: return tr("%1 deeper").arg(mm);
    case Coach::nearly: return tr("Slowly: %1 to the floor").arg(mm);
    case Coach::sideways: return tr("Deep enough, move sideways");
    case Coach::finish: return tr("Nearly all is out: smooth it, then finish");
    case Coach::carry_on: return tr("Continue where the target remains");
    case Coach::held_cut: return tr("Release button or pedal, then press again");
    case Coach::quiet: return {};
  }
  return {};
}

void DrillStage::sign_coach(CoachTone tone) {
  const QString name = tone == CoachTone::bad    ? QStringLiteral("cross")
                       : tone == CoachTone::look ? QStringLiteral("warning")
                                                 : QStringLiteral("chevron_right");
  const Ink ink = tone == CoachTone::bad ? Ink::bad : tone == CoachTone::look ? Ink::look : Ink::good;
  coach_sign_->setPixmap(icon_pixmap(name, ink, 18, devicePixelRatioF()));
  set_ink(coach_, tone == CoachTone::bad ? "bad" : tone == CoachTone::look ? "look" : "text");
}

void DrillStage::show_coach(CoachLine line) {
  line.mm = std::round(line.mm * 10) / 10;
  if (line == shown_) return;
  shown_ = line;
  coach_->setText(coach_text(line));
  const CoachTone tone = tone_of(line, leeway_);
  sign_coach(tone);
  bur_tag_->setText(line.what == Coach::pulp_open ? tr("Pulp") : format({line.mm, {}, QStringLiteral("mm"), 1}));
  set_ink(bur_tag_, tone == CoachTone::bad ? "bad" : "look");
  bur_tag_->adjustSize();
  coach_card_->setVisible(line.what != Coach::quiet);
  place_all();
  if (!worth_saying(spoken_, line)) return;
  spoken_ = line;
  if (line.what != Coach::quiet) announce(coach_, coach_->text());
}

/// In the middle, in one line; where that is too narrow, in smaller letters between what stands at the left and at the right.
void DrillStage::place_coach(int gap) {
  const int w = width(), h = height(), below = px(is_scarce() ? kStageGap / 2 : 16);
  const int gauge = hold_->isHidden() ? gap : hold_->geometry().right() + gap;
  const int left = legend_->isHidden() ? gauge : legend_->geometry().right() + gap;
  const int wheel = wanted_push_->isHidden() ? w : wanted_push_->x();
  const int right = (is_scarce() ? push_->x() : std::min(compass_->isHidden() ? w : compass_->x(), wheel)) - gap;
  const int beside = std::max(left, w - right);
  const int side = px(is_scarce() ? 8 : 16), between = px(is_scarce() ? 6 : 12);
  coach_card_->layout()->setContentsMargins(side, px(8), side, px(8));
  coach_card_->layout()->setSpacing(between);
  const auto fit = [this](TextRole role) {
    coach_->setFont(font_of(role, Weight::bold));
    coach_->setMinimumWidth(0);
    coach_->setWordWrap(false);
    coach_card_->adjustSize();
  };
  int x = beside, most = w - 2 * beside;
  fit(TextRole::live);
  if (coach_card_->width() > most) {
    x = left;
    most = right - left;
    fit(is_scarce() ? TextRole::body : TextRole::section);
  }
  if (coach_card_->width() > most) {
    coach_->setMinimumWidth(most - 2 * side - coach_sign_->sizeHint().width() - between - 2 * coach_card_->frameWidth());
    coach_->setWordWrap(true);
    coach_card_->resize(most, coach_card_->heightForWidth(most));
  }
  coach_card_->move(x + (most - coach_card_->width()) / 2, h - coach_card_->height() - below);
}

}  // namespace cusp::ui
