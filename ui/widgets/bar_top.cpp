#include "ui/widgets/bar_top.h"

#include <QBoxLayout>
#include <QFrame>
#include <QPushButton>
#include <QShortcut>

#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kBarHeight = 48, kBarSide = 12, kBarGap = 8, kBarRule = 24;  // px at 100 %

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

void let_escape_go_back(QPushButton* back) {
  QObject::connect(new QShortcut(QKeySequence(Qt::Key_Escape), back), &QShortcut::activated, back, &QPushButton::click);
}

}  // namespace cusp::ui
