/// A chip: an icon and a short text, so that no meaning lies in the colour alone. Thread: GUI.
#pragma once

#include <QWidget>

#include "ui/widgets/icon.h"

namespace cusp::ui {

class Chip : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { plain, good, look, bad, accent };
  explicit Chip(const QString& text = {}, Kind kind = Kind::plain, QWidget* parent = nullptr);
  void set(const QString& text, Kind kind);
  QString text() const { return text_; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QString text_;
  Kind kind_;
};

/// Name of a kind's icon, "" for plain; and its ink.
QString chip_icon(Chip::Kind kind);
Ink chip_ink(Chip::Kind kind);
QColor chip_fill(Chip::Kind kind, const Tokens& tokens = ui::tokens());
QSize chip_size(const QString& text, Chip::Kind kind);
void paint_chip(QPainter& painter, const QRect& rect, const QString& text, Chip::Kind kind, const Tokens& tokens,
                qreal device_pixel_ratio = 1.0);

}  // namespace cusp::ui
