#include "ui/widgets/table.h"

#include <QAbstractItemModel>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>

#include "ui/widgets/gauge.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kLeastName = 140;  // px at 100 %: some 15 letters
constexpr int kLine = 16;        // px at 100 %: of two in a cell

}  // namespace

QStringList cell_lines(const QString& text, const QFontMetrics& metrics, int width, Qt::TextElideMode elide) {
  if (metrics.horizontalAdvance(text) <= width) return {text};
  qsizetype end = -1;
  for (qsizetype at = text.indexOf(u' '); at >= 0 && metrics.horizontalAdvance(text.left(at)) <= width; at = text.indexOf(u' ', at + 1)) end = at;
  if (end <= 0) return {metrics.elidedText(text, elide, width)};
  return {text.left(end), metrics.elidedText(text.mid(end + 1), elide, width)};
}

namespace {

/// The text of a cell, and the second one beside it.
void draw_text(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index, const QRect& cell) {
  const Tokens& t = tokens();
  const auto* view = qobject_cast<const QTableView*>(option.widget);
  const bool rtl = option.direction == Qt::RightToLeft;
  const QString text = index.data(Qt::DisplayRole).toString();
  Qt::Alignment alignment(index.data(Qt::TextAlignmentRole).toInt());
  if (!(alignment & Qt::AlignHorizontal_Mask)) alignment |= Qt::AlignLeading;
  const bool right = alignment & Qt::AlignRight || alignment & Qt::AlignTrailing;
  const Weight weight = index.data(BoldRole).toBool() ? Weight::bold : Weight::regular;
  const QFont font = font_of(TextRole::body, weight);
  const QColor ink = index.data(QuietRole).toBool() ? t.text3 : t.text;
  const QString second = index.data(SecondRole).toString();
  const QFontMetrics metrics(font), plain(font_of(TextRole::body));
  const int gap = second.isEmpty() ? 0 : px(4);
  const int second_width = second.isEmpty() ? 0 : plain.horizontalAdvance(second);
  const int room = std::max(0, cell.width() - second_width - gap);
  if (view && view->wordWrap() && second.isEmpty() && metrics.horizontalAdvance(text) > room) {
    painter.setFont(font);
    painter.setPen(ink);
    const QStringList two = cell_lines(text, metrics, room, option.textElideMode);
    int top = cell.center().y() + 1 - px(kLine) * static_cast<int>(two.size()) / 2;
    for (const QString& line : two) {
      painter.drawText(QRect(cell.left(), top, cell.width(), px(kLine)), static_cast<int>(alignment | Qt::TextDontClip), line);
      top += px(kLine);
    }
    return;
  }
  const QString shown = metrics.elidedText(text, option.textElideMode, room);
  const int first_width = metrics.horizontalAdvance(shown);
  const bool at_right = right != rtl;
  int x = at_right ? cell.right() + 1 - first_width - gap - second_width : cell.left();
  painter.setLayoutDirection(Qt::LeftToRight);  // this function mirrors by itself
  const auto draw = [&](const QString& part, const QFont& f, const QColor& colour, int width) {
    painter.setFont(f);
    painter.setPen(colour);
    painter.drawText(QRect(x, cell.top(), width + px(2), cell.height()), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
                      part);
    x += width + gap;
  };
  // "7.5 mm ± 0.3" and "3 / 10" run from the left in every language.
  draw(shown, font, ink, first_width);
  if (!second.isEmpty()) draw(second, font_of(TextRole::body), t.text2, second_width);
}

}  // namespace

void TableDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const Tokens& t = tokens();
  painter->save();
  const bool chosen = option.state & QStyle::State_Selected;
  if (chosen) painter->fillRect(option.rect, t.accent_soft);
  const auto* view = qobject_cast<const QTableView*>(option.widget);
  if (!view || index.row() + 1 < index.model()->rowCount(index.parent())) {
    painter->fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), t.line);
  }
  const bool rtl = option.direction == Qt::RightToLeft;
  QRect cell = option.rect.adjusted(px(8), 0, -px(8), 0);
  const qreal ratio = painter->device()->devicePixelRatioF();
  const QString text = index.data(Qt::DisplayRole).toString();

  if (const QVariant chip = index.data(ChipRole); chip.isValid() && !text.isEmpty()) {
    const auto kind = static_cast<Chip::Kind>(chip.toInt());
    const QSize size = chip_size(text, kind);
    const int x = rtl ? cell.right() - size.width() + 1 : cell.left();
    paint_chip(*painter, QRect(QPoint(x, cell.top() + (cell.height() - size.height()) / 2), size), text, kind, t, ratio);
    painter->restore();
    return;
  }
  if (const QString name = index.data(IconRole).toString(); !name.isEmpty()) {
    const QVariant ink = index.data(IconInkRole);
    const int side = px(18);
    const bool alone = text.isEmpty();
    const int x = alone ? cell.center().x() - side / 2 : rtl ? cell.right() - side + 1 : cell.left();
    painter->drawPixmap(x, cell.top() + (cell.height() - side) / 2,
                        icon_pixmap(name, ink.isValid() ? static_cast<Ink>(ink.toInt()) : Ink::text2, 18, ratio));
    if (alone) {
      painter->restore();
      return;
    }
    cell.adjust(rtl ? 0 : px(26), 0, rtl ? -px(26) : 0, 0);
  }
  if (const QVariant share = index.data(ShareRole); share.isValid()) {
    const double width = px(44);
    const QVariant role = index.data(BarRole);
    const QFontMetrics bold(font_of(TextRole::body, Weight::bold));
    const int reserved = bold.horizontalAdvance(QStringLiteral("100 / 100")) + px(10);
    const double x = rtl ? cell.left() + reserved : cell.right() - reserved - width;
    paint_bar(*painter, QRectF(x, cell.center().y() - px(3) + 0.5, width, px(6)), share.toDouble(),
              colour_of(static_cast<Bar::Role>(role.toInt())), t.sunken);
  }
  draw_text(*painter, option, index, cell);
  painter->restore();
}

QSize TableDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const QString text = index.data(Qt::DisplayRole).toString();
  if (const QVariant chip = index.data(ChipRole); chip.isValid()) {
    return {chip_size(text, static_cast<Chip::Kind>(chip.toInt())).width() + px(16), px(36)};
  }
  const QFontMetrics metrics(font_of(TextRole::body, index.data(BoldRole).toBool() ? Weight::bold : Weight::regular));
  int width = metrics.horizontalAdvance(text) + px(18);
  const QString second = index.data(SecondRole).toString();
  if (!second.isEmpty()) width += metrics.horizontalAdvance(second) + px(4);
  if (!index.data(IconRole).toString().isEmpty()) width += text.isEmpty() ? px(16) : px(26);
  if (index.data(ShareRole).isValid()) width += px(64);
  Q_UNUSED(option);
  return {width, px(36)};
}

Table::Table(QWidget* parent) : QTableView(parent) {
  setItemDelegate(new TableDelegate(this));
  setSelectionBehavior(SelectRows);
  setSelectionMode(SingleSelection);
  setShowGrid(false);
  setFrameShape(QFrame::NoFrame);
  setEditTriggers(NoEditTriggers);
  setTabKeyNavigation(false);
  setWordWrap(false);
  setHorizontalScrollMode(ScrollPerPixel);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(px(36));
  verticalHeader()->setMinimumSectionSize(px(36));
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setResizeContentsPrecision(50);  // rows measured for a column's width: bounds the time for a long history
  horizontalHeader()->setDefaultAlignment(Qt::AlignLeading | Qt::AlignVCenter);
  horizontalHeader()->setMinimumSectionSize(px(32));
  horizontalHeader()->setMinimumHeight(px(34));
  connect(this, &QTableView::doubleClicked, this, &Table::row_opened);
  connect(horizontalScrollBar(), &QScrollBar::rangeChanged, this, [this] {
    if (rows_shown_ > 0) updateGeometry();
  });
}

void Table::setModel(QAbstractItemModel* model) {
  QTableView::setModel(model);
  if (!model) return;
  connect(model, &QAbstractItemModel::modelReset, this, [this] { updateGeometry(); });
  connect(model, &QAbstractItemModel::rowsInserted, this, [this] { updateGeometry(); });
  connect(model, &QAbstractItemModel::rowsRemoved, this, [this] { updateGeometry(); });
}

void Table::set_stretch_column(int column) {
  for (int i = 0; model() && i < model()->columnCount(); ++i) {
    horizontalHeader()->setSectionResizeMode(i, i == column ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
  }
  stretch_column_ = column;
}

void Table::updateGeometries() {
  QHeaderView* head = horizontalHeader();
  if (model() && stretch_column_ >= 0 && stretch_column_ < head->count()) {
    int others = 0;
    for (int i = 0; i < head->count(); ++i) others += i == stretch_column_ ? 0 : head->sectionSize(i);
    const bool fits = viewport()->width() - others >= px(kLeastName);
    const QHeaderView::ResizeMode mode = fits ? QHeaderView::Stretch : QHeaderView::Fixed;
    if (head->sectionResizeMode(stretch_column_) != mode) head->setSectionResizeMode(stretch_column_, mode);
    if (!fits && head->sectionSize(stretch_column_) != px(kLeastName)) head->resizeSection(stretch_column_, px(kLeastName));
  }
  QTableView::updateGeometries();
}

void Table::choose_row(int row) {
  if (!model() || row < 0 || row >= model()->rowCount()) return;
  // selectRow may select nothing in right-to-left.
  const QModelIndex index = model()->index(row, 0);
  selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
  selectionModel()->select(index, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

int Table::chosen_row() const {
  const QModelIndexList rows = selectionModel() ? selectionModel()->selectedRows() : QModelIndexList();
  return rows.isEmpty() ? -1 : rows.first().row();
}

void Table::set_rows_shown(int rows) {
  rows_shown_ = rows;
  setSizePolicy(QSizePolicy::Expanding, rows > 0 ? QSizePolicy::Fixed : QSizePolicy::Expanding);
  updateGeometry();
}

int Table::whole_width() const {
  int out = 2 * frameWidth();
  for (int i = 0; model() && i < model()->columnCount(); ++i) {
    if (!isColumnHidden(i)) out += std::max(sizeHintForColumn(i), horizontalHeader()->sectionSizeHint(i));
  }
  return out;
}

QSize Table::sizeHint() const {
  if (rows_shown_ <= 0) return QTableView::sizeHint();
  const int rows = std::clamp(model() ? model()->rowCount() : 0, 1, rows_shown_);
  const int bar = horizontalScrollBar()->maximum() > 0 ? horizontalScrollBar()->sizeHint().height() : 0;  // it covers no row
  return {px(400), horizontalHeader()->sizeHint().height() + rows * px(36) + bar + 2};
}
QSize Table::minimumSizeHint() const { return rows_shown_ > 0 ? QSize(px(200), sizeHint().height()) : QSize(px(200), px(110)); }

void Table::keyPressEvent(QKeyEvent* event) {
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && currentIndex().isValid()) {
    Q_EMIT row_opened(currentIndex());
    return;
  }
  const QPersistentModelIndex before = currentIndex();
  QTableView::keyPressEvent(event);
  if (before != currentIndex()) scroll_pages_to_current(*this, visualRect(currentIndex()).height() / 2);
}

}  // namespace cusp::ui
