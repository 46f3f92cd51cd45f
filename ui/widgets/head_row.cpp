#include "ui/widgets/head_row.h"

#include <QStyle>
#include <QWidget>
#include <algorithm>

namespace cusp::ui {

void HeadRow::addItem(QLayoutItem* item) { items_.emplace_back(item); }

QLayoutItem* HeadRow::itemAt(int index) const {
  return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)].get() : nullptr;
}

QLayoutItem* HeadRow::takeAt(int index) {
  if (index < 0 || index >= count()) return nullptr;
  QLayoutItem* out = items_[static_cast<std::size_t>(index)].release();
  items_.erase(items_.begin() + index);
  return out;
}

void HeadRow::add(Line& line, QLayoutItem* item) const {
  const QSize size = item->sizeHint();
  line.size.rwidth() = std::max(line.size.width(), 0) + size.width() + (line.items.empty() ? 0 : spacing());
  line.size.rheight() = std::max(line.size.height(), size.height());
  line.items.push_back(item);
}

std::vector<HeadRow::Line> HeadRow::lines(int width) const {
  std::vector<Line> out;
  Line whole;
  for (const auto& item : items_)
    if (!item->isEmpty()) add(whole, item.get());
  if (whole.size.width() <= width) return {whole};
  for (std::size_t i = 0; i < whole.items.size(); ++i) {
    const int more = spacing() + whole.items[i]->sizeHint().width();
    const bool alone = kind_ == Kind::titled && i < 2;  // the title is
    if (out.empty() || alone || out.back().size.width() + more > width) out.emplace_back();
    add(out.back(), whole.items[i]);
  }
  return out;
}

int HeadRow::heightForWidth(int width) const {
  int out = 0;
  for (const Line& line : lines(width)) out += line.size.height() + (out > 0 ? spacing() : 0);
  return out;
}

QSize HeadRow::sizeHint() const {
  const auto all = lines(QLAYOUTSIZE_MAX);
  return all.front().size.expandedTo({0, 0});
}

QSize HeadRow::minimumSize() const {
  QSize out(0, 0);
  for (const auto& item : items_)
    if (!item->isEmpty()) out = out.expandedTo(item->sizeHint());
  return out;
}

void HeadRow::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  const Qt::LayoutDirection way = parentWidget() ? parentWidget()->layoutDirection() : Qt::LeftToRight;
  const auto all = lines(rect.width());
  const bool titled = kind_ == Kind::titled;
  int y = titled ? rect.top() : rect.top() + std::max(0, (rect.height() - heightForWidth(rect.width())) / 2);
  for (const Line& line : all) {
    int x = rect.left();
    for (QLayoutItem* item : line.items) {
      // Beside the title the buttons keep to the end.
      if (titled && all.size() == 1 && item != line.items.front() && x < rect.right() && item == line.items[1])
        x = rect.right() + 1 - (line.size.width() - line.items.front()->sizeHint().width() - spacing());
      const QSize size = item->sizeHint();
      const QRect place(x, y + (line.size.height() - size.height()) / 2, std::min(size.width(), rect.width()), size.height());
      item->setGeometry(QStyle::visualRect(way, rect, place));
      x += size.width() + spacing();
    }
    y += line.size.height() + spacing();
  }
}

}  // namespace cusp::ui
