#include "ui/widgets/bar_top.h"

#include <QBoxLayout>
#include <QEvent>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>

#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kBarHeight = 48, kBarSide = 12, kBarGap = 8, kBarRule = 24;  // px at 100 %

/// Elides the text of a label to its width; goes with the label.
class Elider : public QObject {
 public:
  Elider(QLabel* label, const QString& text) : QObject(label), label_(label), text_(text) { label->installEventFilter(this); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Resize) {
      const QString shown = label_->fontMetrics().elidedText(text_, Qt::ElideRight, label_->contentsRect().width());
      label_->setText(shown);
      label_->setToolTip(shown == text_ ? QString() : tool_tip_text(text_));
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  QLabel* label_;
  QString text_;
};

}  // namespace

BarTop make_bar_top() {
  BarTop out{new QFrame, nullptr};
  out.bar->setProperty("kind", QStringLiteral("bar_top"));
  out.bar->setFixedHeight(px(kBarHeight));
  out.row = new QHBoxLayout(out.bar);
  out.row->setContentsMargins(px(kBarSide), 0, px(kBarSide), 0);
  out.row->setSpacing(px(kBarGap));
  return out;
}

QPushButton* add_way_back(const BarTop& top, const QString& name) {
  QPushButton* back = make_button(name, ButtonKind::quiet, QStringLiteral("chevron_left"), QKeySequence(Qt::ALT | Qt::Key_Left));
  top.row->addWidget(back);
  QFrame* rule = make_rule(Qt::Vertical);
  rule->setFixedHeight(px(kBarRule));
  top.row->addWidget(rule);
  return back;
}

QLabel* add_title(const BarTop& top, const QString& title) {
  QLabel* label = make_label(title, TextRole::section, Weight::bold);
  label->setAccessibleName(title);
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // its text asks for no width
  new Elider(label, title);
  top.row->addWidget(label, 1);
  return label;
}

void let_escape_go_back(QPushButton* back) {
  QObject::connect(new QShortcut(QKeySequence(Qt::Key_Escape), back), &QShortcut::activated, back, &QPushButton::click);
}

}  // namespace cusp::ui
