#include "ui/app/quick_open.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>

#include "ui/widgets/parts.h"

namespace cusp::ui {

QuickOpen::QuickOpen(QVector<Destination> places, QWidget* parent) : QDialog(parent), places_(std::move(places)) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Go to"));
  setMinimumWidth(px(480));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(12), px(12), px(12), px(12));
  line_ = new QLineEdit;
  line_->setPlaceholderText(tr("Page or exercise"));
  line_->setAccessibleName(tr("Page or exercise"));
  line_->addAction(icon(u"search"_qs, Ink::text2), QLineEdit::LeadingPosition);
  line_->installEventFilter(this);
  list_ = new QListWidget;
  list_->setAccessibleName(tr("Where to"));
  column->addWidget(line_);
  column->addWidget(list_);
  connect(line_, &QLineEdit::textChanged, this, &QuickOpen::narrow);
  connect(line_, &QLineEdit::returnPressed, this, &QuickOpen::open_chosen);
  connect(list_, &QListWidget::itemActivated, this, &QuickOpen::open_chosen);
  connect(list_, &QListWidget::itemClicked, this, &QuickOpen::open_chosen);
  narrow({});
  // The keyboard stays in the line, so that a screen reader hears of no item.
  connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item != nullptr) announce(line_, item->text());
  });
}

void QuickOpen::narrow(const QString& text) {
  list_->clear();
  for (int i = 0; i < places_.size(); ++i) {
    if (!places_[i].name.contains(text.trimmed(), Qt::CaseInsensitive)) continue;
    auto* item = new QListWidgetItem(icon(places_[i].icon, Ink::text2), tr("%1, %2").arg(places_[i].name, places_[i].kind), list_);
    item->setData(Qt::UserRole, i);
  }
  list_->setCurrentRow(0);
}

void QuickOpen::open_chosen() {
  // Where a single click activates, the list emits itemClicked and itemActivated.
  if (!list_->currentItem() || !isVisible()) return;
  const auto attempt = places_[list_->currentItem()->data(Qt::UserRole).toInt()].attempt;
  accept();
  attempt();
}

bool QuickOpen::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Down || key == Qt::Key_Up) {
      QCoreApplication::sendEvent(list_, event);
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace cusp::ui
