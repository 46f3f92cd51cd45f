#include "ui/device/panel_card.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "ui/widgets/chip.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

PanelCard panel_card(QWidget& panel, const QString& title) {
  auto* outer = new QVBoxLayout(&panel);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* card = qobject_cast<Card*>(panel.parentWidget());
  PanelCard out{outer, new Chip};
  if (card == nullptr || card->head() == nullptr) {
    card = new Card(title);
    outer->addWidget(card);
    out.column = card->body();
  }
  out.column->setSpacing(px(12));
  card->head()->addWidget(out.state);
  return out;
}

QVBoxLayout* make_column(QWidget* part, int gap_px) {
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(gap_px));
  return column;
}

}  // namespace cusp::ui
