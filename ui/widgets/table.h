/// Tables: rows of 36 px, numbers at the right, ± in text2. With wordWrap() a text takes two lines where one does not hold
/// it. Enter or a double click opens a row. Thread: GUI.
#pragma once

#include <QStyledItemDelegate>
#include <QTableView>

#include "ui/widgets/chip.h"

namespace cusp::ui {

/// Roles of a cell beyond Qt's own; TableDelegate draws them.
enum TableRole {
  SortRole = Qt::UserRole + 1,  // value to sort by
  SecondRole,                   // QString: drawn after the text, in text2 ("± 0.03")
  ChipRole,                     // int(Chip::Kind): the text is drawn as a chip
  ShareRole,                    // double in [0, 1]: a bar before the text
  BarRole,                      // int(Bar::Role)
  BoldRole,                     // bool
  QuietRole,                    // bool: text3
  IconRole,                     // QString: name of an icon before the text
  IconInkRole,                  // int(Ink)
};

/// The lines of a cell `width` px wide: one if the text fits or has no blank to break at, else two. What fits in no line is
/// elided.
QStringList cell_lines(const QString& text, const QFontMetrics& metrics, int width, Qt::TextElideMode elide);

class TableDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

class Table : public QTableView {
  Q_OBJECT

 public:
  explicit Table(QWidget* parent = nullptr);
  /// Column that takes the rest of the width. If the rest is below 140 px, the table scrolls sideways.
  void set_stretch_column(int column);
  /// Selects a row; selectRow() may fail in right-to-left. A row that does not exist changes nothing.
  void choose_row(int row);
  int chosen_row() const;
  /// The height follows the rows up to `rows`; more of them scroll.
  void set_rows_shown(int rows);
  /// The least width at which no cell is cut, px.
  int whole_width() const;
  void setModel(QAbstractItemModel* model) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// Enter or double click on a row.
  void row_opened(const QModelIndex& index);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void updateGeometries() override;

 private:
  int rows_shown_ = 0;
  int stretch_column_ = -1;
};

}  // namespace cusp::ui
