/// Exercises as cards in columns: picture, name, level, expected time, best result. The height follows the cards; the page scrolls. Arrow keys move,
/// Enter or a click opens. Thread: GUI.
#pragma once

#include <QImage>
#include <QListView>
#include <functional>

#include "ui/modules.h"

namespace cusp::ui {

class ExerciseCards : public QListView {
  Q_OBJECT

 public:
  /// Picture of a row; null while it is being drawn.
  using PictureOf = std::function<QImage(const QModelIndex&)>;
  explicit ExerciseCards(PictureOf picture_of, QWidget* parent = nullptr);
  void setModel(QAbstractItemModel* model) override;
  /// Draws the pictures anew that have come.
  void pictures_came();

 Q_SIGNALS:
  void opened(const QModelIndex& index);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

 private:
  /// Columns that fill the width, and the height of all rows.
  void fit();
};

}  // namespace cusp::ui
