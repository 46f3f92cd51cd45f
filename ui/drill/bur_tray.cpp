#include "ui/drill/bur_tray.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "scenarios/burs/bur_catalogue.h"
#include "ui/modules.h"
#include "ui/text/bur_text.h"
#include "ui/widgets/bur_silhouette.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kHeight = 72, kFoldedHeight = 40, kMargin = 8, kFoldedMargin = 4;  // px at 100 %

/// One bur: its silhouette to scale, number and diameter; folded its number.
class BurButton : public QAbstractButton {
 public:
  BurButton(const Bur& bur, QWidget* parent) : QAbstractButton(parent), bur_(bur) {
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    number_ = QString::fromStdString(bur.name);
    //: Kind of bur and its diameter in mm, as "round 1.0".
    kind_ = BurTray::tr("%1 %2").arg(bur_shape_word(shape_of(bur)), format_number(2 * bur.radius_mm, 1));
    setAccessibleName(BurTray::tr("Bur %1").arg(bur_text(bur)));
    const QString uses = bur_uses_text(bur);
    setToolTip(short_tool_tip(uses.isEmpty() ? accessibleName() : accessibleName() + u'\n' + uses));
  }
  QSize sizeHint() const override {
    const int number = QFontMetrics(font_of(TextRole::body, Weight::bold)).horizontalAdvance(number_);
    if (folded_) return {px(24) + number, px(kFoldedHeight - 2 * kFoldedMargin)};
    return {px(46) + std::max(number, QFontMetrics(font_of(TextRole::caption)).horizontalAdvance(kind_)), px(kHeight - 2 * kMargin)};
  }
  void fold(bool on) {
    folded_ = on;
    updateGeometry();
    update();
  }
  enum class Standing : std::uint8_t { usual, waits, still_in_use };  // while the chosen bur is not in use yet
  void stand(Standing standing) {
    if (std::exchange(standing_, standing) != standing) update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Tokens& t = tokens();
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    p.setLayoutDirection(Qt::LeftToRight);  // a bur with its number is one picture
    const QRectF box = QRectF(rect()).adjusted(1, 1, -1, -1);
    const bool on = isChecked();
    const bool framed = on || standing_ == Standing::still_in_use;
    p.setPen(QPen(framed ? t.accent : t.line, framed ? 2 : 1, standing_ == Standing::waits ? Qt::DashLine : Qt::SolidLine));
    p.setBrush(on ? t.accent_soft : underMouse() ? t.hover : t.surface);
    p.drawRoundedRect(box, px(4), px(4));
    if (hasFocus()) {
      p.setPen(QPen(t.accent, 2));
      p.setBrush(Qt::NoBrush);
      p.drawRoundedRect(box.adjusted(3, 3, -3, -3), px(3), px(3));
    }
    p.setFont(font_of(TextRole::body, Weight::bold));
    if (folded_) {
      p.setPen(t.text);
      p.drawText(rect(), Qt::AlignCenter, number_);
    } else {
      paint_whole(p, t);
    }
  }
  void enterEvent(QEnterEvent*) override { update(); }
  void leaveEvent(QEvent*) override { update(); }

 private:
  void paint_whole(QPainter& p, const Tokens& t) const {
    // The head is true to its shape, as large as its height allows; of neck and shank only the widths are.
    const double x = px(17), length = bur_.radius_mm + bur_head_top_mm(bur_);
    const double scale = std::min({double(px(6.5)), px(26) / length, px(7) / bur_.radius_mm});
    const double tip = px(46), pivot = tip - bur_.radius_mm * scale;
    const double neck = std::max(bur_.neck_radius_mm * scale, 1.0), shank = px(3.2);
    p.setPen(Qt::NoPen);
    p.setBrush(t.text3);
    p.drawRect(QRectF(x - shank, px(8), 2 * shank, px(9)));
    p.drawRect(QRectF(x - neck, px(17), 2 * neck, pivot - px(17)));
    p.setBrush(t.text);
    p.save();
    p.translate(x, pivot);
    p.drawPath(bur_head_path(bur_, scale));
    p.restore();
    p.setPen(t.text);
    p.drawText(QRectF(px(34), px(9), width() - px(36), px(20)), Qt::AlignVCenter | Qt::AlignLeft, number_);
    p.setPen(t.text2);
    p.setFont(font_of(TextRole::caption));
    p.drawText(QRectF(px(34), px(28), width() - px(36), px(18)), Qt::AlignVCenter | Qt::AlignLeft, kind_);
  }

  Bur bur_;
  QString number_, kind_;
  bool folded_ = false;
  Standing standing_ = Standing::usual;
};

}  // namespace

BurTray::BurTray(QWidget* parent) : QFrame(parent) {
  set_kind(this, "bar_bottom");
  whole_ = new QHBoxLayout(this);
  whole_->setSpacing(px(8));
  auto* names = new QVBoxLayout;
  names->setSpacing(0);
  names->addStretch();
  names->addWidget(make_label(tr("Burs"), TextRole::body, Weight::bold));
  keys_ = make_label(tr("[ and ]"), TextRole::caption, Weight::regular, "text2");
  names->addWidget(keys_);
  names->addStretch();
  whole_->addLayout(names);
  whole_->addSpacing(px(20));
  row_ = new QHBoxLayout;
  row_->setSpacing(px(6));
  whole_->addLayout(row_);
  waits_ = make_label(tr("Lift the bur out to change it."), TextRole::caption, Weight::bold, "look");
  waits_->setWordWrap(true);
  waits_->hide();
  whole_->addWidget(waits_, 1);
  whole_->addStretch();
  fold(false);
  group_ = new QButtonGroup(this);
  // However it is set down: a screen reader does it without a click.
  connect(group_, &QButtonGroup::idToggled, this, [this](int index, bool on) {
    if (on) Q_EMIT bur_chosen(index);
  });
}

void BurTray::set_burs(const std::vector<Bur>& burs) {
  for (QAbstractButton* button : group_->buttons()) {
    group_->removeButton(button);
    delete button;
  }
  count_ = static_cast<int>(burs.size());
  for (int i = 0; i < count_; ++i) {
    auto* button = new BurButton(burs[static_cast<std::size_t>(i)], this);
    button->fold(folded_);
    group_->addButton(button, i);
    row_->addWidget(button);
  }
  choose(0);
  waiting_ = -1;
  waits_->hide();
}

void BurTray::fold(bool on) {
  folded_ = on;
  const int edge = px(on ? kFoldedMargin : kMargin);
  setFixedHeight(px(on ? kFoldedHeight : kHeight));
  whole_->setContentsMargins(px(12), edge, px(12), edge);
  keys_->setVisible(!on);
  for (int i = 0; i < row_->count(); ++i) static_cast<BurButton*>(row_->itemAt(i)->widget())->fold(on);
}

void BurTray::choose(int index) {
  const QSignalBlocker quiet(group_);
  if (QAbstractButton* button = group_->button(index)) button->setChecked(true);
}

void BurTray::announce_bur(int index) {
  if (const QAbstractButton* button = group_->button(index)) announce(this, button->accessibleName());
}

void BurTray::show_burs(int in_use, int wanted) {
  if (wanted != chosen()) announce_bur(wanted);  // a button of the device chose it
  choose(wanted);
  const int waiting = wanted == in_use ? -1 : wanted;
  if (std::exchange(waiting_, waiting) == waiting) return;
  for (int i = 0; i < count_; ++i) {
    using Standing = BurButton::Standing;
    const bool used = waiting >= 0 && i == in_use;
    static_cast<BurButton*>(group_->button(i))->stand(i == waiting ? Standing::waits : used ? Standing::still_in_use : Standing::usual);
  }
  waits_->setVisible(waiting >= 0);
  if (waiting >= 0) announce(this, waits_->text());
}

int BurTray::chosen() const { return group_->checkedId(); }

void BurTray::step(int by) {
  if (!isEnabled()) return;  // keys reach it though
  const int to = std::clamp(chosen() + by, 0, std::max(count_ - 1, 0));
  if (to == chosen() || count_ == 0) return;
  choose(to);
  announce_bur(to);
  Q_EMIT bur_chosen(to);
}

}  // namespace cusp::ui
