#include "ui/student/exercise_cards.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyledItemDelegate>
#include <algorithm>

#include "ui/student/course.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kLeastWidth = 188, kGap = 12, kPictureHeight = 126, kTextHeight = 108;
constexpr int kCardHeight = kPictureHeight + kTextHeight;

class CardDelegate : public QStyledItemDelegate {
 public:
  CardDelegate(ExerciseCards::PictureOf picture_of, ExerciseCards* cards)
      : QStyledItemDelegate(cards), cards_(cards), picture_of_(std::move(picture_of)) {}

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return cards_->gridSize(); }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Tokens& t = tokens();
    const QRectF card = QRectF(option.rect).adjusted(1.5, 1.5, -px(kGap) + 0.5, -px(kGap) + 0.5);
    const bool hover = option.state & QStyle::State_MouseOver, current = option.state & QStyle::State_HasFocus;
    painter->save();
    painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    QPainterPath outline;
    outline.addRoundedRect(card, px(8), px(8));
    painter->fillPath(outline, hover ? t.hover : t.surface);
    paint_picture(*painter, card, outline, index);
    painter->setPen(QPen(current ? t.accent : t.line, current ? 2 : 1));
    painter->drawPath(outline);
    paint_text(*painter, card.toRect().adjusted(px(12), px(kPictureHeight + 8), -px(12), -px(10)), option.direction, index);
    painter->restore();
  }

 private:
  void paint_picture(QPainter& painter, const QRectF& card, const QPainterPath& outline, const QModelIndex& index) const {
    const QRectF place(card.left(), card.top(), card.width(), px(kPictureHeight));
    painter.save();
    painter.setClipPath(outline);
    painter.setClipRect(place, Qt::IntersectClip);
    const QImage image = picture_of_(index);
    if (image.isNull()) {
      paint_stand_in(painter, place, index.data(CourseModel::FdiRole).toInt());
    } else {
      // Covers the place and keeps its shape.
      const double scale = std::max(place.width() / image.width(), place.height() / image.height());
      const QSizeF part(place.width() / scale, place.height() / scale);
      painter.drawImage(place, image, QRectF(QPointF(0.5 * (image.width() - part.width()), 0.5 * (image.height() - part.height())), part));
    }
    painter.restore();
  }

  /// Until the picture is drawn: the tooth's number below its sign.
  static void paint_stand_in(QPainter& painter, const QRectF& place, int fdi) {
    const Tokens& t = tokens();
    painter.fillRect(place, t.sunken);
    const int side = px(28), below = fdi > 0 ? px(30) : 0;
    const QRectF sign(place.center() - QPointF(side / 2.0, (side + below) / 2.0), QSizeF(side, side));
    painter.drawPixmap(sign.toRect(), icon_pixmap(fdi > 0 ? u"tooth"_qs : u"target"_qs, Ink::text3, side, painter.device()->devicePixelRatioF()));
    if (fdi <= 0) return;
    painter.setFont(font_of(TextRole::live, Weight::bold));
    painter.setPen(t.text3);
    painter.drawText(QRectF(place.left(), sign.bottom(), place.width(), below), Qt::AlignCenter, QString::number(fdi));
  }

  static void paint_text(QPainter& painter, const QRect& place, Qt::LayoutDirection direction, const QModelIndex& index) {
    const Tokens& t = tokens();
    const bool mirrored = direction == Qt::RightToLeft;
    const QFont name_font = font_of(TextRole::body, Weight::bold);
    const QFontMetrics metrics(name_font, painter.device());
    painter.setFont(name_font);
    painter.setPen(t.text);
    int y = place.top();
    for (const QString& line : cell_lines(index.data().toString(), metrics, place.width(), Qt::ElideRight)) {
      painter.drawText(QRect(place.left(), y, place.width(), px(18)), (mirrored ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter, line);
      y += px(18);
    }
    painter.setFont(font_of(TextRole::caption));
    painter.setPen(t.text2);
    const QString level = index.data(CourseModel::LevelTextRole).toString();
    painter.drawText(QRect(place.left(), y, place.width(), px(18)), (mirrored ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter,
                     QFontMetrics(painter.font(), painter.device()).elidedText(level, Qt::ElideRight, place.width()));
    const QString standing = index.data(CourseModel::StandingRole).toString();
    const auto kind = static_cast<Chip::Kind>(index.data(CourseModel::StandingKindRole).toInt());
    const QSize size = chip_size(standing, kind);
    const QRect chip(mirrored ? place.right() - size.width() : place.left(), place.bottom() - size.height() + 1, size.width(), size.height());
    paint_chip(painter, chip, standing, kind, t, painter.device()->devicePixelRatioF());
  }

  const ExerciseCards* cards_;
  ExerciseCards::PictureOf picture_of_;
};

}  // namespace

ExerciseCards::ExerciseCards(PictureOf picture_of, QWidget* parent) : QListView(parent) {
  setViewMode(QListView::IconMode);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setUniformItemSizes(true);
  setFrameShape(QFrame::NoFrame);
  setSelectionMode(QAbstractItemView::NoSelection);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setMouseTracking(true);
  set_kind(this, "cards");
  setProperty("no_focus_ring", true);  // the current card has it
  setItemDelegate(new CardDelegate(std::move(picture_of), this));
  connect(this, &QListView::clicked, this, &ExerciseCards::opened);
}

void ExerciseCards::setModel(QAbstractItemModel* model) {
  QListView::setModel(model);
  for (const auto changed : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved}) connect(model, changed, this, &ExerciseCards::fit);
  connect(model, &QAbstractItemModel::layoutChanged, this, &ExerciseCards::fit);
  connect(model, &QAbstractItemModel::modelReset, this, &ExerciseCards::fit);
  fit();
}

void ExerciseCards::pictures_came() { viewport()->update(); }

void ExerciseCards::fit() {
  if (model() == nullptr) return;
  const int gap = px(kGap), width = viewport()->width();
  const int columns = std::max(1, (width + gap) / (px(kLeastWidth) + gap));
  setGridSize({std::max(1, (width - 1) / columns), px(kCardHeight) + gap});
  const int rows = (model()->rowCount() + columns - 1) / columns;
  setFixedHeight(std::max(rows, 1) * gridSize().height());
}

void ExerciseCards::resizeEvent(QResizeEvent* event) {
  QListView::resizeEvent(event);
  fit();
}

void ExerciseCards::keyPressEvent(QKeyEvent* event) {
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && currentIndex().isValid()) {
    Q_EMIT opened(currentIndex());
    return;
  }
  const QPersistentModelIndex before = currentIndex();
  QListView::keyPressEvent(event);
  if (before != currentIndex()) scroll_pages_to_current(*this, 0);
}

void ExerciseCards::focusInEvent(QFocusEvent* event) {
  if (!currentIndex().isValid() && model() != nullptr && model()->rowCount() > 0) setCurrentIndex(model()->index(0, 0));
  QListView::focusInEvent(event);
}

}  // namespace cusp::ui
